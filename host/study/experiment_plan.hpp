// SPDX-License-Identifier: MIT
// An experiment as it was fixed before its first match: arms, values of a sweep, seeds, how many matches, what is
// measured and which test decides. From it and the results in order everything that is said follows.
//
// A condition is an arm at a value of the sweep (or an arm, without a sweep). Pair k of every condition has the seed of
// the first plus k - 1 and the same opening: a match with the arm's team at home, then the same with the sides swapped,
// against the same opponent. So conditions differ in nothing but what they are about, and are compared pair by pair
// (common random numbers: A. M. Law, "Simulation Modeling and Analysis", chapter 11).
//
// Order: pair after pair; in each, every value; at each of these, every arm; of each, home, then away. Whenever it is
// stopped, all conditions have been played equally often, but for the pair under way.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "campaign/input.hpp"
#include "campaign/job.hpp"
#include "campaign/options.hpp"
#include "campaign/store.hpp"
#include "config/experiment.hpp"
#include "study/opening.hpp"

namespace regista::study {

struct Condition {
  std::size_t arm = 0, value = 0;     // value: 0 where there is no sweep
  std::array<campaign::Job, 2> jobs;  // the arm's team at home, away; without seed, opening and recording
};

// Of two conditions: first less second.
struct Comparison {
  std::size_t first = 0, second = 0;
};

using PairTest = config::PairedTest;

struct ExperimentPlan {
  config::Experiment asked;  // files as they are seen from `folder`

  std::vector<Condition> conditions;   // of their jobs the inputs were found; all else is asked for: see make_jobs()
  std::vector<Opening> openings;       // all scenes that are asked for; none: from kick-off
  std::uint64_t pairs = 0;             // of matches, for each condition
  std::vector<std::string> measures;   // that are shown, in this order; see study/measure.hpp
  std::string folder;                  // in which it was begun, absolute
  std::vector<std::string> plugins;    // folders of --plugins
  std::string program;                 // version that began it; empty: not known
  std::vector<std::string> documents;  // of the arms' teams at the first value, resolved; then of the opponent

  std::size_t arms() const { return asked.arms.size(); }
  std::size_t values() const { return asked.sweep ? asked.sweep->values.size() : 1; }
  std::size_t condition(std::size_t arm, std::size_t value) const { return value * arms() + arm; }
  std::uint64_t matches() const { return 2 * pairs * conditions.size(); }
  std::uint64_t first_seed() const { return static_cast<std::uint64_t>(asked.seed); }
  bool swept() const { return asked.sweep.has_value(); }
  std::string sweep() const { return swept() ? asked.sweep->path : std::string(); }
  std::string value(std::size_t index) const;  // of the sweep, as YAML; empty without one
  std::vector<std::string> value_texts() const;
  std::string primary() const;  // measure that is tested; empty: none
  PairTest test() const { return asked.primary ? asked.primary->test : PairTest::paired_t; }
  std::vector<Comparison> comparisons() const;
  campaign::Limits limits() const { return campaign::limits_of(asked.settings); }
};

// File of an arm's team.
const std::string& team_of(const ExperimentPlan& plan, std::size_t arm);

// Every condition, with jobs as they are asked for; inputs that they have stay. document: that asked was read from,
// for the places of errors; may be absent. Throws config::Error for settings that cannot be.
void make_jobs(ExperimentPlan& plan, const config::Node& document);

// A match of the schedule.
struct Trial {
  std::size_t condition = 0, side = 0;  // side: of the arm's team, 0 home
  std::size_t opening = 0;              // 0 where there are none
  std::uint64_t pair = 0;               // from 0
  std::uint64_t seed = 0;
  std::size_t number = 0;  // of the fixture: equal for matches that differ in the seed alone; see fixtures()
};

// Precondition: index < plan.matches(). Constant time.
Trial trial(const ExperimentPlan& plan, std::uint64_t index);

// The match of a trial, as `regista match` plays it.
campaign::Job job(const ExperimentPlan& plan, const Trial& trial);

// Every fixture of the plan, by number, with its key.
std::vector<campaign::Store::Fixture> fixtures(const ExperimentPlan& plan);

// "events", or of a sweep "events at 0.2"
std::string label(const ExperimentPlan& plan, std::size_t condition);

// Both conditions are the same to the last byte, so they differ in nothing by construction.
bool equal_conditions(const ExperimentPlan& plan, const Comparison& comparison);

const char* name(PairTest test);

// JSON; reading throws std::invalid_argument for what writing did not make.
std::string to_json(const ExperimentPlan& plan);
ExperimentPlan experiment_plan_from_json(const std::string& text);

// What differs between the plan of a file and the one that is asked for, in words; nothing when they are the same.
std::vector<std::string> differences(const ExperimentPlan& before, const ExperimentPlan& now);

}  // namespace regista::study
