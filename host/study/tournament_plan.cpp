// SPDX-License-Identifier: MIT
#include "study/tournament_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "campaign/inputs.hpp"
#include "config/documents.hpp"
#include "match/side.hpp"
#include "study/older_plans.hpp"
#include "study/plan_fields.hpp"

namespace regista::study {
namespace {

constexpr int tournament_plan_version = 2;

// What the course of a tournament relies on.
bool sound(const TournamentPlan& plan) {
  for (std::size_t i = 0; i < plan.teams.size(); ++i) {
    const bool own = !plan.asked.teams[i].disturbance.empty();
    if (plan.teams[i].disturbances.size() != (own ? 2u : 0u)) return false;
  }
  return plan.pairs() <= UINT64_MAX / 2 / plan.pairings().size() && plan.most_goals >= 1;
}

}  // namespace

// Found by their arguments: not in the namespace above.

template <Like<Entrant> Team, class Visit>
static void fields(Team& team, Visit& visit) {
  visit("label", team.label);
  visit("inputs", team.inputs);
  visit("disturbances", team.disturbances);
}

template <Like<TournamentPlan> Plan, class Visit>
static void fields(Plan& plan, Visit& visit) {
  visit("teams", plan.teams);
  visit("openings", plan.openings);
  visit("most_goals", plan.most_goals);
  visit.maybe("pairs_before", plan.pairs_before);
  visit("folder", plan.folder);
  visit("plugins", plan.plugins);
  visit.maybe("program", plan.program);
  visit("common_inputs", plan.common_inputs);
}

Objective objective_of(const config::Tournament& asked) {
  if (!asked.test) return FixedNumber{};
  if (!asked.test->elo) return ValueTest{asked.test->metric, asked.test->alpha};
  ScoreTest out;
  using Model = config::TournamentTest::Model;
  out.design.model = asked.test->model == Model::logistic ? statistics::Model::logistic : statistics::Model::normalized;
  out.design.hypotheses = {(*asked.test->elo)[0], (*asked.test->elo)[1]};
  out.design.rates = {asked.test->alpha, asked.test->beta.value_or(config::TournamentTest::usual_rate)};
  return out;
}

std::uint64_t TournamentPlan::pairs() const {
  return asked.pairs ? static_cast<std::uint64_t>(*asked.pairs) : most_pairs;
}

std::vector<Pairing> TournamentPlan::pairings() const {
  std::vector<Pairing> out;
  const bool gauntlet = asked.format == config::Tournament::Format::gauntlet;
  for (std::size_t first = 0; first < asked.teams.size(); ++first) {
    for (std::size_t second = first + 1; second < asked.teams.size(); ++second) {
      if (!gauntlet || first == 0) out.push_back({first, second});
    }
  }
  return out;
}

Calendar::Calendar(const TournamentPlan& plan)
    : pairings_(plan.pairings()),
      openings_(std::max<std::size_t>(plan.openings.size(), 1)),
      drawn_(plan.asked.test.has_value()),
      pairs_(plan.pairs()),
      first_seed_(plan.first_seed()) {}

Fixture Calendar::of_number(std::size_t number) const {
  Fixture out;
  out.number = number;
  out.opening = number % openings_;
  out.swapped = number / openings_ % 2 == 1;
  out.pairing = number / openings_ / 2;
  const Pairing& pairing = pairings_[out.pairing];
  out.home = out.swapped ? pairing.second : pairing.first;
  out.away = out.swapped ? pairing.first : pairing.second;
  return out;
}

Fixture Calendar::at(std::uint64_t index) const {
  const std::uint64_t pair = index / 2 / pairings_.size(), seed = first_seed_ + pair;
  const auto pairing = static_cast<std::size_t>(index / 2 % pairings_.size());
  const std::size_t opening = drawn_ ? drawn_opening(seed, openings_) : static_cast<std::size_t>(pair % openings_);
  Fixture out = of_number((2 * pairing + index % 2) * openings_ + opening);
  out.pair = pair;
  out.seed = seed;
  return out;
}

std::optional<std::size_t> team_meant(const TournamentPlan& plan, const std::string& path) {
  const std::string first = path.substr(0, path.find('.'));
  if (first.size() != 1 || first[0] < 'a' || first[0] > 'z') return std::nullopt;
  const auto team = static_cast<std::size_t>(first[0] - 'a');
  return team < plan.asked.teams.size() ? std::optional(team) : std::nullopt;
}

config::Overrides settings_of(const TournamentPlan& plan, const Fixture& fixture) {
  config::Overrides out;
  for (const config::Node::Entry& each : plan.asked.settings.set.entries()) {
    const std::optional<std::size_t> team = team_meant(plan, each.key);
    if (!team) {
      out.emplace_back(each.key, each.value, each.key_where);
      continue;
    }
    const std::string rest = each.key.substr(1);
    for (const match::Side side : match::both_sides) {
      if (*team != (side == match::Side::home ? fixture.home : fixture.away)) continue;
      out.emplace_back(match::name(side) + rest, each.value, each.key_where);
    }
  }
  return out;
}

campaign::Job job(const TournamentPlan& plan, const Fixture& fixture) {
  campaign::Job out = job_under(plan.asked.settings, plan.plugins);
  out.teams = {plan.asked.teams[fixture.home].team, plan.asked.teams[fixture.away].team};
  out.disturbance = plan.asked.disturbance;
  out.overrides = as_typed(settings_of(plan, fixture));
  out.seed = fixture.seed;
  out.home_inputs = plan.teams[fixture.home].inputs;
  out.away_inputs = plan.teams[fixture.away].inputs;
  out.common_inputs = plan.common_inputs;
  out.home_disturbance = plan.asked.teams[fixture.home].disturbance;
  out.away_disturbance = plan.asked.teams[fixture.away].disturbance;
  for (std::size_t side = 0; side < 2; ++side) {
    const Entrant& team = plan.teams[side == 0 ? fixture.home : fixture.away];
    if (team.disturbances.empty()) continue;
    for (campaign::Input& each : out.common_inputs) {
      if (is_disturbance(each, side)) each = team.disturbances[side];
    }
  }
  if (!plan.openings.empty()) start_from(plan.openings[fixture.opening], out);
  return out;
}

std::vector<campaign::Store::Fixture> fixtures(const TournamentPlan& plan) {
  const Calendar calendar(plan);
  std::vector<campaign::Store::Fixture> out(calendar.fixtures());
  for (std::size_t number = 0; number < out.size(); ++number) {
    campaign::Store::Fixture& each = out[number];
    each.job = job(plan, calendar.of_number(number));
    each.key = campaign::fixture_key(each.job.home_inputs, each.job.away_inputs, each.job.common_inputs);
  }
  return out;
}

bool is_disturbance(const campaign::Input& input, std::size_t side) {
  return input.name.starts_with(side == 0 ? "home disturbance " : "away disturbance ");
}

std::string letter(std::size_t team) {
  return team < 26 ? std::string(1, static_cast<char>('a' + static_cast<char>(team))) : std::string();
}

bool equal_teams(const TournamentPlan& plan, const Pairing& pairing) {
  const Entrant &a = plan.teams[pairing.first], &b = plan.teams[pairing.second];
  return campaign::fixture_key(a.inputs, b.inputs, {}) == campaign::fixture_key(b.inputs, a.inputs, {}) &&
         campaign::fixture_key(a.disturbances, b.disturbances, {}) ==
             campaign::fixture_key(b.disturbances, a.disturbances, {});
}

TournamentPlan with_pairs(TournamentPlan plan, std::uint64_t pairs) {
  if (plan.asked.test) {
    throw std::invalid_argument(
        "it has a sequential test, whose error rates hold for the number of pairs that was fixed before the first "
        "match");
  }
  if (pairs == plan.pairs()) return plan;
  if (pairs < plan.pairs()) throw std::invalid_argument(fmt::format("it has {} pairs already", plan.pairs()));
  if (pairs > most_pairs) throw std::invalid_argument(fmt::format("at most {} pairs can be played", most_pairs));
  plan.pairs_before += fmt::format("{}{}", plan.pairs_before.empty() ? "" : ", ", plan.pairs());
  plan.asked.pairs = static_cast<int>(pairs);
  return plan;
}

std::string to_json(const TournamentPlan& plan) { return plan_text(tournament_study, tournament_plan_version, plan); }

TournamentPlan tournament_plan_from_json(const std::string& text) {
  return read_plan(text, tournament_study, tournament_plan_version, tournament_of_version_1, [](const PlanJson& json) {
    TournamentPlan plan;
    read(json, plan);
    config::Mistakes first = mistakes_of_a_plan();
    plan.asked = config::read_document<config::Tournament>(document_of(json), first);
    if (plan.teams.size() != plan.asked.teams.size() || !sound(plan)) throw std::out_of_range("what no tournament has");
    return plan;
  });
}

std::vector<std::string> differences(const TournamentPlan& before, const TournamentPlan& now) {
  config::Tournament asked = now.asked;
  std::vector<std::string> out = config::differences(asked_by(before), declare(asked));
  for (std::size_t team = 0; team < std::min(before.teams.size(), now.teams.size()); ++team) {
    for (const auto inputs : {&Entrant::inputs, &Entrant::disturbances}) {
      for (const std::string& each : campaign::differences(before.teams[team].*inputs, now.teams[team].*inputs))
        out.push_back(fmt::format("team {}: {}", before.teams[team].label, each));
    }
  }
  const auto inputs = [](const TournamentPlan& plan) {
    std::vector<campaign::Input> all = plan.common_inputs;
    for (const Opening& opening : plan.openings) all.push_back(opening.input);
    return all;
  };
  for (const std::string& each : campaign::differences(inputs(before), inputs(now))) out.push_back(each);
  if (out.empty() && inputs(before) != inputs(now)) out.push_back("the openings come in another order");
  return out;
}

}  // namespace regista::study
