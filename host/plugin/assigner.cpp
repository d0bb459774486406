// SPDX-License-Identifier: MIT
#include "plugin/assigner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <limits>

namespace regista::plugin {

Assigner::Assigner(std::shared_ptr<Instance> instance)
    : instance_(std::move(instance)), calls_(&instance_->table<regista_assigner>(REGISTA_KIND_ASSIGNER)) {
  row_of_column_.reserve(instance_->environment().roles.count);
  instance_->rooms().columns.open(instance_->environment().team_size);
}

void Assigner::assign(const regista_frame& frame, const regista_matrix& utilities, std::span<std::int32_t> out) {
  assert(out.size() == utilities.rows);
  constexpr std::int32_t nobody = -1;
  std::int32_t* const room = instance_->open(instance_->rooms().columns, out.size());
  std::fill_n(room, out.size(), REGISTA_NO_TASK);
  const regista_matrix shown = utilities;  // a plugin that writes over it does not change what is checked
  instance_->call_with(
      [](Inputs& inputs, const regista_frame* seen, const regista_matrix* scored, auto*) {
        inputs.add("frame", seen);
        inputs.add("utilities", scored);
      },
      "assign", calls_->assign, instance_->shown(&frame), &shown, room);
  instance_->check("assign", Instance::Written{instance_->rooms().columns, "columns"});
  std::copy_n(room, out.size(), out.begin());
  row_of_column_.assign(utilities.columns, nobody);
  for (std::size_t row = 0; row < out.size(); ++row) {
    const std::int32_t column = out[row];
    if (column == REGISTA_NO_TASK || column == REGISTA_UNKNOWN_TASK) continue;
    if (column < 0 || static_cast<std::uint32_t>(column) >= utilities.columns) [[unlikely]] {
      instance_->fail("assign", fmt::format("row {} got column {} of {}", row, column, utilities.columns));
    }
    const auto index = static_cast<std::size_t>(column);
    if (utilities.values[row * utilities.stride + index] == -std::numeric_limits<double>::infinity()) [[unlikely]] {
      instance_->fail("assign", fmt::format("row {} got column {}, which is forbidden to it", row, column));
    }
    if (row_of_column_[index] != nobody && !negotiates()) [[unlikely]] {
      instance_->fail("assign", fmt::format("column {} given to rows {} and {}", column, row_of_column_[index], row));
    }
    row_of_column_[index] = static_cast<std::int32_t>(row);
  }
  instance_->answered(std::span<const std::int32_t>(out));
}

}  // namespace regista::plugin
