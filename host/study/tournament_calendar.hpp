// SPDX-License-Identifier: MIT
// The schedule of a tournament: which teams meet in which match, with which seed and scene, and the jobs of these
// matches. In Swiss and knock-out tournaments, results decide who meets in a round.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "campaign/job.hpp"
#include "campaign/store.hpp"
#include "config/overlay.hpp"
#include "study/tournament_plan.hpp"

namespace regista::study {

// --- Draws of rounds. An earlier team is seeded higher, and stands first in a pairing.

// What a Swiss tournament knows of its earlier rounds, by team.
struct SwissStanding {
  std::vector<double> points;
  std::vector<char> plays;             // 0: the team has left the tournament
  std::vector<char> had_bye;           // 1: the team has been without an opponent before
  std::vector<std::vector<char>> met;  // [i][j]: i and j have met
};

// Draws a round after Monrad: teams stand in the order of their points, and each meets the next one that it has not
// met. If that leaves teams over, the draw is changed from its end, and two teams meet again only if nothing else is
// possible. With an odd number of teams, the last team that had no bye gets one: it has no opponent in this round.
std::vector<Pairing> swiss_round(const SwissStanding& standing);

// The usual number of rounds: as many as a knock-out of these teams has.
std::size_t knock_out_rounds(std::size_t teams);

// Draws a round of a knock-out, from 0. The higher seeds meet as late as possible, and have byes in the first round if
// the number of teams is no power of two. winner: decides a meeting of an earlier round.
std::vector<Pairing> knock_out_round(std::size_t teams, std::size_t round,
                                     const std::function<std::size_t(const Pairing&)>& winner);

// --- The schedule.

// A match of the schedule.
struct Fixture {
  std::size_t pairing = 0, home = 0, away = 0;  // home, away: indices of teams
  bool swapped = false;                         // true if the pairing's second team is at home
  std::size_t opening = 0;                      // 0 without openings
  std::uint64_t pair = 0;                       // from 0
  std::uint64_t seed = 0;
  std::size_t number = 0;  // index into fixtures(); equal for matches that differ only in the seed
};

// The schedule of matches. Swiss and knock-out tournaments draw each round from the results of the rounds before; all
// other schedules depend only on the plan.
class Calendar {
 public:
  explicit Calendar(const TournamentPlan& plan);
  // Precondition: the round of the match has been drawn.
  Fixture at(std::uint64_t index) const;
  std::uint64_t matches() const { return 2 * pairs_ * meetings_; }
  std::span<const Pairing> pairings() const { return pairings_; }
  // The fixture with this Fixture::number, with seed 0 and pair 0.
  Fixture of_number(std::size_t number) const;
  std::size_t fixtures() const { return 2 * pairings_.size() * openings_; }
  // Returns how many pairs every pairing has played after the first `matches` matches; in a Swiss tournament or
  // knock-out, the number of pairs that the rounds so far gave to a team that plays in each. Returns nothing unless all
  // pairings have played equally often, or a round has just ended.
  std::optional<std::uint64_t> pairs_after(std::uint64_t matches) const;

  // The rounds of a Swiss tournament or knock-out. drawn(): for each round drawn so far, the indices of the pairings
  // that meet; draw() adds a round.
  std::uint64_t rounds() const { return rounds_; }  // 0: the schedule does not depend on results
  std::span<const std::vector<std::size_t>> drawn() const { return drawn_; }
  void draw(std::vector<std::size_t> pairings);
  std::uint64_t drawn_matches() const { return first_of_round_.back(); }
  std::size_t index_of(const Pairing& teams) const;

 private:
  std::vector<Pairing> pairings_;
  std::size_t openings_;
  bool opening_by_chance_;  // drawn_opening() selects the openings
  std::uint64_t pairs_, meetings_, rounds_, first_seed_;
  std::vector<std::vector<std::size_t>> drawn_;
  std::vector<std::uint64_t> first_of_round_{0};  // index of the first match of each drawn round, and of the next round
};

// The settings of the study that replace values in the documents of a fixture's match.
config::Overrides settings_of(const TournamentPlan& plan, const Fixture& fixture);

// The job of a fixture's match. `regista match` plays the same job.
campaign::Job job(const TournamentPlan& plan, const Fixture& fixture);

// All matches of the plan without their seeds, with their keys, in the order of Fixture::number.
std::vector<campaign::Store::Fixture> fixtures(const TournamentPlan& plan);

}  // namespace regista::study
