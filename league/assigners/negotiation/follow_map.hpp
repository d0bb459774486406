// SPDX-License-Identifier: MIT
// A map that was told, carried out by robots that may know other tasks than who made it: those that it leaves without a
// task take over what it leaves open, in an order that all of them can compute. Our choice; not published.
//
//   1. Who has a task by the map, knows it and may do it, does it.
//   2. Who has none by the map, or one that it must not do, takes the most important task that is open then; the robots
//      in order of their numbers.
//   3. Then, in the same way, who has a task by the map that is not known here. Its own robot may know it well, so that
//      it comes last: nobody that knows all tasks is in its way.
//
// Open are the tasks known here that no robot which plays here has by the map: also those of robots that left.
#pragma once

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "told_map.hpp"

namespace scram {

// The robots that play here and the tasks that are known here, as rows and columns.
struct Here {
  std::span<const std::int32_t> numbers;  // by row, ascending
  std::span<const std::int32_t> ids;      // by column
  std::span<const std::uint32_t> order;   // columns, the most important first
};

inline constexpr std::int32_t no_column = -1;

inline std::int32_t column_of(const Here& here, std::int32_t id) {
  const auto found = std::find(here.ids.begin(), here.ids.end(), id);
  return found == here.ids.end() || id < 0 ? no_column : static_cast<std::int32_t>(found - here.ids.begin());
}

// Whether the map was made for just the robots that play here.
inline bool has_members(std::span<const std::int32_t> map, std::span<const std::int32_t> numbers) {
  std::size_t row = 0;
  for (std::size_t robot = 0; robot < map.size(); ++robot) {
    const bool plays = row < numbers.size() && numbers[row] == static_cast<std::int32_t>(robot + 1);
    row += plays ? 1 : 0;
    if (plays != (map[robot] != away)) return false;
  }
  return row == numbers.size();
}

// Whether the map is about the tasks here: at least half of those that it gives are known here, and it gives some.
inline bool is_about(std::span<const std::int32_t> map, const Here& here) {
  std::size_t given = 0, known = 0;
  for (const std::int32_t task : map) {
    if (task < 0) continue;
    ++given;
    known += column_of(here, task) != no_column ? 1 : 0;
  }
  return given > 0 && 2 * known >= given;
}

class Follower {
 public:
  void reserve(std::size_t columns) { open_.reserve(columns); }

  // out[row] := column or no_column. may(row, column): whether the pair is allowed.
  template <class May>
  void follow(std::span<const std::int32_t> map, const Here& here, const May& may, std::span<std::int32_t> out) {
    assert(out.size() == here.numbers.size() && here.order.size() == here.ids.size());
    std::fill(out.begin(), out.end(), no_column);
    open_.assign(here.ids.size(), 1);
    for (std::size_t row = 0; row < out.size(); ++row) {
      const std::int32_t column = column_of(here, given_to(map, here, row));
      if (column == no_column || !may(row, static_cast<std::size_t>(column))) continue;
      out[row] = column;
      open_[static_cast<std::size_t>(column)] = 0;
    }
    for (const bool unknown : {false, true}) {
      for (std::size_t row = 0; row < out.size(); ++row) {
        const std::int32_t task = given_to(map, here, row);
        const bool has_unknown = task >= 0 && column_of(here, task) == no_column;
        if (out[row] == no_column && has_unknown == unknown) out[row] = take(here, row, may);
      }
    }
  }

 private:
  static std::int32_t given_to(std::span<const std::int32_t> map, const Here& here, std::size_t row) {
    return map[static_cast<std::size_t>(here.numbers[row] - 1)];
  }
  template <class May>
  std::int32_t take(const Here& here, std::size_t row, const May& may) {
    for (const std::uint32_t column : here.order) {
      if (open_[column] == 0 || !may(row, std::size_t{column})) continue;
      open_[column] = 0;
      return static_cast<std::int32_t>(column);
    }
    return no_column;
  }

  std::vector<std::uint8_t> open_;
};

}  // namespace scram
