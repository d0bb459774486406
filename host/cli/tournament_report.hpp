// SPDX-License-Identifier: MIT
// What is said about a tournament at its end: a function of its inputs alone, equal to the byte however often it was
// stopped and by however many workers it was played.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>

#include "study/tournament.hpp"

namespace regista::cli {

struct PlayedTournament {
  std::array<std::string, 2> labels;  // A, B
  bool equal_teams = false;           // A/A
  std::uint64_t pairs = 0, first_seed = 1;
  study::Standing standing;
  std::function<std::string(std::uint64_t match)> again;  // the command that plays it by itself
};

// A page that ends with a newline.
std::string tournament_text(const PlayedTournament& tournament);

// One JSON object with a newline.
std::string tournament_json(const PlayedTournament& tournament);

// "forfeited by small: plugin hangs, holds: used more than 5 s of processor time"
std::string forfeit_text(const std::string& label, const campaign::Failure& failure);

}  // namespace regista::cli
