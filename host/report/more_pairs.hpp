// SPDX-License-Identifier: MIT
// What is to be said of a study that was given more pairs of matches after it was begun (study/more_pairs.hpp).
#pragma once

#include <fmt/format.h>

#include <string>

#include "report/visible_text.hpp"

namespace regista::report {

// `before`: of the plan, which was given more.
inline std::string more_pairs_sentence(const std::string& before) {
  return fmt::format(
      "It had {} pairs before it was given more. A p value and an interval hold for a number that was fixed "
      "beforehand: "
      "whoever adds pairs until the result pleases finds differences that are not there.",
      visible(before));
}

}  // namespace regista::report
