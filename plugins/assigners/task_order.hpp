// SPDX-License-Identifier: MIT
// Orders in which assigners look at tasks. Glue of several plugins.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <regista/frame.hpp>

namespace assignment {

// By priority; among equals, by column. Writes every column of the frame's tasks once, the most important first, and
// returns them. By insertion: there are few tasks, and they mostly come in order.
inline std::span<const std::uint32_t> by_importance(const regista::Span<regista::Task>& tasks,
                                                    std::vector<std::uint32_t>& order) {
  order.resize(tasks.size());
  for (std::size_t j = 0; j < tasks.size(); ++j) {
    std::size_t place = j;
    for (; place > 0 && tasks[order[place - 1]].priority > tasks[j].priority; --place) order[place] = order[place - 1];
    order[place] = static_cast<std::uint32_t>(j);
  }
  return order;
}

// The order in which tasks are kept when not all can be done: of `order` (by_importance) the task `first` if any, then
// those that the team's page requires, then the rest. `choice` is filled from its beginning.
inline void by_need(const regista::Span<regista::Task>& tasks, std::span<const std::uint32_t> order,
                    std::vector<std::uint32_t>& choice, std::optional<std::size_t> first = std::nullopt) {
  choice.clear();
  for (const int wanted : {2, 1, 0}) {
    for (const std::uint32_t column : order) {
      const int rank = first == column ? 2 : (tasks[column].flags & REGISTA_TASK_REQUIRED) != 0 ? 1 : 0;
      if (rank == wanted) choice.push_back(column);
    }
  }
}

}  // namespace assignment
