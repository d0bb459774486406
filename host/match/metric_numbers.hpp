// SPDX-License-Identifier: MIT
// MetricNumbers has the metric values of one match; MetricNames, shared by matches with equal names, has their names.
#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "match/side.hpp"

namespace regista::match {

struct MetricName {
  std::optional<Side> side{};  // nothing: the number belongs to the whole match
  std::string role{};          // empty: the number belongs to no role
  std::string name{};          // such as "overlap_seconds" or "world_model.ball.nees"
  int place = 0;               // position in a list of numbers, from 1; 0: the number is not in a list
  // Returns a path such as "striker.overlap_seconds"; "budget_curve.3" for element 3 of a list.
  std::string path() const;
  friend bool operator==(const MetricName&, const MetricName&) = default;
};

// The names of all numbers of a match, in the order of MetricNumbers::values().
class MetricNames {
 public:
  // Throws std::invalid_argument if two numbers of a side, or two of the whole match, have equal paths.
  explicit MetricNames(std::vector<MetricName> names);

  std::size_t size() const { return names_.size(); }
  const MetricName& operator[](std::size_t i) const { return names_[i]; }
  const std::string& path(std::size_t i) const { return paths_[i]; }

  // The indices of a side's numbers, ascending. Elements of lists are left out.
  const std::vector<std::size_t>& of(Side side) const { return sides_[index(side)].numbers; }

  // The indices of the numbers of the whole match, ascending. Elements of lists are left out.
  const std::vector<std::size_t>& of_match() const { return of_match_; }

  struct Sum {  // The indices of all role numbers with the name `name`. No Sum has the name of a team's own number.
    std::string name;
    std::vector<std::size_t> places;
  };
  const std::vector<Sum>& sums(Side side) const { return sides_[index(side)].sums; }

  // Returns the index of a number; nothing for an unknown path or a list. side: nothing for one of the whole match.
  std::optional<std::size_t> find(std::optional<Side> side, std::string_view path) const;

  friend bool operator==(const MetricNames& a, const MetricNames& b) { return a.names_ == b.names_; }

 private:
  struct OfSide {
    std::vector<std::size_t> numbers;
    std::vector<Sum> sums;
  };
  std::vector<MetricName> names_;
  std::vector<std::string> paths_;
  std::vector<std::size_t> sorted_;  // indices sorted by side and path
  std::array<OfSide, 2> sides_;
  std::vector<std::size_t> of_match_;
};

// Paths of numbers to be read from many matches. Elements of lists cannot be read.
struct MetricPaths {
  std::vector<std::string> of_teams;  // each path names one number of each team
  std::vector<std::string> of_match;  // each path names one number of the whole match

  bool empty() const { return of_teams.empty() && of_match.empty(); }
  friend bool operator==(const MetricPaths&, const MetricPaths&) = default;
};

// The numbers of one match. The object is empty if the match was not played to its end.
class MetricNumbers {
 public:
  MetricNumbers() = default;
  // values: one value for each name; NaN if the match has no value for the name.
  MetricNumbers(std::shared_ptr<const MetricNames> names, std::vector<double> values);

  bool empty() const { return names_ == nullptr; }
  const MetricNames& names() const { return *names_; }  // must not be called for an empty object
  const std::shared_ptr<const MetricNames>& shared_names() const { return names_; }
  std::span<const double> values() const { return values_; }
  std::optional<double> at(std::size_t place) const;  // place: index of a name

  // Returns a number of the whole match, such as "playing_seconds"; nothing if the match has no such number.
  std::optional<double> of_match(std::string_view name) const;
  // Returns a number of one side; for a name that only roles have, the sum over roles. `path` may begin with "roles.".
  std::optional<double> of_side(Side side, std::string_view path) const;
  // Returns the sum over the roles that have a value; nothing if no role has a value.
  std::optional<double> sum(const MetricNames::Sum& sum) const;

  // Returns whether all names are equal and all values have equal bits.
  friend bool operator==(const MetricNumbers& a, const MetricNumbers& b);

 private:
  std::shared_ptr<const MetricNames> names_;
  std::vector<double> values_;
};

// Returns the path without a leading "roles.": "roles.striker.switches" and "striker.switches" name the same number.
std::string_view without_roles(std::string_view path);

// Names of numbers of packets that a team sent. Only a match that is shorter than a whole match (an opening, a time
// limit) but has the packets of a whole match has more than "packets".
inline constexpr std::array<const char*, 3> packet_metrics{"packets", "packets_share", "packets_over_share"};

inline MetricPaths packet_paths() {
  return {.of_teams = {packet_metrics.begin(), packet_metrics.end()}, .of_match = {}};
}

// Reads the same paths from many matches. Looks up the indices once for all matches that share one MetricNames.
class MetricColumns {
 public:
  explicit MetricColumns(MetricPaths paths = {});

  const MetricPaths& paths() const { return paths_; }
  // Returns two numbers, home then away, for each path of of_teams, and then one number for each path of of_match. A
  // number is nothing if this match has no value. The result is valid until the next call.
  std::span<const std::optional<double>> of(const MetricNumbers& numbers);

 private:
  using Places = std::vector<std::optional<std::size_t>>;
  const Places& places_in(const std::shared_ptr<const MetricNames>& names);

  MetricPaths paths_;
  std::map<std::shared_ptr<const MetricNames>, Places> places_;
  std::vector<std::optional<double>> values_;
};

}  // namespace regista::match
