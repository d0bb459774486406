// SPDX-License-Identifier: MIT
// What differs between two plans of one form in the files that they were made from, in words; each thing once.
#pragma once

#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "campaign/input.hpp"
#include "study/opening.hpp"

namespace regista::study {

class InputDifferences {
 public:
  // whose: stands before every difference, such as "the opponent: ".
  void add(const std::string& whose, std::span<const campaign::Input> then, std::span<const campaign::Input> today) {
    for (const std::string& each : campaign::differences(then, today)) {
      const std::string line = whose + each;
      if (std::ranges::find(lines_, line) == lines_.end()) lines_.push_back(line);
    }
  }

  // Scenes last: that they come in another order is said only where nothing else is.
  std::vector<std::string> with_openings(std::span<const Opening> then, std::span<const Opening> today) && {
    const std::vector<campaign::Input> before = inputs(then), now = inputs(today);
    add("", before, now);
    if (lines_.empty() && before != now) lines_.push_back("the openings come in another order");
    return std::move(lines_);
  }

 private:
  static std::vector<campaign::Input> inputs(std::span<const Opening> openings) {
    std::vector<campaign::Input> out;
    for (const Opening& each : openings) out.push_back(each.input);
    return out;
  }

  std::vector<std::string> lines_;
};

}  // namespace regista::study
