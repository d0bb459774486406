// SPDX-License-Identifier: MIT
// A tournament as it was fixed before its first match: who plays, in which order, from which scenes, and which test
// decides. From it and the results in order everything that is said about the tournament follows.
//
// Order: pair after pair; in each, every pairing; in each of these, the match with its first team at home, then the
// same with the sides swapped. The two share seed and opening; so do all pairings of a pair, as common random numbers.
// Without a test, pair k plays the k-th opening, again from the front after the last. With one, its opening is drawn by
// its seed: a test that may stop at any pair must not have seen the scenes in an order that somebody chose.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "campaign/input.hpp"
#include "campaign/job.hpp"
#include "campaign/options.hpp"
#include "campaign/store.hpp"
#include "config/tournament.hpp"
#include "statistics/sequential_test.hpp"
#include "study/opening.hpp"
#include "study/settings.hpp"

namespace regista::study {

// No test: what is said holds for a number of pairs that was fixed beforehand.
struct FixedNumber {};

// The generalised sequential probability ratio test on the scores of pairs.
struct ScoreTest {
  statistics::SequentialDesign design;
};

// A sequential test on the difference of a value between the two teams, by betting. Two-sided, against no difference.
struct ValueTest {
  std::string value;  // "goals", or the path of a metric
  double alpha = 0.05;
};

using Objective = std::variant<FixedNumber, ScoreTest, ValueTest>;
Objective objective_of(const config::Tournament& asked);

inline constexpr const char* goals_value = "goals";

// What was found of a team.
struct Entrant {
  std::string label;
  std::vector<campaign::Input> inputs;  // campaign::team_inputs
  // What a disturbance of its own adds to inputs at home and away; none where it has that of all.
  std::vector<campaign::Input> disturbances{};
};

// Whether an input of a match is what disturbs this side: 0 home, 1 away.
bool is_disturbance(const campaign::Input& input, std::size_t side);

struct Pairing {
  std::size_t first, second;  // of the plan's teams
};

struct TournamentPlan {
  config::Tournament asked;  // files as they are seen from `folder`

  std::vector<Entrant> teams;        // as asked.teams
  std::vector<Opening> openings;     // all scenes that are asked for; none: from kick-off
  int most_goals = 0;                // largest goal difference that a match can end with; a forfeit counts as that much
  std::string pairs_before;          // numbers that it had before more were asked for: "100, 150"; empty: none
  std::string folder;                // in which it was begun, absolute
  std::vector<std::string> plugins;  // folders of --plugins
  std::string program;               // version that began it; empty: not known
  std::vector<campaign::Input> common_inputs;

  std::vector<Pairing> pairings() const;
  std::uint64_t pairs() const;  // of each pairing, at most
  std::uint64_t first_seed() const { return static_cast<std::uint64_t>(asked.seed); }
  std::uint64_t matches() const { return 2 * pairs() * pairings().size(); }
  Objective objective() const { return objective_of(asked); }
  campaign::Limits limits() const { return campaign::limits_of(asked.settings); }
  // Whether its matches may end before whole ones would.
  bool short_games() const { return !openings.empty() || asked.settings.limit; }
};

// A match of the schedule.
struct Fixture {
  std::size_t pairing = 0, home = 0, away = 0;  // home, away: teams
  bool swapped = false;                         // the pairing's second team is at home
  std::size_t opening = 0;                      // 0 where there are none
  std::uint64_t pair = 0;                       // from 0
  std::uint64_t seed = 0;
  std::size_t number = 0;  // of the fixture: equal for matches that differ in the seed alone; see fixtures()
};

// The schedule: a pure function of the plan, looked at in constant time.
class Calendar {
 public:
  explicit Calendar(const TournamentPlan& plan);
  Fixture at(std::uint64_t index) const;
  std::uint64_t matches() const { return 2 * pairs_ * pairings_.size(); }
  std::span<const Pairing> pairings() const { return pairings_; }
  // Any match of a fixture's number; its seed and pair are 0.
  Fixture of_number(std::size_t number) const;
  std::size_t fixtures() const { return 2 * pairings_.size() * openings_; }

 private:
  std::vector<Pairing> pairings_;
  std::size_t openings_;
  bool drawn_;  // openings are
  std::uint64_t pairs_, first_seed_;
};

// The team that a path of the study's `set` is for alone, by the letter that it begins with; nothing: it is for all.
std::optional<std::size_t> team_meant(const TournamentPlan& plan, const std::string& path);

// The values that are laid over the documents of a fixture's match.
config::Overrides settings_of(const TournamentPlan& plan, const Fixture& fixture);

// The match that a fixture means, as `regista match` plays it.
campaign::Job job(const TournamentPlan& plan, const Fixture& fixture);

// Every fixture of the plan, by number, with its key.
std::vector<campaign::Store::Fixture> fixtures(const TournamentPlan& plan);

// How the paths of --set name a team: "a" for the first, "b", ... "z"; empty for those beyond.
std::string letter(std::size_t team);

// Both teams are the same to the last byte, so every pair is a draw by construction.
bool equal_teams(const TournamentPlan& plan, const Pairing& pairing);

inline constexpr std::uint64_t most_pairs = 10'000'000;

// The same with more pairs of matches, which come after those there were. Throws std::invalid_argument, one line, where
// that may not be: fewer than before, or under a sequential test, whose error rates hold for the number that was fixed.
TournamentPlan with_pairs(TournamentPlan plan, std::uint64_t pairs);

// JSON; reading throws std::invalid_argument for what writing did not make.
std::string to_json(const TournamentPlan& plan);
TournamentPlan tournament_plan_from_json(const std::string& text);

// What differs between the plan of a file and the one that is asked for, in words; nothing when they are the same.
std::vector<std::string> differences(const TournamentPlan& before, const TournamentPlan& now);

}  // namespace regista::study
