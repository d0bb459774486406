// SPDX-License-Identifier: MIT
#include "report/tournament_report.hpp"

#include <fmt/compile.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <utility>

#include "config/node.hpp"
#include "config/scalar.hpp"
#include "config/values.hpp"
#include "process/child.hpp"
#include "report/matches_section.hpp"
#include "report/number.hpp"
#include "report/standing.hpp"
#include "report/what_was_played.hpp"
#include "study/study.hpp"
#include "texts/json.hpp"
#include "texts/message.hpp"

namespace regista::report {
namespace {

namespace fs = std::filesystem;

// Returns the ascending indices (in the schedule) of matches with a recording file. Does not read these files.
std::vector<std::uint64_t> recorded(const fs::path& results) {
  std::vector<std::uint64_t> out;
  for (const std::uint64_t row : numbered_files(study::recording_folder(results), ".mcap")) {
    if (row > 0) out.push_back(row - 1);
  }
  return out;
}

class TournamentReport final : public StudyReport {
 public:
  TournamentReport(study::TournamentPlan plan, CommandOf again)
      : plan_(std::move(plan)), course_(plan_), again_(std::move(again)) {}

  study::Study& study() override { return course_; }
  const study::Study& study() const override { return course_; }

  std::vector<std::string> teams() const override { return texts::names_of(plan_.teams, &study::Entrant::shown); }
  WhatWasPlayed played() const override { return what_was_played(plan_); }
  Outline outline() const override { return tournament_outline(view()); }
  Outline page_outline(const PageFiles& files) const override {
    const auto link = [&files](std::uint64_t match) {
      const fs::path file = study::recording_file(files.results, static_cast<std::int64_t>(match) + 1);
      const std::string from_page =
          fs::absolute(file).lexically_relative(fs::absolute(files.page).parent_path()).generic_string();
      const std::string shown = study::beside(files.results, fmt::format("-{}.html", match + 1)).filename().string();
      return RecordingLink{from_page,
                           process::command_line({"view", as_argument(from_page), "-o", as_argument(shown)})};
    };
    const TournamentView view = this->view();
    const TournamentPage page{*record_, files.documents, page_recordings(view, *record_, files.results), link};
    return tournament_outline(view, &page);
  }
  void end_after(std::uint64_t pairs) override { plan_.ended_after = pairs; }
  std::vector<std::string> notes() const override {
    std::vector<std::string> out;
    for (const study::Pairing& pairing : course_.calendar().pairings()) {
      if (!study::equal_teams(plan_, pairing)) continue;
      out.push_back(fmt::format("A/A: {} and {} are equal, so every pair is a draw by construction",
                                plan_.teams[pairing.first].shown(), plan_.teams[pairing.second].shown()));
    }
    add_notes_on_pairs(plan_, out);
    return out;
  }
  std::string standing() const override { return fmt::format("{}\n{}", title(view()), standing_text(view())); }
  std::string match(const study::Round& round, std::uint64_t index,
                    const campaign::MatchResult& decided) const override {
    const auto& [sides, scene, seed] = players(round, index);
    return fmt::format("seed {}{}{}: {} {}:{} {}", seed, scene.empty() ? "" : ", ", scene, sides[0], decided.score[0],
                       decided.score[1], sides[1]) +
           how_it_ended(decided, sides);
  }
  MatchPlayers players(const study::Round& round, std::uint64_t index) const override {
    const study::Fixture fixture = course_.calendar().at(round.first_row + index);
    return {{plan_.teams[fixture.home].shown(), plan_.teams[fixture.away].shown()},
            scene_name(plan_.openings, fixture.opening),
            fixture.seed};
  }

  std::string incomplete() const override {
    if (course_.complete()) return {};
    return course_.so_far(course_.matches()) + " without a gap: the tournament is not at its end";
  }

  bool has_a_column_for_each_metric() const override { return true; }
  std::string begin_table(const TableOptions& options) override {
    columns_ = match::MetricColumns(options.all_metrics ? options.metrics : csv_metrics(plan_));
    return csv_head(columns_.paths());
  }
  std::string table_lines(const study::Round& round, std::uint64_t index,
                          const campaign::MatchResult& decided) override {
    return csv_line(view(), round.first_row + index, decided, columns_);
  }

  campaign::Metrics page_metrics() const override { return campaign::Metrics::wanted; }
  void begin_page(const fs::path& results) override { record_.emplace(plan_, course_, recorded(results)); }
  void take(const study::Round& /*round*/, std::uint64_t /*index*/, const campaign::MatchResult* decided) override {
    record_->take(decided);
  }
  void end_page() override { record_->end(); }
  std::vector<Figure> figures() const override { return tournament_figures(view(), *record_); }

 private:
  campaign::Job job(std::uint64_t index) const { return study::job(plan_, course_.calendar().at(index)); }
  TournamentView view() const {
    return {plan_, course_, [this](std::uint64_t index) { return again_(job(index)); }};
  }

  study::TournamentPlan plan_;
  study::Tournament course_;
  CommandOf again_;
  match::MetricColumns columns_;  // columns of the table in progress
  std::optional<TournamentHistory> record_;
};

std::vector<Tile> tiles_of(const TournamentView& view) {
  std::vector<Tile> out;
  const study::Meeting& meeting = view.course.meetings().front();
  const std::optional<Strength> known = strength(view.course, meeting);
  if (view.plan.teams.size() == 2 && known) {
    const auto& [losses, draws, wins] = meeting.games.seen;
    const double share = points(meeting.games) / static_cast<double>(meeting.matches());
    const double goals = meeting.goals_of_pairs.mean();
    const bool with_margin = known->goals_t && is_of_fixed_number(view.plan, view.course);
    const double margin = with_margin ? half_width(known->goals_t->interval) : 0.0;
    out.push_back({with_margin ? fmt::format("{} ± {}", rounded_with_sign(goals, margin), rounded(margin, margin))
                               : with_sign(goals, 2),
                   fmt::format("goals a {}{}", game_word(view.plan), with_margin ? ", with a margin of 95 %" : "")});
    out.push_back({fmt::format("{:.1f} %", 100.0 * share),
                   fmt::format("of the points, {:.1f} of {}", points(meeting.games), meeting.matches())});
    out.push_back({fmt::format("{} – {} – {}", wins, draws, losses), "won – drawn – lost"});
    out.push_back({fmt::format("{} : {}", meeting.goals[0], meeting.goals[1]), "goals"});
  } else {
    out.push_back({std::to_string(view.plan.teams.size()), "teams"});
    const std::uint64_t rounds = view.plan.rounds();
    out.push_back(rounds > 0 ? Tile{std::to_string(rounds), "rounds"}
                             : Tile{std::to_string(view.course.calendar().pairings().size()), "pairings"});
  }
  std::string games = games_in_words(view.plan.openings);
  if (view.plan.open_end().empty()) games += fmt::format(" of {} planned", view.course.calendar().matches());
  out.push_back({std::to_string(view.course.matches()), games});
  return out;
}

// Describes the scenes. With a fixed number of pairs, pair k plays scene k, so that fewer pairs than scenes play only
// the first scenes. A sequential test draws the scenes at random.
std::string scenes_text(const study::TournamentPlan& plan) {
  const bool in_order = std::holds_alternative<study::FixedNumber>(plan.objective());
  const std::uint64_t pairs = plan.pairs_to_its_end();
  const std::string all = scenes_in_words(plan.openings, plan.asked.settings.limit);
  return in_order && pairs < plan.openings.size() ? fmt::format("the first {} of {}", pairs, all) : all;
}

// Returns the name of the figure with the numbers that decide the tournament; empty without a verdict.
std::string lead_of(const TournamentView& view) {
  if (is_without_verdict(view.plan, view.course)) return {};
  if (view.plan.teams.size() > 2) return "ranking";
  const study::Objective objective = view.plan.objective();
  if (std::holds_alternative<study::ScoreTest>(objective)) return "llr";
  return std::holds_alternative<study::ValueTest>(objective) ? "value" : "goal_differences";
}

Json score_test(const statistics::SequentialTest& test) {
  const auto& design = test.design();
  return {{"model", name(design.model)},
          {"elo0", design.hypotheses.elo0},
          {"elo1", design.hypotheses.elo1},
          {"alpha", design.rates.alpha},
          {"beta", design.rates.beta},
          {"llr", test.ratio().value},
          {"llr_bounds", {test.bounds().lower, test.bounds().upper}},
          {"llr_stopping", {test.stopping().lower, test.stopping().upper}}};
}

Json metric(const study::Meeting& meeting, const study::ValueTest& test) {
  const study::MetricDifference& metric = *meeting.metric;
  const statistics::Estimate estimate = metric.estimate();
  return {{"name", test.value},
          {"alpha", test.alpha},
          {"means", {metric.first().mean(), metric.second().mean()}},
          {"difference", estimate.value},
          {"interval", json_of(estimate.interval)},
          {"pairs_less_equal_more", metric.signs()},
          {"p", metric.test().p()},
          {"pairs_without", meeting.pairs_without_metric}};
}

// p, and p adjusted by Holm's method. Both are missing unless the fixed number of pairs has been played.
using Chance = std::pair<std::optional<double>, std::optional<double>>;

Json meeting_json(const TournamentView& view, const study::Meeting& meeting, const Chance& p) {
  Json out;
  out["teams"] = {view.label(meeting.pairing.first), view.label(meeting.pairing.second)};
  out["equal_teams"] = study::equal_teams(view.plan, meeting.pairing);
  out["games"] = meeting.matches();
  out["wins"] = meeting.games.seen[2];
  out["losses"] = meeting.games.seen[0];
  out["draws"] = meeting.games.seen[1];
  out["points"] = points(meeting.games);
  out["pentanomial"] = meeting.pairs.seen;
  out["unplayed_pairs"] = meeting.unplayed_pairs;
  out["goals"] = meeting.goals;
  if (const std::optional<Strength> known = strength(view.course, meeting)) {
    out["elo"] = known->elo.value;
    out["elo_interval"] = json_of(known->elo.interval);
    out["nelo"] = known->normalized_elo.value;
    out["nelo_interval"] = json_of(known->normalized_elo.interval);
    out["los"] = json_or_null(known->superiority);
    out["p"] = json_or_null(p.first);
    out["p_holm"] = json_or_null(p.second);
    out["pair_ratio"] = json_or_null(known->pair_ratio);
    out["variance_ratio"] = {{"scores", json_or_null(known->score_ratio)}, {"goals", json_or_null(known->goals_ratio)}};
    Json goals{{"mean", meeting.goals_of_pairs.mean()},
               {"standard_deviation", meeting.goals_of_pairs.standard_deviation()},
               {"confidence_sequence", json_of(meeting.goals_sequence.interval())}};
    goals["t_interval"] = p.first && known->goals_t ? json_of(known->goals_t->interval) : Json(nullptr);
    out["goals_per_match"] = goals;
  }
  if (meeting.score_test) out["sprt"] = score_test(*meeting.score_test);
  if (meeting.metric) out["metric"] = metric(meeting, std::get<study::ValueTest>(view.plan.objective()));
  return out;
}

}  // namespace

std::unique_ptr<StudyReport> tournament_report(study::TournamentPlan plan, CommandOf again) {
  return std::make_unique<TournamentReport>(std::move(plan), std::move(again));
}

match::MetricPaths csv_metrics(const study::TournamentPlan& plan) {
  return plan.short_games() ? match::packet_paths() : match::MetricPaths{};
}

std::string csv_head(const match::MetricPaths& metrics) {
  std::string out =
      "row,pair,seed,opening,home,away,home_goals,away_goals,ended,state_hash,forfeited_by,plugin,call,why";
  for (const std::string& each : metrics.of_teams)
    out += fmt::format(",{},{}", csv_field("home." + each), csv_field("away." + each));
  for (const std::string& each : metrics.of_match) out += ',' + csv_field(each);
  return out + '\n';
}

std::string csv_line(const TournamentView& view, std::uint64_t index, const campaign::MatchResult& decided,
                     match::MetricColumns& metrics) {
  const study::Fixture fixture = view.course.calendar().at(index);
  const auto& teams = view.plan.teams;
  const std::string opening = scene_name(view.plan.openings, fixture.opening);
  // A match that could not be played has an empty field for its score.
  const auto goals = [&decided](std::size_t side) {
    return decided.set_aside() ? std::string() : std::to_string(decided.score[side]);
  };
  std::string out = fmt::format("{},{},{},{},{},{},{},{},{},{},", index + 1, fixture.pair + 1, fixture.seed,
                                csv_field(opening), csv_field(teams[fixture.home].label),
                                csv_field(teams[fixture.away].label), goals(0), goals(1), decided.ended, decided.hash);
  if (decided.failure) {
    const campaign::Failure& failure = *decided.failure;
    out += fmt::format("{},{},{},{}", failure.side == 0 ? "home" : "away", csv_field(failure.plugin),
                       csv_field(failure.call), csv_field(failure.what));
  } else {
    out += ",,," + csv_field(decided.why_set_aside);
  }
  const auto write = [&out](const std::optional<double>& value) {
    out += ',';
    if (value) fmt::format_to(std::back_inserter(out), FMT_COMPILE("{}"), *value);
  };
  std::ranges::for_each(metrics.of(decided.metrics), write);
  return out + '\n';
}

const char* name(study::Verdict verdict) {
  constexpr std::array names{"", "INCONCLUSIVE", "H0", "H1", "NO_VERDICT"};  // in the order of study::Verdict
  return names[static_cast<std::size_t>(verdict)];
}

const char* game_word(const study::TournamentPlan& plan) { return plan.openings.empty() ? "match" : "scene"; }
const char* games_word(const study::TournamentPlan& plan) { return plan.openings.empty() ? "matches" : "scenes"; }

WhatWasPlayed what_was_played(const study::TournamentPlan& plan) {
  WhatWasPlayed out = what_was_played(plan.asked.settings, plan.common_inputs, inputs_of(plan.openings));
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
  out.amount = fmt::format("{}{}, seeds from {}", number_of_pairs(plan),
                           one ? std::string()
                           : plan.rounds() > 0
                               ? fmt::format(" of each of {} meetings in {} rounds", plan.meetings(), plan.rounds())
                               : fmt::format(" of each of {} pairings", plan.pairings().size()),
                           plan.first_seed());
  complete(out, plan);
  if (plan.ended_after) {  // a repetition must have as many pairs as were played
    config::Tournament asked = plan.asked;
    asked.pairs = static_cast<int>(*plan.ended_after);
    out.document = config::document_text(asked);
  }
  return out;
}

namespace {

const char* format_in_words(const study::TournamentPlan& plan) {
  constexpr std::array names{"round robin", "gauntlet", "Swiss", "knock-out"};  // in the order of Tournament::Format
  return names[static_cast<std::size_t>(plan.asked.format)];
}

// Returns ", 43 scenes of about 42 s" or ", 120 s a match"; empty for whole matches.
std::string games_of(const study::TournamentPlan& plan) {
  if (!plan.openings.empty()) return ", " + scenes_text(plan);
  const auto& limit = plan.asked.settings.limit;
  return limit ? fmt::format(", {} s a match", config::real_text(*limit)) : std::string();
}

Json rounds_json(const TournamentView& view) {
  Json out = Json::array();
  for (const std::vector<std::size_t>& round : view.course.calendar().drawn()) {
    Json& meetings = out.emplace_back(Json::array());
    for (const std::size_t pairing : round) {
      const study::Pairing& who = view.course.calendar().pairings()[pairing];
      meetings.push_back({view.label(who.first), view.label(who.second)});
    }
  }
  return out;
}

}  // namespace

std::string title(const TournamentView& view) {
  const std::string who = view.plan.teams.size() == 2
                              ? fmt::format("{} vs {}", view.shown(0), view.shown(1))
                              : fmt::format("{} teams, {}", view.plan.teams.size(), format_in_words(view.plan));
  if (const std::uint64_t rounds = view.plan.rounds(); rounds > 0) {
    return fmt::format("{} ({} rounds, {} each, seeds from {}{})", who, rounds, pairs_in_words(view.plan.pairs()),
                       view.plan.first_seed(), games_of(view.plan));
  }
  const std::size_t pairings = view.course.calendar().pairings().size();
  const std::uint64_t played = view.course.taken() / 2 / pairings;  // includes pairs of teams that were set aside
  std::string out = fmt::format("{} ({}", who, pairs_in_words(played));
  if (played < view.plan.pairs() && view.plan.open_end().empty()) out += fmt::format(" of {}", view.plan.pairs());
  if (pairings > 1) out += " each";
  return out + fmt::format(", seeds from {}{})", view.plan.first_seed(), games_of(view.plan));
}

ForfeitWords forfeit_words(const TournamentView& view, TeamText name) {
  return {[&view, name](std::size_t team) { return (view.*name)(team); }, view.again, {}};
}

namespace {

Json tournament_data(const TournamentView& view) {
  const study::Tournament& course = view.course;
  Json out;
  Json teams = Json::array();
  for (std::size_t team = 0; team < view.plan.teams.size(); ++team) {
    teams.push_back({{"name", view.label(team)},
                     {"title", view.shown(team)},
                     {"file", view.plan.asked.teams[team].team},
                     {"failures", course.forfeits().of_team()[team]},
                     {"packets_of_short_games", packets_json(course.packets(team))}});
  }
  if (!view.plan.asked.name.empty()) {
    out["tournament"] = view.plan.asked.name;
    out["question"] = view.plan.asked.question;
  }
  out["teams"] = teams;
  constexpr std::array formats{"round_robin", "gauntlet", "swiss", "knock_out"};  // in the order of Tournament::Format
  out["format"] = formats[static_cast<std::size_t>(view.plan.asked.format)];
  if (view.plan.rounds() > 0) out["rounds"] = rounds_json(view);
  out["pairs"] = view.plan.pairs();
  if (!view.plan.pairs_before.empty()) out["pairs_before"] = view.plan.pairs_before;
  if (view.plan.ended_after) out["ended_after"] = *view.plan.ended_after;
  out["first_seed"] = view.plan.first_seed();
  out["openings"] = view.plan.openings.size();
  out["matches"] = course.matches();
  const bool tested = course.verdict() != study::Verdict::none;
  out["verdict"] = tested ? Json(name(course.verdict())) : Json(nullptr);
  out["complete"] = course.complete();
  // A sequential test stops at results that favour its verdict, so the estimates are biased towards the verdict.
  out["estimates_biased_by_stopping"] =
      course.verdict() == study::Verdict::accept_h0 || course.verdict() == study::Verdict::accept_h1;
  const bool fixed = !tested && course.complete();
  const PValues p = p_values(course);
  Json pairings = Json::array();
  for (std::size_t i = 0; i < p.single.size(); ++i) {
    const Chance chance = fixed ? Chance(p.single[i], p.adjusted[i]) : Chance();
    pairings.push_back(meeting_json(view, course.meetings()[i], chance));
    pairings.back()["verdict_prevented"] =
        tested ? course.verdict() == study::Verdict::prevented : fixed && p.prevented[i];
  }
  out["pairings"] = pairings;
  if (view.plan.teams.size() > 2) {
    Json ranks = Json::array();
    for (const Ranked& team : ranking(view.plan, course)) {
      ranks.push_back({{"team", view.label(team.team)},
                       {"elo", team.elo ? Json(team.elo->value) : Json(nullptr)},
                       {"elo_interval", team.elo ? json_of(team.elo->interval) : Json(nullptr)},
                       {"nash", team.nash ? Json(*team.nash) : Json(nullptr)},
                       {"points", team.points},
                       {"games", team.matches},
                       {"goals", {team.scored, team.conceded}}});
    }
    out["ranking"] = ranks;
  }
  out["forfeits"] = forfeits_json(course.forfeits(), forfeit_words(view, &TournamentView::label), "team");
  Json set_aside = Json::array();
  for (const study::SetAside& each : course.set_aside()) {
    set_aside.push_back({{"team", view.label(each.team)},
                         {"plugin", each.plugin},
                         {"failures", each.failures},
                         {"after_pair", each.pair + 1}});
  }
  out["set_aside"] = set_aside;
  out["unplayed"] = unplayed_json(course.unplayed_pairs(), course.remarks());
  out["allow_shared_memory"] = view.plan.limits().allow_shared_memory;
  return out;
}

}  // namespace

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
  out.lead = lead_of(view);
  out.played = what_was_played(view.plan);
  out.remarks = view.course.remarks();
  out.data = [view] { return tournament_data(view); };
  out.add(standing_section(view));
  out.add(rounds_section(view));
  out.add(curves_section(view));
  if (page != nullptr) {
    out.add(goals_section(view, page->record));
    out.add(roles_section(view, page->record, page->metrics));
  }
  out.add(packets_section(view, page != nullptr ? &page->record : nullptr));
  if (page != nullptr) out.add(plugins_section(view, page->record));
  out.add(variance_section(view));
  out.add(unplayed_section(view.course.unplayed_pairs(), view.course.remarks()));
  out.add(forfeits_section(view.course.forfeits(), forfeit_words(view, &TournamentView::shown)));
  if (page == nullptr) return out;
  out.fingerprint = page->record.fingerprint();
  out.add(recordings_section(view, page->recordings, page->link_to));
  out.add(configuration_section(page->documents, out.played.teams));
  return out;
}

}  // namespace regista::report
