// SPDX-License-Identifier: MIT
// The metadata record "match" of a recording: teams, field, names. Values are text; a value with several parts is JSON
// (docs/recordings.md). This header also declares functions that read only a part of a recording.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "mcap/encoding.hpp"
#include "mcap/reader.hpp"
#include "mind/team_plan.hpp"

namespace regista::recording {

// Version of the format. It increases with every change that would mislead older readers.
inline constexpr int recording_format = 1;
inline constexpr const char* match_metadata_name = "match";

struct RecordedSetup {
  std::array<const mind::TeamPlan*, 2> plans{};  // by side
  std::string program, command;                  // for example "regista 0.1.0"; shell command that replays the match
  std::string opening;                           // name of the opening; empty: the match starts with the kick-off
  std::uint64_t seed = 1;
};

mcap::Pairs match_metadata(const RecordedSetup& setup);

// Returns the metadata record "match" of a file; null if there is none, like in recordings of other programs.
const mcap::Pairs* match_metadata_in(const mcap::Reader& reader);

// Properties that tell whether a recording belongs to a match.
struct RecordingIdentity {
  std::uint64_t seed = 1;
  std::array<std::string, 2> labels;        // names of the teams in the tournament, by side
  std::string opening;                      // name of the opening; empty: the match starts with the kick-off
  std::optional<std::array<int, 2>> score;  // by side; missing: the match failed, and its recording may be cut off
  std::optional<double> packets;            // packets of both teams, if there is a score; rarely equal in two matches
};

// Returns whether the file is a recording of the match. Reads only the beginning and the last second of the file.
bool is_recording_of(const std::filesystem::path& recording, const RecordingIdentity& match);

// Returns the time of the first goal in s since the match began, if any. Throws mcap::Error if this is no recording.
std::optional<double> first_goal(const std::filesystem::path& recording);

}  // namespace regista::recording
