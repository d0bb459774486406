// SPDX-License-Identifier: MIT
// The results of a tournament as a file that can be continued: the file holds what was planned, and is continued only
// by the same plan. Everything that differs is named; nothing is mixed.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "campaign/input.hpp"
#include "campaign/store.hpp"

namespace regista::cli {

struct TournamentPlan {
  std::array<std::string, 2> files;                   // A, B, as they were named
  std::array<std::vector<campaign::Input>, 2> teams;  // A, B
  std::vector<campaign::Input> common;
  std::uint64_t pairs = 0, first_seed = 1;
};

// Opens the file of results for this plan. Throws BadInput: it exists and is not to be continued, or the other way
// round, holds something else, or cannot be used.
campaign::Store open_results(const std::string& file, bool resume, const TournamentPlan& plan);

}  // namespace regista::cli
