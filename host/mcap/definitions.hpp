// SPDX-License-Identifier: MIT
// The schemas and channels that a file has named so far.
#pragma once

#include <cstddef>
#include <map>

#include "mcap/records.hpp"

namespace regista::mcap {

class Definitions {
 public:
  // Keeps at most so many bytes, so that a file cannot fill the memory with names.
  explicit Definitions(std::size_t most_bytes) : left_(most_bytes) {}

  // A definition may be repeated, as summaries and chunks do, but not changed; a channel comes after its schema.
  // Otherwise Malformed.
  void define(Schema&& schema);
  bool define(Channel&& channel);  // true where it is new

  const std::map<ChannelId, Channel>& channels() const { return channels_; }

 private:
  void take(std::size_t bytes);
  std::size_t left_;
  std::map<SchemaId, Schema> schemas_;
  std::map<ChannelId, Channel> channels_;
};

}  // namespace regista::mcap
