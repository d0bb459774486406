// SPDX-License-Identifier: MIT
// The call of a utility, and the check of the matrix it fills.
#pragma once

#include <memory>

#include "plugin/instance.hpp"

namespace regista::plugin {

class Utility {
 public:
  // Throws Failure when the plugin is no utility.
  explicit Utility(std::shared_ptr<Instance> instance);

  // out(i, j): utility of active robot i for task j. Clears `out` first; does not call the plugin when there is nothing
  // to score. Checked: every entry finite and in [0, 1e12].
  void score(const regista_frame& frame, const regista_matrix_room& out);

 private:
  std::shared_ptr<Instance> instance_;
  const regista_utility* calls_;
};

}  // namespace regista::plugin
