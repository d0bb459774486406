// SPDX-License-Identifier: MIT
// The older text forms of librcsc's formation files, as teams of the 2D simulation league wrote them until 2022, and
// still do:
//
//   Formation DelaunayTriangulation 2        Formation DelaunayTriangulation      Formation Static
//   Begin Roles                              Goalie 0 CenterBack -1 ...           1 Goalie -49 0
//   1 Goalie 0                               0 0 -50 0 -15.5 -5.4 ...             2 CenterBack -25 -5
//   2 CenterBack -1                          54.5 -36 -50 0 ...                   ...
//   ...                                      End                                  11 CenterForward -15 0
//   End Roles
//   Begin Samples 2 115
//   ----- 0 -----
//   Ball 54.5 -36
//   1 -50 0
//   ...
//   End Samples
//   End
//
// In version 3 a role has a type and two marks more: "1 G Goalie 0 x x". All eleven positions of a sample are written
// down, so the number of the partner on the other side, which is only for editors, does not matter. Lines that are
// empty or begin with # or // are comments.
#pragma once

#include <string_view>
#include <vector>

#include "formation.hpp"

namespace formations {

// Whether the first line that is no comment begins with the word "Formation".
bool is_text_form(std::string_view bytes);

// As read_formation(), which calls it.
std::vector<Sample> read_text_form(std::string_view bytes);

}  // namespace formations
