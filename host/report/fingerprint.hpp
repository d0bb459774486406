// SPDX-License-Identifier: MIT
// A hash over matches in the order of their schedule: equal where the same were played with the same course.
#pragma once

#include <cstdint>
#include <string>

#include "campaign/job.hpp"

namespace regista::report {

class Fingerprint {
 public:
  void take(std::uint64_t index, const campaign::Decided& decided);
  const std::string& text() const { return text_; }  // 32 hexadecimal digits; empty before the first match

 private:
  std::string text_;
};

}  // namespace regista::report
