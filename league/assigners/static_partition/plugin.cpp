// SPDX-License-Identifier: MIT
// Assigner plugin around algorithm.hpp.
#include <vector>

#include <plugins/assigners/task_order.hpp>
#include <regista/assigner.hpp>

#include "algorithm.hpp"

namespace {

struct StaticPartition {
  static constexpr auto id = "static_partition", version = "1.0.0",
                        summary = "Robot n takes the n-th role of the list, whatever happens";
  static constexpr unsigned reads = REGISTA_READS_NOTHING;

  bool fill = false;
  static constexpr std::tuple parameters{
      regista::boolean("fill", &StaticPartition::fill,
                       "Robots behind a missing one move up, so that only the least important tasks stay open")};

  std::vector<std::uint32_t> order;
  std::vector<std::int32_t> numbers, places;

  void setup(const regista::Environment& environment) {
    numbers.reserve(environment->team_size);
    order.reserve(environment.roles().size());
    places.reserve(environment.roles().size());
  }
  void assign(const regista::Frame& frame, regista::UtilityMatrix utilities, regista::Assignment out) {
    if (out.size() == 0 || utilities.columns() == 0) return;
    const static_partition::Matrix matrix{utilities.data(), utilities.rows(), utilities.columns(), utilities.stride()};
    const std::span<std::int32_t> rows(&out[0], out.size());
    if (fill) {
      static_partition::moving_up(matrix, assignment::by_importance(frame.tasks(), order), rows);
      return;
    }
    numbers.clear();
    places.clear();
    for (const std::int32_t number : frame.world().active()) numbers.push_back(number);
    for (const regista::Task& task : frame.tasks()) places.push_back(task.priority);
    static_partition::by_number(matrix, numbers, places, rows);
  }
};

}  // namespace

REGISTA_PLUGIN(StaticPartition, regista::assigner)
