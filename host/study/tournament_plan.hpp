// SPDX-License-Identifier: MIT
// The plan of a tournament: teams, order of matches, scenes and the deciding test.
//
// The order of matches, from the outer to the inner loop, is: pairs, pairings, and the two matches of a pairing. The
// pairing's first team is at home in the first match; the second match is the same with the sides swapped. All matches
// of pair k have the same seed and opening, in all pairings (common random numbers). Without a test, pair k plays
// opening k modulo the number of openings. With a test, drawn_opening() selects the opening.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "campaign/job.hpp"
#include "config/errors.hpp"
#include "config/node.hpp"
#include "config/tournament.hpp"
#include "plugin/catalogue.hpp"
#include "statistics/sequential_test.hpp"
#include "study/settings.hpp"

namespace regista::study {

// No sequential test. The findings hold for the number of pairs that was fixed beforehand.
struct FixedNumber {};

// The generalised sequential probability ratio test on the scores of pairs.
struct ScoreTest {
  statistics::SequentialDesign design;
};

// A sequential, two-sided test by betting on the difference of a value between the two teams.
struct ValueTest {
  std::string value;  // "goals", or the path of a metric
  double alpha = 0.05;
};

using Objective = std::variant<FixedNumber, ScoreTest, ValueTest>;
Objective objective_of(const config::Tournament& asked);

inline constexpr const char* goals_value = "goals";

// A team, with the facts that the program found when it made the plan.
struct Entrant {
  std::string label;                    // the team's name, told apart from equal names
  std::vector<campaign::Input> inputs;  // from campaign::team_inputs()
  // The inputs of the team's own disturbance, at home and away; empty if the team has no disturbance of its own.
  std::vector<campaign::Input> disturbances{};
  std::string title{};  // shown to people in place of the label; empty: the label

  const std::string& shown() const { return title.empty() ? label : title; }
};

// Returns whether an input of a match is the disturbance of this side: 0 home, 1 away.
bool is_disturbance(const campaign::Input& input, std::size_t side);

struct Pairing {
  std::size_t first, second;  // indices of the plan's teams
  friend auto operator<=>(const Pairing&, const Pairing&) = default;
};

struct TournamentPlan : StudyPlan<config::Tournament> {
  std::vector<Entrant> teams;  // in the order of asked.teams
  int most_goals = 0;          // largest goal difference that a match can have, also a forfeit
  std::string pairs_before;    // values of pairs() before with_pairs() raised it: "100, 150"
  // Set if a time limit (--until, --minutes), not a result, stopped the tournament: the number of pairs that each
  // pairing played until then.
  std::optional<std::uint64_t> ended_after;
  std::vector<campaign::Input> common_inputs;

  std::vector<Pairing> pairings() const;  // all pairings that may meet
  std::uint64_t pairs() const;            // most pairs that each pairing (Swiss, knock-out: each meeting) plays
  std::uint64_t rounds() const;           // 0: the schedule does not depend on results
  std::uint64_t pairs_to_its_end() const { return ended_after.value_or(pairs()); }
  std::string_view open_end() const;  // see Study::open_end()
  std::uint64_t matches() const { return 2 * pairs() * meetings(); }
  std::uint64_t meetings() const;  // number of meetings of two teams
  Objective objective() const { return objective_of(asked); }
};

// The team whose letter() is the first key of a path of the study's `set`; nullopt: the path is for all teams.
std::optional<std::size_t> team_meant(const TournamentPlan& plan, const std::string& path);

// The letter of a team in the paths of --set: "a" for the first team, "b", ... "z"; empty for later teams.
std::string letter(std::size_t team);

// Returns whether both teams have the same inputs, byte by byte. Every pair of such teams is a draw.
bool equal_teams(const TournamentPlan& plan, const Pairing& pairing);

inline constexpr std::uint64_t most_pairs = 10'000'000;

// A copy of the plan with more pairs. Throws std::invalid_argument if `pairs` is below the plan's number. Throws
// std::invalid_argument also for a sequential test, because the test's error rates hold only for the planned number.
// stored_matches: what a study that the clock has to end has played so far.
TournamentPlan with_pairs(TournamentPlan plan, std::uint64_t pairs, std::uint64_t stored_matches = 0);

// A copy of the plan without `ended_after`: a study that a time limit stopped continues until all pairs are played.
TournamentPlan without_end(TournamentPlan plan);

// Returns the document; if it has neither pairs nor a test, with most_pairs pairs, so that only a time limit (--until,
// --minutes) ends the tournament.
config::Node until_the_clock(const config::Node& document);

// Convert a plan to JSON and back. Reading throws std::invalid_argument for a text that to_json() cannot have written.
std::string to_json(const TournamentPlan& plan);
TournamentPlan tournament_plan_from_json(const std::string& text);

// The differences between the plan of a file and the new plan, in words; empty if the plans are equal.
std::vector<std::string> differences(const TournamentPlan& before, const TournamentPlan& now);

struct PlannedTournament {
  TournamentPlan plan;
  std::vector<std::string> documents;  // resolved documents of the teams, which the plan's hashes identify
};

// Makes the plan of a document. Reads and checks everything before the first match. plugins: folders of the catalogue.
// mistakes: gets the mistakes in teams and scenes; with any, there is no plan. Throws config::BadInput, and
// config::Error at the place of a mistake that leaves nothing else to check.
PlannedTournament planned_tournament(const config::Node& document, const std::vector<std::string>& plugins,
                                     const plugin::Catalogue& catalogue, config::Mistakes& mistakes);

}  // namespace regista::study
