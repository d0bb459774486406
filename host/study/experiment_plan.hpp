// SPDX-License-Identifier: MIT
// The plan of an experiment: arms, values of a sweep, seeds, number of matches, measures and the deciding test.
//
// A condition is an arm at one value of the sweep; without a sweep, each arm is a condition. A pair is a match with the
// arm's team at home, and the same match with the sides swapped. In all conditions, pair k has the same seed, opening
// and opponent. So conditions differ only in their settings, and the program compares them pair by pair (common random
// numbers, see A. M. Law, "Simulation Modeling and Analysis", chapter 11).
//
// The order of matches, from the outer to the inner loop, is: pairs, values, arms, home and away. So all conditions
// have the same number of complete pairs, apart from the current pair, when the experiment stops.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "campaign/job.hpp"
#include "campaign/store.hpp"
#include "config/errors.hpp"
#include "config/experiment.hpp"
#include "config/node.hpp"
#include "plugin/catalogue.hpp"
#include "study/settings.hpp"

namespace regista::study {

struct Condition {
  std::size_t arm = 0, value = 0;     // indices in the plan; value: 0 without a sweep
  std::array<campaign::Job, 2> jobs;  // [0]: arm's team at home, [1]: away; without seed, opening and recording
};

// A comparison of two conditions, given by their indices: the first condition's value minus the second's.
struct Comparison {
  std::size_t first = 0, second = 0;
};

using PairTest = config::PairedTest;

inline constexpr std::uint64_t most_experiment_matches = 1'000'000;  // sum over all conditions

struct ExperimentPlan : StudyPlan<config::Experiment> {
  std::vector<Condition> conditions;  // make_jobs() makes them from `asked`, except the jobs' inputs
  std::uint64_t pairs = 0;            // pairs of matches for each condition
  std::string pairs_before;           // values of `pairs` before with_pairs() raised it: "100, 150"
  // Set if a time limit (--until, --minutes), not a result, stopped the experiment: the number of pairs played.
  std::optional<std::uint64_t> ended_after;
  std::vector<std::string> measures;   // names (study/measure.hpp) in the order of reports
  std::vector<std::string> documents;  // resolved documents of arms (at the first swept value) and opponent

  std::size_t arms() const { return asked.arms.size(); }
  std::size_t values() const { return asked.sweep ? asked.sweep->values.size() : 1; }
  std::size_t condition(std::size_t arm, std::size_t value) const { return value * arms() + arm; }
  std::uint64_t matches() const { return 2 * pairs * conditions.size(); }
  std::uint64_t pairs_to_its_end() const { return ended_after.value_or(pairs); }
  bool swept() const { return asked.sweep.has_value(); }
  std::string sweep() const { return swept() ? asked.sweep->path : std::string(); }
  std::string value(std::size_t index) const;  // value of the sweep as YAML; empty without a sweep
  std::vector<std::string> value_texts() const;
  std::string primary() const;  // name of the tested measure; empty: no test
  PairTest test() const { return asked.primary ? asked.primary->test : PairTest::sign_flip; }
  std::vector<Comparison> comparisons() const;
};

const std::string& team_of(const ExperimentPlan& plan, std::size_t arm);  // file of an arm's team

// Makes all conditions and their jobs from `asked`. Jobs keep the inputs that they already have. document: the document
// from which `asked` was read, to which errors refer; may be absent. Throws config::Error for impossible settings.
void make_jobs(ExperimentPlan& plan, const config::Node& document);

// A match of the schedule.
struct Trial {
  std::size_t condition = 0, side = 0;  // side: of the arm's team, 0 home, 1 away
  std::size_t opening = 0;              // 0 without openings
  std::uint64_t pair = 0;               // from 0
  std::uint64_t seed = 0;
  std::size_t number = 0;  // index into fixtures(); equal for matches that differ only in the seed
};

// The match at place `index` of the schedule. Precondition: index < plan.matches(). Takes constant time.
Trial trial(const ExperimentPlan& plan, std::uint64_t index);

// The job of a trial's match. `regista match` plays the same job.
campaign::Job job(const ExperimentPlan& plan, const Trial& trial);

// All fixtures of the plan (matches without their seeds) with their keys, in the order of Trial::number.
std::vector<campaign::Store::Fixture> fixtures(const ExperimentPlan& plan);

// The name of a condition: "events", or "events at 0.2" in a sweep.
std::string label(const ExperimentPlan& plan, std::size_t condition);

// Returns whether both conditions have the same inputs, byte by byte, and so the same result in every match.
bool equal_conditions(const ExperimentPlan& plan, const Comparison& comparison);

const char* name(PairTest test);

// A copy of the plan with more pairs. Throws std::invalid_argument if `pairs` is below the plan's number.
ExperimentPlan with_pairs(ExperimentPlan plan, std::uint64_t pairs, std::uint64_t stored_matches = 0);
// A copy of the plan without `ended_after`: a study that a time limit stopped continues until all pairs are played.
ExperimentPlan without_end(ExperimentPlan plan);

// Convert a plan to JSON and back. Reading throws std::invalid_argument for a text that to_json() cannot have written.
std::string to_json(const ExperimentPlan& plan);
ExperimentPlan experiment_plan_from_json(const std::string& text);

// The differences between the plan of a file and the new plan, in words; empty if the plans are equal.
std::vector<std::string> differences(const ExperimentPlan& before, const ExperimentPlan& now);

// Makes the plan of a document. Sets up and checks every arm at every value of the sweep before the first match.
// plugins: folders of the catalogue. mistakes: gets the mistakes; with any, the plan is incomplete. Throws
// config::BadInput, and config::Error at the place of a mistake that leaves nothing else to check.
ExperimentPlan planned_experiment(const config::Node& document, const std::vector<std::string>& plugins,
                                  const plugin::Catalogue& catalogue, config::Mistakes& mistakes);

}  // namespace regista::study
