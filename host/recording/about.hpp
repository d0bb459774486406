// SPDX-License-Identifier: MIT
// Who plays, on which field, under which names: the metadata record "match" of a recording. Values are text; those of
// several parts are JSON. docs/recordings.md lists them.
#pragma once

#include <array>
#include <cstdint>
#include <string>

#include "mcap/reader.hpp"
#include "mcap/records.hpp"
#include "mind/team_plan.hpp"

namespace regista::recording {

// Grows when a reader of the one before would be misled.
inline constexpr int recording_format = 1;
inline constexpr const char* about_record = "match";

struct RecordedSetup {
  std::array<const mind::TeamPlan*, 2> plans{};  // by side
  std::string program, command;                  // "regista 0.1.0"; a line of the shell that plays the match again
  std::string opening;                           // name; empty: from kick-off
  std::uint64_t seed = 1;
};

mcap::Pairs about(const RecordedSetup& setup);

// Of a file; null when it has none, as recordings of other programs.
const mcap::Pairs* about_in(const mcap::Reader& reader);

}  // namespace regista::recording
