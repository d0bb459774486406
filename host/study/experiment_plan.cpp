// SPDX-License-Identifier: MIT
#include "study/experiment_plan.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "match/game_state.hpp"
#include "match/teams.hpp"
#include "plugin/info.hpp"
#include "study/experiment_course.hpp"
#include "study/measure.hpp"
#include "study/plan_fields.hpp"
#include "texts/message.hpp"

namespace regista::study {
namespace {

// Returns whether all numbers of the plan are in the ranges that class Experiment needs.
bool sound(const ExperimentPlan& plan) {
  if (plan.ended_after && (*plan.ended_after == 0 || *plan.ended_after > plan.pairs)) return false;
  return plan.pairs > 0 && !plan.measures.empty() && plan.conditions.size() == plan.arms() * plan.values() &&
         plan.pairs <= UINT64_MAX / 2 / plan.conditions.size();
}

constexpr std::size_t most_conditions = 2000;

// The time on the game clock, s, at the end of a match that no goal difference ends, over all halves. The clock also
// runs in Ready and Set after a goal, so Playing is shorter. Only the limit includes the time before a half's kick-off.
double clock_seconds(const match::Setup& setup) {
  constexpr double initial = 1.0;  // s; duration of Initial in match/referee.hpp
  const config::Durations& durations = setup.rules.durations;
  if (setup.opening) return setup.limit.value_or(setup.opening->length);
  double seconds = 0.0, left = setup.limit.value_or(HUGE_VAL);
  for (int half = 0; half < durations.halves; ++half) {
    left -= initial + durations.ready + durations.set;
    const double played = std::clamp(left, 0.0, durations.half);
    seconds += played;
    left -= played;
  }
  return seconds;
}

class ExperimentPlanner : Planner<ExperimentPlan> {
 public:
  using Planner<ExperimentPlan>::Planner;

  ExperimentPlan plan() {
    if (plan_.arms() * plan_.values() > most_conditions) {
      config::refuse(
          document_, {"sweep.values"},
          fmt::format("{} arms at {} values: at most {} can be played", plan_.arms(), plan_.values(), most_conditions));
    }
    require_present_names(plan_.asked.settings.set, "set");
    for (const config::Experiment::Arm& each : plan_.asked.arms)
      require_present_names(each.set, fmt::format("arm {}", texts::in_quotes(each.name)));
    if (const auto& sweep = plan_.asked.sweep) {
      const config::Location where = document_["sweep"]["path"].where();
      require_present_names(config::Node::map({{sweep->path, where, config::Node()}}, where), "sweep");
    }
    make_jobs(plan_, document_);
    look_at_conditions();
    if (!mistakes_.none()) return {};  // the steps below need all conditions
    mistakes_.attempt("", [&] {
      DocumentScenes found = document_scenes(plan_.asked.settings.openings, setups_);
      plan_.openings = std::move(found.openings);
      scenes_ = std::move(found.read);
    });
    mistakes_.attempt("", [&] { count_pairs(); });
    choose_measures();
    return std::move(plan_);
  }

 private:
  void look_at_conditions() {
    const auto declarations = plugin::declarations(catalogue_.plugins());
    const auto shown = [&](const config::Node& document) {
      return config::show(document, declarations, config::Remarks::without);
    };
    std::string opponent;
    const auto look_at = [&](Condition& condition) {
      const config::Overrides settings = settings_of(plan_.asked, document_, condition.arm, condition.value);
      campaign::MatchSetup prepared = find_inputs(condition.jobs, settings, catalogue_, program_, mathematics_);
      if (condition.value == 0) plan_.documents.push_back(shown(*prepared.documents[0]));
      if (opponent.empty()) opponent = shown(*prepared.documents[1]);
      for (const std::string& each : metric_paths_of(*prepared.plans[0])) texts::add_once(known_, each);
      if (condition.value == 0) add_roles(*prepared.plans[0]);
      setups_.push_back(std::move(prepared.setup));
    };
    for (Condition& each : plan_.conditions) mistakes_.attempt("", [&] { look_at(each); });
    plan_.documents.push_back(opponent);
  }

  // Adds the roles of the team's first list of roles, whose measures the plan reports by default.
  void add_roles(const mind::TeamPlan& team) {
    const std::vector<match::Role> roles = match::roles(team);
    const std::vector<std::string> names = match::role_names(roles);
    for (std::size_t i = 0; i < roles.size(); ++i) {
      if (roles[i].list == roles.front().list) texts::add_once(roles_, names[i]);
    }
  }

  // Sets the number of pairs. If the document gives minutes, the shortest match of any condition sets this number.
  void count_pairs() {
    if (plan_.asked.matches) {
      plan_.pairs = static_cast<std::uint64_t>(*plan_.asked.matches) / 2;
    } else {
      double shortest = HUGE_VAL;
      for (match::Setup setup : setups_) {
        if (scenes_.empty()) shortest = std::min(shortest, clock_seconds(setup));
        for (const config::Opening& scene : scenes_) {
          setup.opening = scene;
          shortest = std::min(shortest, clock_seconds(setup));
        }
      }
      if (!(shortest > 0.0)) {
        config::refuse(document_, {"limit", "minutes"},
                       "limit: matches would end before their first kick-off, so they make no minutes of the clock");
      }
      plan_.pairs = static_cast<std::uint64_t>(std::ceil(*plan_.asked.minutes * 60.0 / (2.0 * shortest) - 1e-9));
    }
    plan_.pairs = std::max<std::uint64_t>(plan_.pairs, 1);
    const std::uint64_t each = 2 * plan_.conditions.size();
    if (plan_.pairs <= most_experiment_matches / each) return;
    config::refuse(document_, {"minutes", "matches"},
                   fmt::format("{} arms and values make more than {} matches in all", plan_.conditions.size(),
                               most_experiment_matches));
  }

  bool is_known(const std::string& measure) const { return std::ranges::find(known_, measure) != known_.end(); }

  void require_measure(const std::string& measure, const config::Location& where, const char* what) const {
    if (const std::string why = why_missing(measure, plan_.short_games()); !why.empty()) {
      throw config::Error(where, fmt::format("{}: {}", what, why));
    }
    if (!is_known(measure)) throw config::Error(where, texts::unknown("measure", measure, what, known_));
  }

  void choose_measures() {
    for (const config::Node& each : plan_.asked.measures) {
      const std::string measure(match::without_roles(each.text()));
      mistakes_.attempt("", [&] { require_measure(measure, each.where(), "measures"); });
      texts::add_once(plan_.measures, measure);
    }
    if (plan_.measures.empty()) add_usual_measures();
    const std::string primary = plan_.primary();
    if (primary.empty()) return;
    mistakes_.attempt("", [&] { require_measure(primary, document_["primary"]["measure"].where(), "primary"); });
    texts::add_once(plan_.measures, primary);
  }

  // Adds the default measures. First come the sums over all roles. Without a sweep, three measures of each role follow
  // (a sweep shows each measure as a curve). Last come agreement, goals, points and packets of the team.
  void add_usual_measures() {
    const auto add = [&](const std::string& path) {
      if (is_known(path)) texts::add_once(plan_.measures, path);
    };
    for (const std::string& path : known_) {
      if (std::ranges::any_of(roles_, [&](const std::string& role) { return is_known(role + '.' + path); })) add(path);
    }
    if (!plan_.swept()) {
      for (const char* of_each : {"overlap_seconds", "uncovered_seconds", "switches"}) {
        for (const std::string& role : roles_) add(role + '.' + of_each);
      }
    }
    for (const char* each : {"agreement", "agreement_before_silence", "agreement_after_silence", "goals",
                             "goals_against", "points", "packets"}) {
      add(each);
    }
  }

  std::vector<match::Setup> setups_;  // by condition
  // The union of the measures of all conditions.
  std::vector<std::string> known_{measures_of_score.begin(), measures_of_score.end()};
  std::vector<std::string> roles_;  // the roles of all arms
  std::vector<config::Opening> scenes_;
};

}  // namespace

const char* name(PairTest test) { return test == PairTest::sign_flip ? "sign_flip" : "paired_t"; }

// These functions are not in the unnamed namespace, because templates find them by argument-dependent lookup.

static PlanJson json_of(const Condition& condition) {
  return PlanJson::array({json_of(condition.jobs[0]), json_of(condition.jobs[1])});
}
static void read(const PlanJson& json, Condition& condition) {
  for (const std::size_t side : {0u, 1u}) read(json.at(side), condition.jobs[side]);
}

template <Like<ExperimentPlan> Plan, class Visit>
static void fields(Plan& plan, Visit& visit) {
  visit("conditions", plan.conditions);
  visit("openings", plan.openings);
  visit("pairs", plan.pairs);
  visit.maybe("pairs_before", plan.pairs_before);
  visit.maybe("ended_after", plan.ended_after);
  visit("measures", plan.measures);
  visit("folder", plan.folder);
  visit("plugins", plan.plugins);
  visit.maybe("program", plan.program);
  visit("documents", plan.documents);
}

std::string ExperimentPlan::value(std::size_t index) const {
  return swept() ? config::flow(asked.sweep->values[index]) : std::string();
}

std::vector<std::string> ExperimentPlan::value_texts() const {
  std::vector<std::string> out;
  for (std::size_t i = 0; i < values(); ++i) out.push_back(value(i));
  return out;
}

std::string ExperimentPlan::primary() const {
  return asked.primary ? std::string(match::without_roles(asked.primary->measure)) : std::string();
}

// Compares the arms at each value of the sweep. With a single arm, compares each value with the sweep's first value.
std::vector<Comparison> ExperimentPlan::comparisons() const {
  std::vector<Comparison> of_arms, out;
  if (arms() == 1) {
    for (std::size_t value = 1; value < values(); ++value) out.push_back({value, 0});
    return out;
  }
  if (asked.primary && !asked.primary->compare.empty()) {
    const auto index = [&](const config::Node& name) {
      const auto found = std::ranges::find(asked.arms, name.text(), &config::Experiment::Arm::name);
      return static_cast<std::size_t>(found - asked.arms.begin());
    };
    for (const config::Node& pair : asked.primary->compare)
      of_arms.push_back({index(pair.elements()[0]), index(pair.elements()[1])});
  } else {
    for (std::size_t first = 0; first < arms(); ++first) {
      for (std::size_t second = first + 1; second < arms(); ++second) of_arms.push_back({first, second});
    }
  }
  for (std::size_t value = 0; value < values(); ++value) {
    for (const Comparison& each : of_arms) out.push_back({condition(each.first, value), condition(each.second, value)});
  }
  return out;
}

const std::string& team_of(const ExperimentPlan& plan, std::size_t arm) {
  const std::string& own = plan.asked.arms[arm].team;
  return own.empty() ? plan.asked.team : own;
}

void make_jobs(ExperimentPlan& plan, const config::Node& document) {
  plan.conditions.resize(plan.arms() * plan.values());
  for (std::size_t i = 0; i < plan.conditions.size(); ++i) {
    Condition& condition = plan.conditions[i];
    condition.arm = i % plan.arms();
    condition.value = i / plan.arms();
    ask_for(condition.jobs,
            {team_of(plan, condition.arm), plan.asked.opponent, plan.asked.disturbance, plan.asked.opponent_disturbance,
             settings_of(plan.asked, document, condition.arm, condition.value)},
            plan.asked.settings, plan.plugins);
  }
}

Trial trial(const ExperimentPlan& plan, std::uint64_t index) {
  const std::size_t openings = std::max<std::size_t>(plan.openings.size(), 1);
  Trial out;
  out.side = static_cast<std::size_t>(index % 2);
  out.condition = static_cast<std::size_t>(index / 2 % plan.conditions.size());
  out.pair = index / 2 / plan.conditions.size();
  out.seed = plan.first_seed() + out.pair;
  out.opening = static_cast<std::size_t>(out.pair % openings);
  out.number = (2 * out.condition + out.side) * openings + out.opening;
  return out;
}

campaign::Job job(const ExperimentPlan& plan, const Trial& trial) {
  campaign::Job out = plan.conditions[trial.condition].jobs[trial.side];
  out.seed = trial.seed;
  if (!plan.openings.empty()) start_from(plan.openings[trial.opening], out);
  return out;
}

std::vector<campaign::Store::Fixture> fixtures(const ExperimentPlan& plan) {
  const std::size_t openings = std::max<std::size_t>(plan.openings.size(), 1);
  std::vector<campaign::Store::Fixture> out;
  for (std::size_t number = 0; number < 2 * plan.conditions.size() * openings; ++number) {
    Trial each;
    each.opening = number % openings;
    each.side = number / openings % 2;
    each.condition = number / openings / 2;
    out.push_back(fixture_of(job(plan, each)));
  }
  return out;
}

std::string label(const ExperimentPlan& plan, std::size_t condition) {
  const Condition& each = plan.conditions[condition];
  const std::string& arm = plan.asked.arms[each.arm].name;
  return plan.swept() ? fmt::format("{} at {}", arm, plan.value(each.value)) : arm;
}

bool equal_conditions(const ExperimentPlan& plan, const Comparison& comparison) {
  const auto key = [&](std::size_t condition, std::size_t side) {
    return fixture_of(plan.conditions[condition].jobs[side]).key;
  };
  return key(comparison.first, 0) == key(comparison.second, 0) && key(comparison.first, 1) == key(comparison.second, 1);
}

ExperimentPlan with_pairs(ExperimentPlan plan, std::uint64_t pairs, std::uint64_t) {
  const std::uint64_t before = plan.pairs_to_its_end(), most = most_experiment_matches / 2 / plan.conditions.size();
  if (pairs == before && !plan.ended_after) return plan;
  if (pairs <= before) throw std::invalid_argument(fmt::format("it has {} pairs already", before));
  if (pairs > most) throw std::invalid_argument(fmt::format("at most {} pairs can be played", most));
  plan.ended_after = before;
  plan = without_end(std::move(plan));
  plan.pairs = pairs;
  plan.asked.matches = static_cast<int>(2 * pairs);
  plan.asked.minutes.reset();
  return plan;
}

ExperimentPlan without_end(ExperimentPlan plan) {
  if (!plan.ended_after) return plan;
  plan.pairs_before += fmt::format("{}{}", plan.pairs_before.empty() ? "" : ", ", *plan.ended_after);
  plan.ended_after.reset();
  return plan;
}

std::string to_json(const ExperimentPlan& plan) { return plan_text(experiment_study, plan); }

ExperimentPlan experiment_plan_from_json(const std::string& text) {
  return read_plan<ExperimentPlan>(text, experiment_study, experiment_of_version_1, [](ExperimentPlan& plan) {
    if (!sound(plan)) throw std::out_of_range("what no experiment has");
    make_jobs(plan, {});
  });
}

std::vector<std::string> differences(const ExperimentPlan& before, const ExperimentPlan& now) {
  std::vector<std::string> out = document_differences(before, now);
  if (before.measures != now.measures) {
    out.push_back(
        fmt::format("the measures: was {}, now {}", fmt::join(before.measures, ", "), fmt::join(now.measures, ", ")));
  }
  if (!out.empty()) return out;  // the code below needs plans with the same conditions
  InputDifferences inputs;
  for (std::size_t i = 0; i < now.conditions.size(); ++i) {
    for (const std::size_t side : {0u, 1u}) {
      const campaign::Job &then = before.conditions[i].jobs[side], &today = now.conditions[i].jobs[side];
      const std::string arm = fmt::format("{}: ", label(now, i));
      inputs.add(arm, side == 0 ? then.home_inputs : then.away_inputs,
                 side == 0 ? today.home_inputs : today.away_inputs);
      inputs.add("the opponent: ", side == 0 ? then.away_inputs : then.home_inputs,
                 side == 0 ? today.away_inputs : today.home_inputs);
      inputs.add("", then.common_inputs, today.common_inputs);
    }
  }
  return std::move(inputs).with_openings(before.openings, now.openings);
}

ExperimentPlan planned_experiment(const config::Node& document, const std::vector<std::string>& plugins,
                                  const plugin::Catalogue& catalogue, config::Mistakes& mistakes) {
  return ExperimentPlanner(document, plugins, catalogue, mistakes).plan();
}

}  // namespace regista::study
