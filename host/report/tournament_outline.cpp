// SPDX-License-Identifier: MIT
#include "report/tournament_outline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "config/flow.hpp"
#include "config/scalar.hpp"
#include "config/values.hpp"
#include "report/configuration_difference.hpp"
#include "report/elo_interval.hpp"
#include "report/match_remarks.hpp"
#include "report/number.hpp"
#include "report/standing.hpp"
#include "report/tournament_verdict.hpp"
#include "texts/json.hpp"
#include "texts/message.hpp"

namespace regista::report {
namespace {

std::string elo_tile(const statistics::Estimate& elo, IntervalUse use) {
  if (!std::isfinite(elo.value)) return elo.value > 0.0 ? "above all scales" : "below all scales";
  const std::string value = with_sign(elo.value, 0);
  return use == IntervalUse::shown ? fmt::format("{} ± {:.0f}", value, elo.margin()) : value;
}

const char* elo_caption(IntervalUse use) {
  switch (use) {
    case IntervalUse::shown:
      return "Elo, with the margin that holds with 95 %";
    case IntervalUse::too_few_pairs:
      return "Elo; too few pairs for an interval";
    case IntervalUse::not_at_its_end:
      return "Elo so far";
    case IntervalUse::biased:
      return "Elo, biased towards the verdict";
    case IntervalUse::contradicted:
    case IntervalUse::unbounded:
      break;
  }
  return "Elo";
}

std::vector<Tile> tiles_of(const TournamentView& view) {
  std::vector<Tile> out;
  const study::Meeting& meeting = view.course.meetings().front();
  const std::optional<Strength> known = strength(view.course, meeting);
  if (view.plan.teams.size() == 2 && known) {
    const auto& [losses, draws, wins] = meeting.games.seen;
    const double share = points(meeting.games) / static_cast<double>(meeting.matches());
    const IntervalUse use = interval_use(view, 0);
    out.push_back({elo_tile(known->elo, use), elo_caption(use)});
    out.push_back({fmt::format("{:.1f} %", 100.0 * share),
                   fmt::format("of the points, {:.1f} of {}", points(meeting.games), meeting.matches())});
    out.push_back({fmt::format("{} – {} – {}", wins, draws, losses), "won – drawn – lost"});
    out.push_back({fmt::format("{} : {}", meeting.goals[0], meeting.goals[1]), "goals"});
    if (use == IntervalUse::shown) {
      out.push_back({fmt::format("{:.1f} %", 100.0 * known->superiority),
                     Sentence("probability that ") << named(view.label(0)) << " is the stronger one (LOS)"});
    }
  } else {
    out.push_back({std::to_string(view.plan.teams.size()), "teams"});
    out.push_back({std::to_string(view.course.calendar().pairings().size()), "pairings"});
  }
  out.push_back(
      {std::to_string(view.course.matches()), fmt::format("matches of {} planned", view.course.calendar().matches())});
  return out;
}

// Pair k plays the k-th scene, so few pairs leave scenes out; under a sequential test each is drawn from all.
std::string openings_text(const study::TournamentPlan& plan, std::size_t all) {
  const bool in_order = std::holds_alternative<study::FixedNumber>(plan.objective());
  if (in_order && plan.pairs() < all) return fmt::format("the first {} of {} openings", plan.pairs(), all);
  return texts::counted(all, "opening", "openings");
}

}  // namespace

const char* name(study::Verdict verdict) {
  switch (verdict) {
    case study::Verdict::none:
      return "";
    case study::Verdict::inconclusive:
      return "INCONCLUSIVE";
    case study::Verdict::accept_h0:
      return "H0";
    case study::Verdict::accept_h1:
      return "H1";
    case study::Verdict::prevented:
      return "NO_VERDICT";
  }
  return "";
}

WhatWasPlayed what_was_played(const study::TournamentPlan& plan) {
  std::vector<campaign::Input> openings;
  for (const study::Opening& each : plan.openings) openings.push_back(each.input);
  WhatWasPlayed out = what_was_played(plan.asked.settings, plan.common_inputs, openings);
  for (std::size_t team = 0; team < plan.teams.size(); ++team) {
    const config::Tournament::Team& asked = plan.asked.teams[team];
    const study::Entrant& found = plan.teams[team];
    const auto& disturbances = found.disturbances.empty() ? plan.common_inputs : found.disturbances;
    out.teams.push_back(
        played_team(found.label, asked.team, found.inputs,
                    profile_of(disturbances, "home disturbance",
                               asked.disturbance.empty() ? plan.asked.disturbance : asked.disturbance)));
  }
  for (const config::Node::Entry& each : plan.asked.settings.set.entries()) {
    const std::optional<std::size_t> team = study::team_meant(plan, each.key);
    const std::string path = team ? each.key.substr(std::min<std::size_t>(2, each.key.size())) : each.key;
    (team ? out.teams[*team].set : out.set).push_back(path + '=' + config::flow(each.value));
  }
  const bool one = plan.pairings().size() == 1;
  out.amount = fmt::format("{}{}{}, seeds from {}", plan.asked.pairs ? "" : "a test decides, at most ",
                           texts::counted(plan.pairs(), "pair", "pairs"),
                           one ? std::string() : fmt::format(" of each of {} pairings", plan.pairings().size()),
                           plan.first_seed());
  complete(out, plan);
  return out;
}

std::string title(const TournamentView& view) {
  const std::string who =
      view.plan.teams.size() == 2
          ? fmt::format("{} vs {}", view.label(0), view.label(1))
          : fmt::format("{} teams, {}", view.plan.teams.size(),
                        view.plan.asked.format == config::Tournament::Format::gauntlet ? "gauntlet" : "round robin");
  const std::size_t pairings = view.course.calendar().pairings().size();
  const std::uint64_t played = view.course.taken() / 2 / pairings;  // teams that were set aside on the way included
  std::string out = fmt::format("{} ({}", who, texts::counted(played, "pair", "pairs"));
  if (played < view.plan.pairs()) out += fmt::format(" of {}", view.plan.pairs());
  if (pairings > 1) out += " each";
  out += fmt::format(", seeds from {}", view.plan.first_seed());
  if (const std::size_t all = view.plan.openings.size(); all > 0) out += ", " + openings_text(view.plan, all);
  if (const auto& limit = view.plan.asked.settings.limit)
    out += fmt::format(", {} s a match", config::real_text(*limit));
  return out + ')';
}

std::string scene_of(const TournamentView& view, const study::Fixture& fixture) {
  if (view.plan.openings.empty()) return {};
  return std::filesystem::path(view.plan.openings[fixture.opening].file).stem().string();
}

ForfeitWords forfeit_words(const TournamentView& view) {
  return {[&view](std::size_t team) { return view.label(team); }, view.again, {}};
}

Outline tournament_outline(const TournamentView& view, const TournamentPage* page) {
  Outline out;
  out.kind = "Tournament";
  out.title = title(view);
  out.name = view.plan.asked.name;
  out.question = view.plan.asked.question;
  TournamentVerdict verdict = tournament_verdict(view);
  out.headline = std::move(verdict.sentence);
  out.beside = std::move(verdict.beside);
  out.tiles = tiles_of(view);
  out.played = what_was_played(view.plan);
  out.remarks = view.course.remarks();
  out.data = [view] { return tournament_data(view); };
  out.add(standing_section(view));
  out.add(curves_section(view));
  if (page != nullptr) {
    out.add(goals_section(view, page->record));
    out.add(roles_section(view, page->record, page->metrics));
  }
  out.add(packets_section(view, page != nullptr ? &page->record : nullptr));
  if (page != nullptr) out.add(plugins_section(view, page->record));
  out.add(variance_section(view));
  out.add(unplayed_section(view.course.unplayed_pairs(), view.course.remarks()));
  out.add(forfeits_section(view.course.forfeits(), forfeit_words(view)));
  if (page == nullptr) return out;
  out.fingerprint = page->record.fingerprint();
  out.add(recordings_section(view, page->recordings, page->link_to));
  out.add(configuration_section(page->documents, out.played.teams));
  return out;
}

}  // namespace regista::report
