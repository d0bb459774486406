// SPDX-License-Identifier: MIT
// The numbers of one match under their names. Many matches have the same names, which are kept once.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "match/side.hpp"

namespace regista::match {

struct MetricName {
  std::optional<Side> side{};  // nothing: of the match as a whole
  std::string role{};          // empty: of none
  std::string name{};          // "overlap_seconds", "world_model.ball.nees"
  int place = 0;               // in a list, from 1; 0: of none
  // "striker.overlap_seconds"; of a list "budget_curve.3"
  std::string path() const;
  friend bool operator==(const MetricName&, const MetricName&) = default;
};

// What the numbers of a match are called, in their order.
class MetricNames {
 public:
  // Throws std::invalid_argument for a path that stands there twice.
  explicit MetricNames(std::vector<MetricName> names);

  std::size_t size() const { return names_.size(); }
  const MetricName& operator[](std::size_t i) const { return names_[i]; }
  const std::string& path(std::size_t i) const { return paths_[i]; }

  // Places of the numbers of a side that are of no list, in their order.
  const std::vector<std::size_t>& of(Side side) const { return sides_[index(side)].numbers; }

  // The same of the match as a whole.
  const std::vector<std::size_t>& of_match() const { return of_match_; }

  // Of a name that only roles have: the places of all of them.
  struct Sum {
    std::string name;
    std::vector<std::size_t> places;
  };
  const std::vector<Sum>& sums(Side side) const { return sides_[index(side)].sums; }

  // The place of a number that is of no list; side: nothing for one of the whole match.
  std::optional<std::size_t> find(std::optional<Side> side, std::string_view path) const;

  friend bool operator==(const MetricNames& a, const MetricNames& b) { return a.names_ == b.names_; }

 private:
  struct OfSide {
    std::vector<std::size_t> numbers;
    std::vector<Sum> sums;
  };
  std::vector<MetricName> names_;
  std::vector<std::string> paths_;
  std::vector<std::size_t> sorted_;  // by side and path
  std::array<OfSide, 2> sides_;
  std::vector<std::size_t> of_match_;
};

// Paths that many matches have, of numbers that are of no list.
struct MetricPaths {
  std::vector<std::string> of_teams;  // each has one
  std::vector<std::string> of_match;

  bool empty() const { return of_teams.empty() && of_match.empty(); }
  friend bool operator==(const MetricPaths&, const MetricPaths&) = default;
};

// Empty for a match that was not played to its end: missing, not zero.
class MetricNumbers {
 public:
  MetricNumbers() = default;
  // values: as many as names; not a number where a match has none.
  MetricNumbers(std::shared_ptr<const MetricNames> names, std::vector<double> values);

  bool empty() const { return names_ == nullptr; }
  const MetricNames& names() const { return *names_; }  // not of empty ones
  const std::shared_ptr<const MetricNames>& shared_names() const { return names_; }
  std::span<const double> values() const { return values_; }
  std::optional<double> at(std::size_t place) const;

  // A number of the whole match, such as "playing_seconds"; nothing where there is none.
  std::optional<double> of_match(std::string_view name) const;
  // One of a side. A name that only roles have is the sum over all its roles. "roles." may stand before a role.
  std::optional<double> of_side(Side side, std::string_view path) const;
  // The sum of those roles that have a number; nothing where none has.
  std::optional<double> sum(const MetricNames::Sum& sum) const;

  // The same names and the same bits.
  friend bool operator==(const MetricNumbers& a, const MetricNumbers& b);

 private:
  std::shared_ptr<const MetricNames> names_;
  std::vector<double> values_;
};

// A path of a role may be written with "roles." before it; it is one path all the same: this one, without.
std::string_view without_roles(std::string_view path);

}  // namespace regista::match
