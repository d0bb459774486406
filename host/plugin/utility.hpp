// SPDX-License-Identifier: MIT
// The call of a utility, and the check of the matrix it fills.
#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "plugin/instance.hpp"

namespace regista::plugin {

class Utility {
 public:
  // Throws Failure when the plugin is no utility.
  explicit Utility(std::shared_ptr<Instance> instance);

  // rows x columns: the utility of each active robot for each task. Valid until a utility of the same robot is asked
  // again. 0 where the plugin writes nothing; it is not called when there is nothing to score. Checked: every entry
  // finite and in [0, 1e12].
  std::span<const double> score(const regista_frame& frame, std::size_t rows, std::size_t columns);

 private:
  std::shared_ptr<Instance> instance_;
  const regista_utility* calls_;
};

}  // namespace regista::plugin
