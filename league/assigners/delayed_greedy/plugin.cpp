// SPDX-License-Identifier: MIT
// Assigner plugin around algorithm.hpp.
#include <algorithm>
#include <span>
#include <vector>

#include <plugins/assigners/task_order.hpp>
#include <regista/assigner.hpp>

#include "../negotiation/bids.hpp"
#include "algorithm.hpp"

namespace {

struct DelayedGreedy {
  static constexpr auto id = "delayed_greedy", version = "1.0.0",
                        summary = "Greedy, but a robot changes its role only a second after it should";
  static constexpr unsigned reads = REGISTA_READS_PREVIOUS;

  delayed_greedy::Settings settings;
  static constexpr std::tuple parameters{regista::within(
      &DelayedGreedy::settings,
      regista::real("after", &delayed_greedy::Settings::after, {0.0, 60.0}, "s",
                    "Time from the first difference between computed and present role to the change; SPQR 2022: 1")
          .tunable(),
      regista::boolean("lasting", &delayed_greedy::Settings::lasting,
                       "The difference must last for so long; no in SPQR 2022, which takes what is computed when the "
                       "time has come"))};

  delayed_greedy::Delay delay;
  std::vector<std::uint32_t> order;
  std::vector<double> scratch;
  std::vector<std::int32_t> assigned;

  void setup(const regista::Environment& environment) {
    order.reserve(environment.roles().size());
    scratch.reserve(environment->team_size * environment.roles().size());
    assigned.reserve(environment->team_size);
  }
  void reset(std::uint64_t) { delay.forget(); }

  void assign(const regista::Frame& frame, regista::UtilityMatrix utilities, regista::Assignment out) {
    const regista::Span<regista::Task> tasks = frame.tasks();
    const delayed_greedy::Matrix matrix{utilities.data(), utilities.rows(), utilities.columns(), utilities.stride()};
    assignment::by_importance(tasks, order);
    assigned.assign(out.size(), regista::Assignment::no_task);
    greedy::assign(matrix, order, assigned);
    const std::size_t own = negotiation::row_of(frame.world().active(), frame.own_number());
    if (own == out.size()) {
      delay.forget();
    } else {
      keep_own(frame, matrix, own);
    }
    for (std::size_t row = 0; row < out.size(); ++row) out[row] = assigned[row];
  }

 private:
  void keep_own(const regista::Frame& frame, const delayed_greedy::Matrix& utilities, std::size_t own) {
    const regista::Span<regista::Task> tasks = frame.tasks();
    const std::int32_t computed = assigned[own];
    const int wanted = computed < 0 ? delayed_greedy::no_task : tasks[static_cast<std::size_t>(computed)].id;
    const int has = frame.previous_task(frame.own_number());
    const std::size_t column = negotiation::column_of(tasks, has);
    const bool keeps = column < tasks.size() && utilities(own, column) != delayed_greedy::forbidden;
    if (delay.changes(settings, frame.time(), has, wanted, keeps)) return;
    scratch.resize(utilities.rows * utilities.columns);
    std::ranges::fill(assigned, regista::Assignment::no_task);
    delayed_greedy::assign_beside(utilities, order, own, column, scratch, assigned);
  }
};

}  // namespace

REGISTA_PLUGIN(DelayedGreedy, regista::assigner)
