// SPDX-License-Identifier: MIT
// Which matches the tasks of an array play.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace regista::cluster {

// Places of a round, from 0 on: from `begin` up to, but without, `end`.
struct Slice {
  std::uint64_t begin = 0, end = 0;
  friend bool operator==(const Slice&, const Slice&) = default;
};

using Slices = std::vector<Slice>;  // ascending, none of them empty

std::uint64_t matches_of(const Slices& slices);

struct Batch {
  std::uint64_t first_row = 0;  // of the round: see study::Round
  bool may_end_early = false;   // that round
  std::vector<Slices> tasks;
  std::uint64_t matches() const;
  friend bool operator==(const Batch&, const Batch&) = default;
};

// The first of these places for at most so many tasks, at most `matches` for each.
std::vector<Slices> shared_out(const Slices& places, std::uint64_t matches, std::uint64_t tasks);

std::string to_json(const Batch& batch);
// Throws std::invalid_argument for what to_json() did not write.
Batch batch_from_json(const std::string& text);

}  // namespace regista::cluster
