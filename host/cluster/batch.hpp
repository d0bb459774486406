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

// A match that is played twice, the second time with every mind in a process of its own, takes as long as so many
// others (benchmarks/README.md, "Clusters").
inline constexpr std::uint64_t weight_of_twice = 6;

// The first of these places for at most so many tasks, at most `most` for each, so that all tasks last about as long.
// twice: which of them are played twice, ascending.
std::vector<Slices> shared_out(const Slices& places, const std::vector<std::uint64_t>& twice, std::uint64_t most,
                               std::uint64_t tasks);

std::string to_json(const Batch& batch);
// Throws std::invalid_argument for what to_json() did not write.
Batch batch_from_json(const std::string& text);

}  // namespace regista::cluster
