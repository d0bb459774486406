// SPDX-License-Identifier: MIT
#include "study/tournament_plan.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <initializer_list>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

#include "campaign/inputs.hpp"
#include "match/side.hpp"
#include "study/more_pairs.hpp"
#include "study/plan_fields.hpp"

namespace regista::study {
namespace {

constexpr int tournament_plan_version = 1;

bool is_rate(double rate) { return rate > 0.0 && rate < 1.0; }

bool sound(const Objective& objective) {
  if (const auto* score = std::get_if<ScoreTest>(&objective)) {
    const auto& [elo0, elo1] = score->design.hypotheses;
    const auto& [alpha, beta] = score->design.rates;
    return elo0 < elo1 && is_rate(alpha) && is_rate(beta) && alpha + beta < 1.0;
  }
  const auto* const value = std::get_if<ValueTest>(&objective);
  return value == nullptr || is_rate(value->alpha);
}

// What the course of a tournament relies on.
bool sound(const TournamentPlan& plan) {
  const std::uint64_t most = UINT64_MAX / 2 / plan.pairings().size();
  return plan.pairs >= 1 && plan.pairs <= most && plan.first_seed <= UINT64_MAX - (plan.pairs - 1) &&
         plan.most_goals >= 1 && plan.failures_in_a_row >= 0 && sound(plan.objective);
}

std::string in_words(const Objective& objective) {
  if (const auto* score = std::get_if<ScoreTest>(&objective)) {
    const statistics::SequentialDesign& design = score->design;
    return fmt::format("--sprt {},{} --model {} --alpha {} --beta {}", design.hypotheses.elo0, design.hypotheses.elo1,
                       name(design.model), design.rates.alpha, design.rates.beta);
  }
  if (const auto* value = std::get_if<ValueTest>(&objective)) {
    return fmt::format("--metric {} --alpha {}", value->value, value->alpha);
  }
  return "no test";
}

// A path of --set, typed for teams by letter, as the match between home and away understands it; nothing when it is
// about a team that does not play.
std::vector<std::string> overrides_of(const TournamentPlan& plan, const Fixture& fixture) {
  std::vector<std::string> out;
  for (const std::string& typed : plan.common.overrides) {
    const std::string first = typed.substr(0, typed.find('.'));
    const auto team = first.size() == 1 && first[0] >= 'a' && first[0] <= 'z' ? static_cast<std::size_t>(first[0] - 'a')
                                                                              : plan.teams.size();
    if (team >= plan.teams.size()) {
      out.push_back(typed);
      continue;
    }
    const std::string rest = typed.substr(first.size());
    if (fixture.home == team) out.push_back(match::name(match::Side::home) + rest);
    if (fixture.away == team) out.push_back(match::name(match::Side::away) + rest);
  }
  return out;
}

}  // namespace

// Found by their arguments: not in the namespace above.

static const char* name(Format format) { return format == Format::gauntlet ? "gauntlet" : "round_robin"; }

// Whether the text is a value's name, which is then set.
template <class Value>
static bool named(const std::string& text, Value& value, std::initializer_list<Value> values) {
  const auto found = std::ranges::find_if(values, [&](Value each) { return text == name(each); });
  if (found != values.end()) value = *found;
  return found != values.end();
}
static bool named(const std::string& text, Format& format) {
  return named(text, format, {Format::round_robin, Format::gauntlet});
}

static PlanJson json_of(const Objective& objective) {
  if (const auto* score = std::get_if<ScoreTest>(&objective)) {
    const statistics::SequentialDesign& design = score->design;
    return {{"test", "score"},
            {"model", name(design.model)},
            {"elo0", design.hypotheses.elo0},
            {"elo1", design.hypotheses.elo1},
            {"alpha", design.rates.alpha},
            {"beta", design.rates.beta}};
  }
  if (const auto* value = std::get_if<ValueTest>(&objective)) {
    return {{"test", "value"}, {"value", value->value}, {"alpha", value->alpha}};
  }
  return {{"test", "none"}};
}

static void read(const PlanJson& json, Objective& objective) {
  const auto test = json.at("test").get<std::string>();
  if (test == "score") {
    ScoreTest out;
    using statistics::Model;
    if (!named(json.at("model").get<std::string>(), out.design.model, {Model::normalized, Model::logistic})) {
      throw std::out_of_range("model");
    }
    out.design.hypotheses = {json.at("elo0").get<double>(), json.at("elo1").get<double>()};
    out.design.rates = {json.at("alpha").get<double>(), json.at("beta").get<double>()};
    objective = out;
  } else if (test == "value") {
    objective = ValueTest{json.at("value").get<std::string>(), json.at("alpha").get<double>()};
  } else if (test == "none") {
    objective = FixedNumber{};
  } else {
    throw std::out_of_range(test);
  }
}

template <Like<Entrant> Team, class Visit>
static void fields(Team& team, Visit& visit) {
  visit("label", team.label);
  visit("file", team.file);
  visit("inputs", team.inputs);
  visit.maybe("disturbance", team.disturbance);
  std::string disturbances = team.disturbances.empty() ? "" : campaign::to_json(team.disturbances);
  visit.maybe("disturbances", disturbances);
  if constexpr (!std::is_const_v<Team>) {
    team.disturbances =
        disturbances.empty() ? std::vector<campaign::Input>() : campaign::inputs_from_json(disturbances);
  }
}

template <Like<TournamentPlan> Plan, class Visit>
static void fields(Plan& plan, Visit& visit) {
  visit.maybe("name", plan.name);
  visit.maybe("question", plan.question);
  visit("teams", plan.teams, "the number of teams",
        [](const std::vector<Entrant>& teams) { return std::to_string(teams.size()); });
  visit("format", plan.format, "--format");
  visit("openings", plan.openings);
  visit("pairs", plan.pairs, "--pairs");
  visit.maybe("pairs_before", plan.pairs_before);
  visit("first_seed", plan.first_seed, "--seed");
  visit("objective", plan.objective, "the test", [](const Objective& objective) { return in_words(objective); });
  visit("most_goals", plan.most_goals);
  visit("failures_in_a_row", plan.failures_in_a_row, "--failures-in-a-row");
  limit_fields(plan.limits, visit);
  visit("folder", plan.folder);
  visit("common", plan.common);
  visit("common_inputs", plan.common_inputs);
}

std::vector<Pairing> TournamentPlan::pairings() const {
  std::vector<Pairing> out;
  for (std::size_t first = 0; first < teams.size(); ++first) {
    for (std::size_t second = first + 1; second < teams.size(); ++second) {
      if (format == Format::round_robin || first == 0) out.push_back({first, second});
    }
  }
  return out;
}

Calendar::Calendar(const TournamentPlan& plan)
    : pairings_(plan.pairings()),
      openings_(std::max<std::size_t>(plan.openings.size(), 1)),
      drawn_(!std::holds_alternative<FixedNumber>(plan.objective)),
      pairs_(plan.pairs),
      first_seed_(plan.first_seed) {}

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

campaign::Job job(const TournamentPlan& plan, const Fixture& fixture) {
  campaign::Job out = plan.common;
  out.teams = {plan.teams[fixture.home].file, plan.teams[fixture.away].file};
  out.overrides = overrides_of(plan, fixture);
  out.seed = fixture.seed;
  out.home_inputs = plan.teams[fixture.home].inputs;
  out.away_inputs = plan.teams[fixture.away].inputs;
  out.common_inputs = plan.common_inputs;
  const std::array sides{std::pair{&out.home_disturbance, &plan.teams[fixture.home]},
                         std::pair{&out.away_disturbance, &plan.teams[fixture.away]}};
  for (std::size_t side = 0; side < sides.size(); ++side) {
    const auto& [file, team] = sides[side];
    if (!team->disturbed()) continue;
    *file = team->disturbance;
    if (team->disturbances.size() != 2) continue;  // while the tournament is planned
    for (campaign::Input& each : out.common_inputs) {
      if (is_disturbance(each, side)) each = team->disturbances[side];
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
  if (!std::holds_alternative<FixedNumber>(plan.objective)) {
    throw std::invalid_argument(
        "it has a sequential test, whose error rates hold for the number of pairs that was fixed before the first "
        "match");
  }
  raise_pairs(plan.pairs, plan.pairs_before, pairs, plan.first_seed);
  return plan;
}

std::string to_json(const TournamentPlan& plan) { return plan_text(tournament_study, tournament_plan_version, plan); }

TournamentPlan tournament_plan_from_json(const std::string& text) {
  return plan_of<TournamentPlan>(tournament_study, tournament_plan_version, text, [](const TournamentPlan& plan) {
    if (plan.teams.size() < 2) throw std::invalid_argument("its plan has fewer than two teams");
    for (const Entrant& each : plan.teams) {
      if (each.disturbances.size() != (each.disturbed() ? 2u : 0u)) return false;
    }
    return sound(plan);
  });
}

std::vector<std::string> differences(const TournamentPlan& before, const TournamentPlan& now) {
  std::vector<std::string> out = field_differences(before, now);
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
