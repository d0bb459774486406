// SPDX-License-Identifier: MIT
#include "check/verdict.hpp"

#include <algorithm>
#include <array>

namespace regista::check {

const char* word(Status status) {
  constexpr std::array words{"pass", "warn", "fail", "crash", "skip"};
  return words[static_cast<std::size_t>(status)];
}

bool Report::passed() const {
  return std::ranges::none_of(verdicts,
                              [](const Verdict& v) { return v.status == Status::fail || v.status == Status::crash; });
}

}  // namespace regista::check
