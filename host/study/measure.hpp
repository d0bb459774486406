// SPDX-License-Identifier: MIT
// The measures of an experiment: numbers of one team in one match. "goals", "goals_against", "goal_difference" and
// "points" (1 for a win, 1/2 for a draw) come from the score. All other measures are paths of the match's metrics, see
// match/metric_table.hpp. Times are given as minutes in 60 minutes of play, so that matches of different lengths are
// comparable. All other measures are given per match.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "campaign/job.hpp"
#include "match/metric_numbers.hpp"
#include "statistics/moments.hpp"

namespace regista::study {

// A number with its path (match/metric_table.hpp): "striker.overlap_seconds", "packets_by_reason.role_changed". If a
// number exists only for roles, such as "overlap_seconds", its path without a role names the sum over all roles.
struct NamedValue {
  std::string path;
  double value;
};
// metric_values(): the numbers of one side (0 home, 1 away). metric_values_of_match(): the numbers of the match as a
// whole. all_metric_values(): the numbers of one side, then their sums over the roles of this side.
std::vector<NamedValue> metric_values(const match::MetricNumbers& metrics, int side);
std::vector<NamedValue> metric_values_of_match(const match::MetricNumbers& metrics);
std::vector<NamedValue> all_metric_values(const match::MetricNumbers& metrics, int side);

inline constexpr double no_value = std::numeric_limits<double>::quiet_NaN();  // value of pairs that lack the measure

inline constexpr std::array<const char*, 4> measures_of_score{"goals", "goals_against", "goal_difference", "points"};

// Returns whether match::metric_table() lists the measure as a time, such as "striker.overlap_seconds".
bool is_time(std::string_view measure);

// Returns "min per 60 min" for a time, "per match" for any other measure.
const char* unit_of(std::string_view measure);

// The value of a pair of matches in the unit of the measure. sum: the sum of the measure over both matches.
// playing_seconds: the seconds of both matches in the phase Playing. Returns NaN for a time if playing_seconds is 0.
double pair_in_unit(std::string_view measure, double sum, double playing_seconds);

// The value of a measure of the score for the team on this side (0 home, 1 away); nullopt for any other measure.
std::optional<double> measure_of_score(std::string_view measure, const campaign::MatchResult& decided, int side);

// The measures of the team on one side of a match that was played to its end.
class MatchMeasures {
 public:
  MatchMeasures(const campaign::MatchResult& decided, int side);

  // The value of a measure; times are in seconds. nullopt if the match does not have the measure.
  std::optional<double> value(const std::string& measure) const;
  const std::vector<NamedValue>& all() const { return values_; }  // measures of the score come first
  double playing_seconds() const { return playing_seconds_; }

 private:
  std::vector<NamedValue> values_;
  double playing_seconds_;
};

// --- Packets of a team in short games, which end earlier than a whole match. Unless the rules say otherwise, a short
// game has the packet budget of a whole match. So a team may look good because it sends packets at a rate that the
// budget of a whole match does not allow on average. Reports therefore show the number of packets beside the team's
// share, which is the budget times (length of the game / length of a whole match).

// Why the matches of a study do not have this metric, in words; empty if they have the metric.
std::string why_missing(std::string_view metric, bool short_games);

// Returns whether a team spent over 1.05 times its share. over: packets spent minus share. A game that ends between
// packets may cause a small excess.
inline bool is_above_share(double over, double share) { return over > 0.05 * share && over > 0.0; }

// The packets of one team in one game: number sent, and the team's share of the budget.
struct ShortGamePackets {
  double spent = 0.0, share = 0.0;
  double over = 0.0;  // spent minus share
};

// Reads the packets of both teams from the metrics of a match. One object serves for many matches.
class PacketsOfShortGames {
 public:
  // The packets of both sides; nullopt if a side lacks one of the metrics match::packet_paths().
  std::optional<std::array<ShortGamePackets, 2>> of(const match::MetricNumbers& metrics);

 private:
  match::MetricColumns columns_{match::packet_paths()};
};

// The mean packets of one team over many games.
class PacketsSpent {
 public:
  void add(const ShortGamePackets& game);

  std::int64_t games() const { return spent_.count(); }
  double spent() const { return spent_.mean(); }
  double share() const { return share_.mean(); }
  double over() const { return over_.mean(); }  // spent() - share() is rounded differently
  bool above_share() const { return is_above_share(over(), share()); }

 private:
  statistics::Moments spent_, share_, over_;
};

// --- Facts about single matches that reports show besides the results: forfeits, matches that could not be played,
// matches whose second play differed from the first, matches in which a robot used more than its own knowledge, and
// matches in which plugins wrote to standard error. The memory does not grow with the number of matches.

// Matches that a team forfeited for the same reason.
struct Forfeits {
  std::size_t team = 0;  // number that the study gives the team
  campaign::Failure failure;
  std::uint64_t first_match = 0, count = 0;
};

// A list of forfeits. Each entry has one reason, the first match with this reason and the number of these matches.
class ForfeitList {
 public:
  explicit ForfeitList(std::size_t teams) : of_team_(teams, 0) {}

  void add(std::size_t team, const campaign::Failure& failure, std::uint64_t match);

  const std::vector<Forfeits>& listed() const { return listed_; }  // sorted by the reason's first match
  std::uint64_t unlisted() const { return unlisted_; }             // forfeits with a reason after the first 100 reasons
  const std::vector<std::uint64_t>& of_team() const { return of_team_; }

 private:
  std::vector<Forfeits> listed_;
  std::vector<std::uint64_t> of_team_;
  std::uint64_t unlisted_ = 0;
};

struct MatchRemark {
  std::uint64_t match = 0;  // number in the schedule, from 0
  std::string text;         // one line
  friend bool operator==(const MatchRemark&, const MatchRemark&) = default;
};

class RemarkList {
 public:
  static constexpr std::size_t most_listed = 100;

  void add(std::uint64_t match, const std::string& text);

  const std::vector<MatchRemark>& listed() const { return listed_; }  // the first most_listed remarks
  std::uint64_t count() const { return count_; }                      // number of all remarks
  std::uint64_t unlisted() const { return count_ - listed_.size(); }

 private:
  std::vector<MatchRemark> listed_;
  std::uint64_t count_ = 0;
};

// The study ends when this number of matches of one pairing could not be played and no team caused this.
inline constexpr std::uint64_t most_set_aside = 3;
// The message when most_set_aside ends a study. who: the pairing, "a against b". last: why the last match failed.
std::string why_unplayable(const std::string& who, const std::string& last);

struct MatchRemarks {
  static constexpr std::size_t most_written = 20;

  RemarkList unplayed;                 // why the matches could not be played
  RemarkList irreproducible;           // first difference between two plays of a match
  RemarkList shared;                   // the plugin that used more than its own robot knows
  RemarkList broken;                   // the promise that a plugin broke in a play with all checks
  RemarkList kept;                     // plugin state outside objects that changed no match
  RemarkList unproven;                 // why a second play could not show that robots decide alone
  std::vector<std::uint64_t> written;  // the first most_written matches in which plugins wrote to standard error
  std::uint64_t written_count = 0;     // number of all such matches

  // Precondition: the caller passes the matches in the order of the schedule.
  void take(std::uint64_t match, const campaign::MatchResult& decided);
};

}  // namespace regista::study
