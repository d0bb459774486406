// SPDX-License-Identifier: MIT
// The index at the end of an MCAP file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "mcap/input_file.hpp"
#include "mcap/records.hpp"

namespace regista::mcap {

struct Summary {
  std::vector<Schema> schemas;
  std::vector<Channel> channels;
  std::vector<ChunkIndex> chunks;  // ascending by offset, none reaches into the next
  std::vector<MetadataIndex> metadata;
  std::optional<Statistics> statistics;
  std::uint64_t data_end = 0;  // where the record stands that ends the messages
};

// Whether the file ends as a finished one does, with a footer.
bool has_footer(const InputFile& file);

// The summary of a file that has a footer and whose header ends at `header_end`; none where the writer left it out or
// it does not lead to all messages. Every place in it lies between header and summary. Throws Error where it is
// damaged, contradicts itself or is larger than `most_bytes`.
std::optional<Summary> read_summary(const InputFile& file, std::uint64_t header_end, std::size_t most_bytes);

}  // namespace regista::mcap
