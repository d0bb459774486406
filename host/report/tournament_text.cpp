// SPDX-License-Identifier: MIT
// A tournament as text. Its estimates with their intervals are written by estimate_text.cpp.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "config/flow.hpp"
#include "config/scalar.hpp"
#include "config/values.hpp"
#include "report/estimate_text.hpp"
#include "report/few_uneven.hpp"
#include "report/match_remarks.hpp"
#include "report/number.hpp"
#include "report/packets_spent.hpp"
#include "report/standing.hpp"
#include "report/tournament.hpp"
#include "report/verdict_sentence.hpp"
#include "statistics/sequential_bounds.hpp"
#include "texts/message.hpp"
#include "texts/visible.hpp"

namespace regista::report {
namespace {

using study::Meeting;

std::string or_none(const std::optional<double>& number) { return number ? fmt::format("{:.2f}", *number) : "-"; }

double percent(double part, double whole) { return whole == 0.0 ? 0.0 : 100.0 * part / whole; }

std::string score_test_text(const statistics::SequentialTest<statistics::PairCounts>& test) {
  const statistics::SequentialBounds bounds = test.bounds();
  const double llr = test.ratio().value;
  const auto& hypotheses = test.design().hypotheses;
  return fmt::format("LLR: {} ({} %) ({:.2f}, {:.2f}) [{}, {}] {}{}, stops at {} or {}\n", fixed(llr, 2),
                     fixed(percent(llr, llr < 0.0 ? -bounds.lower : bounds.upper), 1), bounds.lower, bounds.upper,
                     fixed(hypotheses.elo0, 2), fixed(hypotheses.elo1, 2), name(test.design().model),
                     test.ratio().method == statistics::Method::closed_form ? ", approximate" : "",
                     fixed(test.stopping().lower, 2), fixed(test.stopping().upper, 2));
}

std::string metric_text(const TournamentView& view, const Meeting& meeting, const study::ValueTest& test) {
  const study::MetricDifference& metric = *meeting.metric;
  const statistics::Estimate estimate = metric.estimate();
  std::string out = fmt::format("{}: {:.4g} and {:.4g} per match, difference {:+.4g} [{:.4g}, {:.4g}], approximately\n",
                                test.value, metric.first().mean(), metric.second().mean(), estimate.value,
                                estimate.interval.low, estimate.interval.high);
  const auto& [less, equal, more] = metric.signs();
  out += fmt::format("{} has less in {}, as much in {}, more in {} pairs, p at any time {:.2g}\n",
                     view.label(meeting.pairing.first), less, equal, more, metric.test().p());
  if (meeting.pairs_without_metric > 0) {
    out += fmt::format("{} without it: a match was forfeited, or has no such number\n",
                       texts::counted(meeting.pairs_without_metric, "pair", "pairs"));
  }
  return out;
}

// What holds only for a number of pairs that nobody chose by looking may be said; of a pairing only where all of them
// could be played.
bool fixed_number_is_played(const TournamentView& view) {
  return std::holds_alternative<study::FixedNumber>(view.plan.objective()) && view.course.complete();
}

// Fastchess's block, and goals.
std::string meeting_text(const TournamentView& view, const Meeting& meeting) {
  std::string out;
  const std::optional<Strength> known = strength(view.course, meeting);
  if (known) {
    out += fmt::format("Elo: {}, nElo: {}\n", with_margin(known->elo), with_margin(known->normalized_elo));
    out += fmt::format("LOS: {:.2f} %, DrawRatio: {:.2f} %, PairsRatio: {}\n", 100.0 * known->superiority,
                       100.0 * known->draw_ratio, or_none(known->pair_ratio));
  }
  const auto& [losses, draws, wins] = meeting.games.seen;
  out += fmt::format("Games: {}, Wins: {}, Losses: {}, Draws: {}, Points: {:.1f} ({:.2f} %)\n", meeting.matches(), wins,
                     losses, draws, points(meeting.games),
                     percent(points(meeting.games), static_cast<double>(meeting.matches())));
  out += fmt::format("Ptnml(0-2): [{}]\n", fmt::join(meeting.pairs.seen, ", "));
  if (meeting.score_test) {
    out += score_test_text(*meeting.score_test);
    if (const std::string few = known ? what_the_test_rests_on(known->law) : ""; !few.empty()) out += few + '\n';
  }
  out += fmt::format("Goals: {}:{}", meeting.goals[0], meeting.goals[1]);
  if (known) {
    const statistics::Interval interval = meeting.goals_sequence.interval();
    out += fmt::format(", per match {} {} at any time", with_sign(meeting.goals_of_pairs.mean(), 3),
                       interval_text(interval, 3));
    if (fixed_number_is_played(view) && known->goals_t && meeting.unplayed_pairs == 0) {
      out += fmt::format(", {} for this number of pairs (t test: p {:.2g})", interval_text(known->goals_t->interval, 3),
                         known->goals_t->p);
    }
    out += fmt::format("\nVariance ratio of pairing: {} of scores, {} of goals\n", or_none(known->score_ratio),
                       or_none(known->goals_ratio));
  } else {
    out += '\n';
  }
  if (meeting.metric) out += metric_text(view, meeting, std::get<study::ValueTest>(view.plan.objective()));
  return out;
}

std::string ranking_text(const TournamentView& view) {
  std::size_t widest = 4;
  for (const study::Entrant& team : view.plan.teams) widest = std::max(widest, team.label.size());
  std::string out = fmt::format("{:>4}  {:{}}  {:>16}  {:>6}  {:>7}  {:>8}  {:>5} {:>5} {:>5}  {:>9}  {:>8}\n", "rank",
                                "team", widest, "Elo", "Nash", "games", "points", "W", "D", "L", "goals", "failures");
  int rank = 0;
  bool without = false;
  for (const Ranked& team : ranking(view.plan, view.course)) {
    without = without || (team.elo && !team.elo->interval.bounded());
    const std::string elo = !team.elo ? "-"
                            : team.elo->interval.bounded()
                                ? fmt::format("{} +/- {:.1f}", fixed(team.elo->value, 1), team.elo->margin())
                                : fixed(team.elo->value, 1);
    out += fmt::format("{:>4}  {:{}}  {:>16}  {:>6.2f}  {:>7}  {:>8.1f}  {:>5} {:>5} {:>5}  {:>9}  {:>8}\n", ++rank,
                       view.label(team.team), widest, elo, team.nash, team.matches, team.points, team.wins, team.draws,
                       team.losses, fmt::format("{}:{}", team.scored, team.conceded), team.failures);
  }
  return without ? out + no_margin_of_team() + '\n' : out;
}

std::string pairings_text(const TournamentView& view) {
  const bool with_p = fixed_number_is_played(view);
  std::string out = with_p ? "\nPairings (p: two-sided, by the signs of pairs, adjusted by Holm):\n" : "\nPairings:\n";
  const PValues p = p_values(view.course);
  for (std::size_t i = 0; i < p.adjusted.size(); ++i) {
    const Meeting& meeting = view.course.meetings()[i];
    const auto& [losses, draws, wins] = meeting.games.seen;
    const std::optional<Strength> known = strength(view.course, meeting);
    out += fmt::format("{} vs {}: {}-{}-{}, goals {}:{}, Elo {}", view.label(meeting.pairing.first),
                       view.label(meeting.pairing.second), wins, draws, losses, meeting.goals[0], meeting.goals[1],
                       known ? with_margin(known->elo) : "-");
    if (meeting.unplayed_pairs > 0) out += fmt::format(", {} not played", pairs_in_words(meeting.unplayed_pairs));
    if (with_p) out += fmt::format(", p {:.2g}", p.adjusted[i]);
    out += with_p && p.prevented[i] ? ": no verdict\n" : "\n";
  }
  return out;
}

// Of games that are shorter than a match, whose budget is that of a whole one.
std::string packets_text(const TournamentView& view) {
  std::string out;
  bool overspent = false;
  for (std::size_t team = 0; team < view.plan.teams.size(); ++team) {
    const study::PacketsSpent packets = view.course.packets(team);
    const std::string clause = packets_clause(packets, OverspentMark::loud);
    if (!clause.empty()) out += fmt::format("{} {}\n", view.label(team), clause);
    overspent = overspent || (packets.games() > 0 && packets.overspent());
  }
  if (overspent) {
    out +=
        "Who has overspent could not go on like this for a whole match. With --set rules.messages.short_games=share a "
        "short "
        "game has its share of the packets.\n";
  }
  return view.plan.teams.size() > 2 && !out.empty() ? '\n' + out : out;
}

constexpr auto bias = "The estimates above are biased towards the verdict, because the test chose when to stop.\n";

std::string score_verdict(const study::ScoreTest& test, study::Verdict verdict) {
  const auto& [elo0, elo1] = test.design.hypotheses;
  const bool h1 = verdict == study::Verdict::accept_h1;
  return fmt::format(": the scores speak for a strength of {} rather than {} {}\n", h1 ? elo1 : elo0, h1 ? elo0 : elo1,
                     test.design.model == statistics::Model::logistic ? "Elo" : "nElo");
}

std::string value_verdict(const TournamentView& view, const std::string& value) {
  const Meeting& meeting = view.course.meetings().front();
  const std::string &a = view.label(meeting.pairing.first), &b = view.label(meeting.pairing.second);
  const bool more = view.course.first_has_more();
  if (value == study::goals_value) return fmt::format(": {} scores {} goals than {}\n", a, more ? "more" : "fewer", b);
  std::string out = fmt::format(": in a pair {} mostly has {} {} than {}\n", a, more ? "more" : "less", value, b);
  // The test is one of signs; a few large differences can carry the mean to the other side.
  if ((meeting.metric->difference().mean() > 0.0) != more) {
    out += fmt::format("But its mean is the {} one: a few pairs differ much the other way.\n",
                       more ? "smaller" : "larger");
  }
  return out;
}

std::string verdict_text(const TournamentView& view) {
  const study::Verdict verdict = view.course.verdict();
  if (verdict == study::Verdict::prevented) return "";  // the sentence below says all
  if (verdict == study::Verdict::none) return "";
  const statistics::Count pairs = total(view.course.meetings().front().pairs);
  std::string out = fmt::format("Verdict after {}: {}",
                                texts::counted(static_cast<std::uint64_t>(pairs), "pair", "pairs"), name(verdict));
  if (verdict == study::Verdict::inconclusive) return out + '\n';
  const study::Objective objective = view.plan.objective();
  const auto* const score = std::get_if<study::ScoreTest>(&objective);
  out += score != nullptr ? score_verdict(*score, verdict)
                          : value_verdict(view, std::get<study::ValueTest>(view.plan.objective()).value);
  return out + bias;
}

std::string failures_text(const TournamentView& view) {
  std::string out;
  for (const study::SetAside& each : view.course.set_aside()) {
    out += fmt::format("{} was set aside after pair {}: {} failed {} times in a row\n", view.label(each.team),
                       each.pair + 1, plugin_text(each.plugin, view.label(each.team)), each.failures);
  }
  for (const study::Forfeits& each : view.course.forfeits()) {
    out += fmt::format("{} {}\n  the first again: {}\n", texts::counted(each.count, "match", "matches"),
                       forfeit_text(view.label(each.team), each.failure), view.again(each.first_match));
  }
  if (const std::uint64_t more = view.course.unlisted_forfeits(); more > 0) {
    out += texts::counted(more, "more match", "more matches") + " forfeited for other reasons\n";
  }
  return out.empty() ? "" : '\n' + out;
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

std::string plugin_text(const std::string& plugin, const std::string& team) {
  return plugin.empty() ? "a plugin of " + team : "plugin " + plugin;
}

std::string forfeit_text(const std::string& label, const campaign::Failure& failure) {
  std::string out = fmt::format("forfeited by {}: {}", label, plugin_text(failure.plugin, label));
  if (!failure.call.empty()) out += ", " + failure.call;
  return texts::one_line(out + ": " + failure.what);
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
  const std::uint64_t played = view.course.taken() / 2 / pairings;  // whoever was set aside on the way
  std::string out = fmt::format("{} ({}", who, texts::counted(played, "pair", "pairs"));
  if (played < view.plan.pairs()) out += fmt::format(" of {}", view.plan.pairs());
  if (pairings > 1) out += " each";
  out += fmt::format(", seeds from {}", view.plan.first_seed());
  if (const std::size_t all = view.plan.openings.size(); all > 0) out += ", " + openings_text(view.plan, all);
  if (const auto& limit = view.plan.asked.settings.limit)
    out += fmt::format(", {} s a match", config::real_text(*limit));
  return out + ')';
}

std::string standing_text(const TournamentView& view) {
  if (is_without_verdict(view.plan, view.course)) return {};
  return view.plan.teams.size() == 2 ? meeting_text(view, view.course.meetings().front()) : ranking_text(view);
}

std::string tournament_text(const TournamentView& view) {
  std::string out = doubts_text(view.course.remarks());
  if (!view.plan.asked.question.empty())
    out += fmt::format("{}: {}\n", texts::visible(view.plan.asked.name), texts::visible(view.plan.asked.question));
  out += fmt::format("Results of {}:\n", title(view));
  out += played_text(what_was_played(view.plan));
  for (const study::Pairing& pairing : view.course.calendar().pairings()) {
    if (study::equal_teams(view.plan, pairing)) {
      out += fmt::format("A/A: {} and {} are equal, so every pair is a draw by construction\n",
                         view.label(pairing.first), view.label(pairing.second));
    }
  }
  out += standing_text(view);
  if (view.plan.teams.size() > 2 && !is_without_verdict(view.plan, view.course)) out += pairings_text(view);
  out += packets_text(view);
  if (!view.plan.pairs_before.empty()) out += more_pairs_sentence(view.plan.pairs_before) + '\n';
  if (const std::uint64_t unplayed = view.course.unplayed_pairs(); unplayed > 0) {
    out += unplayed_sentence(unplayed) + '\n' + unplayed_text(view.course.remarks());
  }
  out += verdict_text(view) + failures_text(view) + notes_text(view.course.remarks());
  return out + '\n' + texts::plain(verdict_sentence(view).sentence) + '\n';
}

}  // namespace regista::report
