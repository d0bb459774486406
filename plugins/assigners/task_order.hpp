// SPDX-License-Identifier: MIT
// The order in which assigners look at tasks: by priority; among equals, by column. Glue of several plugins.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <regista/frame.hpp>

namespace assignment {

// Writes every column of the frame's tasks once, the most important first, and returns them. By insertion: there are
// few tasks, and they mostly come in order.
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

}  // namespace assignment
