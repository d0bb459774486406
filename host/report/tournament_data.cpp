// SPDX-License-Identifier: MIT
// A tournament for programs: every number in full.
#include "report/match_remarks.hpp"
#include "report/number_json.hpp"
#include "report/packets_spent.hpp"
#include "report/standing.hpp"
#include "report/tournament_outline.hpp"
#include "texts/json.hpp"

namespace regista::report {
namespace {

using Json = nlohmann::ordered_json;

Json score_test(const statistics::SequentialTest<statistics::PairCounts>& test) {
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

// Nothing where the number of pairs was not fixed beforehand, or not all of them are played.
using Chance = std::pair<std::optional<double>, std::optional<double>>;

Json meeting_json(const TournamentView& view, const study::Meeting& meeting, const Chance& p) {
  Json out;
  const auto label = [&](std::size_t team) { return view.plan.teams[team].label; };
  out["teams"] = {label(meeting.pairing.first), label(meeting.pairing.second)};
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
    out["los"] = known->superiority;
    out["p"] = json_or_null(p.first);
    out["p_holm"] = json_or_null(p.second);
    out["pair_ratio"] = json_or_null(known->pair_ratio);
    out["variance_ratio"] = {{"scores", json_or_null(known->score_ratio)}, {"goals", json_or_null(known->goals_ratio)}};
    Json goals{{"mean", meeting.goals_of_pairs.mean()},
               {"standard_deviation", meeting.goals_of_pairs.standard_deviation()},
               {"confidence_sequence", json_of(meeting.goals_sequence.interval())}};
    // A t test holds for a number of pairs that nobody chose by looking.
    if (p.first && known->goals_t && meeting.unplayed_pairs == 0) {
      goals["t"] = known->goals_t->t;
      goals["t_p"] = known->goals_t->p;
      goals["t_interval"] = json_of(known->goals_t->interval);
    }
    out["goals_per_match"] = goals;
  }
  if (meeting.score_test) out["sprt"] = score_test(*meeting.score_test);
  if (meeting.metric) out["metric"] = metric(meeting, std::get<study::ValueTest>(view.plan.objective()));
  return out;
}

}  // namespace

Json tournament_data(const TournamentView& view) {
  const study::Tournament& course = view.course;
  const auto label = [&](std::size_t team) { return view.plan.teams[team].label; };
  Json out;
  Json teams = Json::array();
  for (std::size_t team = 0; team < view.plan.teams.size(); ++team) {
    teams.push_back({{"name", label(team)},
                     {"file", view.plan.asked.teams[team].team},
                     {"failures", course.forfeits().of_team()[team]},
                     {"packets_of_short_games", packets_json(course.packets(team))}});
  }
  if (!view.plan.asked.name.empty()) {
    out["tournament"] = view.plan.asked.name;
    out["question"] = view.plan.asked.question;
  }
  out["teams"] = teams;
  out["format"] = view.plan.asked.format == config::Tournament::Format::gauntlet ? "gauntlet" : "round_robin";
  out["pairs"] = view.plan.pairs();
  if (!view.plan.pairs_before.empty()) out["pairs_before"] = view.plan.pairs_before;
  out["first_seed"] = view.plan.first_seed();
  out["openings"] = view.plan.openings.size();
  out["matches"] = course.matches();
  const bool tested = course.verdict() != study::Verdict::none;
  out["verdict"] = tested ? Json(name(course.verdict())) : Json(nullptr);
  out["complete"] = course.complete();
  // A test that chose when to stop has pulled the estimates towards its verdict.
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
      ranks.push_back({{"team", label(team.team)},
                       {"elo", team.elo ? Json(team.elo->value) : Json(nullptr)},
                       {"elo_interval", team.elo ? json_of(team.elo->interval) : Json(nullptr)},
                       {"nash", team.nash},
                       {"points", team.points},
                       {"games", team.matches},
                       {"goals", {team.scored, team.conceded}}});
    }
    out["ranking"] = ranks;
  }
  out["forfeits"] = forfeits_json(course.forfeits(), forfeit_words(view), "team");
  Json set_aside = Json::array();
  for (const study::SetAside& each : course.set_aside()) {
    set_aside.push_back({{"team", label(each.team)},
                         {"plugin", each.plugin},
                         {"failures", each.failures},
                         {"after_pair", each.pair + 1}});
  }
  out["set_aside"] = set_aside;
  out["unplayed"] = unplayed_json(course.unplayed_pairs(), course.remarks());
  out["allow_shared_memory"] = view.plan.limits().allow_shared_memory;
  return out;
}

}  // namespace regista::report
