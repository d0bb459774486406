// SPDX-License-Identifier: MIT
// The call of an assigner, and the check of the assignment it hands back.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "plugin/instance.hpp"

namespace regista::plugin {

class Assigner {
 public:
  // Throws Failure when the plugin is no assigner.
  explicit Assigner(std::shared_ptr<Instance> instance);

  // out[i]: column that row i gets, REGISTA_NO_TASK or REGISTA_UNKNOWN_TASK; as long as the matrix has rows. Checked:
  // columns exist, none is given twice unless negotiates(), no pair whose utility is -infinity.
  void assign(const regista_frame& frame, const regista_matrix& utilities, std::span<std::int32_t> out);

  // Robots may show the same task while they have not agreed yet.
  bool negotiates() const { return (calls_->flags & REGISTA_ASSIGNER_NEGOTIATES) != 0; }

 private:
  std::shared_ptr<Instance> instance_;
  const regista_assigner* calls_;
  std::vector<std::int32_t> row_of_column_;
};

}  // namespace regista::plugin
