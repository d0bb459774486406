// SPDX-License-Identifier: MIT
// Assigner plugin around algorithm.hpp.
#include <algorithm>
#include <numeric>
#include <vector>

#include <regista/assigner.hpp>

#include "algorithm.hpp"

namespace {

struct Greedy {
  static constexpr auto id = "greedy", version = "1.0.0",
                        summary = "Roles in order of importance, each to its best free robot";

  std::vector<std::uint32_t> order;

  void setup(const regista::Environment& environment) { order.reserve(environment.roles().size()); }
  void assign(const regista::Frame& frame, regista::UtilityMatrix utilities, regista::Assignment out) {
    if (out.size() == 0 || utilities.columns() == 0) return;
    const regista::Span<regista::Task> tasks = frame.tasks();
    order.resize(utilities.columns());
    std::iota(order.begin(), order.end(), 0u);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
      return tasks[a].priority != tasks[b].priority ? tasks[a].priority < tasks[b].priority : a < b;
    });
    greedy::assign({utilities.data(), utilities.rows(), utilities.columns(), utilities.stride()}, order,
                   {&out[0], out.size()});
  }
};

}  // namespace

REGISTA_PLUGIN(Greedy, regista::assigner)
