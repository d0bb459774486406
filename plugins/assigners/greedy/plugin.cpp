// SPDX-License-Identifier: MIT
// Assigner plugin around algorithm.hpp.
#include <vector>

#include <regista/assigner.hpp>

#include "../task_order.hpp"
#include "algorithm.hpp"

namespace {

struct Greedy {
  static constexpr auto id = "greedy", version = "1.0.0",
                        summary = "Roles in order of importance, each to its best free robot";
  static constexpr unsigned reads = REGISTA_READS_NOTHING;

  std::vector<std::uint32_t> order;

  void setup(const regista::Environment& environment) { order.reserve(environment.roles().size()); }
  void assign(const regista::Frame& frame, regista::UtilityMatrix utilities, regista::Assignment out) {
    if (out.size() == 0 || utilities.columns() == 0) return;
    greedy::assign({utilities.data(), utilities.rows(), utilities.columns(), utilities.stride()},
                   assignment::by_importance(frame.tasks(), order), {&out[0], out.size()});
  }
};

}  // namespace

REGISTA_PLUGIN(Greedy, regista::assigner)
