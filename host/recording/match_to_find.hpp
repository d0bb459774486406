// SPDX-License-Identifier: MIT
// Whether a file holds the recording of a certain match, by what it says itself.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace regista::recording {

// What a recording must say of itself to be taken for that of a match.
struct MatchToFind {
  std::uint64_t seed = 1;
  std::array<std::string, 2> labels;        // of the home and the away team, in the tournament
  std::string opening;                      // name; empty: from kick-off
  std::optional<std::array<int, 2>> score;  // by side; none: the match failed, and its recording may be cut off
  std::optional<double> packets;            // of both teams, of a match with a score: hardly two matches send as many
};

// Reads the beginning of the file and its last second. False for what is no recording, too.
bool holds(const std::filesystem::path& recording, const MatchToFind& match);

}  // namespace regista::recording
