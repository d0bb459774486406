// SPDX-License-Identifier: MIT
// Which position of a formation belongs to which role.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "role_list.hpp"

namespace formations {

inline constexpr int no_position = -1;

// For each row of the table of roles a position, from 0, or no_position.
//
// `text`: entries "role: number", numbers from 1 as in the file; roles not named have no position. Empty: by
// importance, in every list alike. Of a formation with eleven positions, numbered as librcsc does, the first roles then
// take goalkeeper (1), centre forward (11), centre backs (2, 3), defensive half (6), offensive halves (7, 8), side
// forwards (9, 10) and side backs (4, 5); of others the positions in their order.
//
// Throws std::invalid_argument: see role_list.hpp; no such position; or, when `text` is empty, more roles in a list or
// more robots than positions.
std::vector<int> role_numbers(std::string_view text, std::span<const Role> roles, std::size_t positions,
                              std::size_t team_size);

}  // namespace formations
