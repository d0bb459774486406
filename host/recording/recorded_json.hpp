// SPDX-License-Identifier: MIT
// What the readers of a recording's messages share: a message is JSON of the right types that also makes sense.
#pragma once

#include <cstdint>
#include <utility>

#include "texts/json.hpp"

namespace regista::recording {

// A message of the right types that makes no sense.
struct Senseless {};

inline void require(bool holds) {
  if (!holds) throw Senseless();
}

// As a conversion by the library is undefined for a number that fits no int.
inline int whole(const nlohmann::json& json) {
  require(json.is_number_integer());
  const bool fits = json.is_number_unsigned() ? std::in_range<int>(json.get<std::uint64_t>())
                                              : std::in_range<int>(json.get<std::int64_t>());
  require(fits);
  return static_cast<int>(json.get<std::int64_t>());
}

}  // namespace regista::recording
