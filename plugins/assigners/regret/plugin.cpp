// SPDX-License-Identifier: MIT
// Assigner plugin around algorithm.hpp.
#include <vector>

#include <regista/assigner.hpp>

#include "../task_order.hpp"
#include "algorithm.hpp"

namespace {

struct Regret {
  static constexpr auto id = "regret", version = "1.0.0",
                        summary = "Repeatedly the robot with most to lose takes its best free task";
  static constexpr unsigned reads = REGISTA_READS_NOTHING;

  regret::Solver solver;
  std::vector<std::uint32_t> order;

  void setup(const regista::Environment& environment) {
    order.reserve(environment.roles().size());
    solver.reserve(environment->team_size, environment.roles().size());
  }
  void assign(const regista::Frame& frame, regista::UtilityMatrix utilities, regista::Assignment out) {
    if (out.size() == 0 || utilities.columns() == 0) return;
    solver.assign({utilities.data(), utilities.rows(), utilities.columns(), utilities.stride()},
                  assignment::by_importance(frame.tasks(), order), {&out[0], out.size()});
  }
};

}  // namespace

REGISTA_PLUGIN(Regret, regista::assigner)
