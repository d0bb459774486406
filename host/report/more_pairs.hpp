// SPDX-License-Identifier: MIT
// What is to be said of a study that was given more pairs of matches after it was begun (study/more_pairs.hpp).
#pragma once

#include <fmt/format.h>

#include <string>

namespace regista::report {

// `before`: of the plan; empty where no more were asked for, as is then what this gives.
inline std::string more_pairs_sentence(const std::string& before) {
  if (before.empty()) return {};
  return fmt::format(
      "It had {} pairs before it was given more. A p value and an interval hold for a number that was "
      "fixed beforehand: whoever goes on until they please finds too much.",
      before);
}

}  // namespace regista::report
