// SPDX-License-Identifier: MIT
// A whole number of a stored text, which may be damaged: looked at before it is converted, for what is no whole number,
// or too large a one, has no defined value in C++.
#pragma once

#include <cstdint>
#include <stdexcept>

#include "texts/json.hpp"

namespace regista::campaign {

// 0 to `most`. Throws std::out_of_range for anything else.
inline std::uint64_t whole_number(const nlohmann::ordered_json& json, std::uint64_t most = UINT64_MAX) {
  if (!json.is_number_unsigned() || json.get<std::uint64_t>() > most)
    throw std::out_of_range("expected a whole number");
  return json.get<std::uint64_t>();
}

}  // namespace regista::campaign
