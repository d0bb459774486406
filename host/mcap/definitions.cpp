// SPDX-License-Identifier: MIT
#include "mcap/definitions.hpp"

#include <string>
#include <utility>

#include "mcap/decode.hpp"

namespace regista::mcap {
namespace {

std::string number(SchemaId id) { return std::to_string(static_cast<unsigned>(id)); }
std::string number(ChannelId id) { return std::to_string(static_cast<unsigned>(id)); }

}  // namespace

void Definitions::define(Schema&& schema) {
  if (schema.id == SchemaId::none) return;  // the format has readers ignore these
  const auto known = schemas_.find(schema.id);
  if (known != schemas_.end()) {
    if (known->second != schema) throw Malformed{"schema " + number(schema.id) + " is given twice and differs"};
    return;
  }
  take(schema.name.size() + schema.encoding.size() + schema.data.size());
  const SchemaId id = schema.id;
  schemas_.emplace(id, std::move(schema));
}

bool Definitions::define(Channel&& channel) {
  const auto known = channels_.find(channel.id);
  if (known != channels_.end()) {
    if (known->second != channel) throw Malformed{"channel " + number(channel.id) + " is given twice and differs"};
    return false;
  }
  if (channel.schema != SchemaId::none && !schemas_.contains(channel.schema)) {
    throw Malformed{"channel " + number(channel.id) + " names schema " + number(channel.schema) + ", which is missing"};
  }
  take(channel.topic.size() + channel.message_encoding.size());
  const ChannelId id = channel.id;
  channels_.emplace(id, std::move(channel));
  return true;
}

void Definitions::take(std::size_t bytes) {
  if (bytes > left_) throw Malformed{"its schemas and channels are larger than this program reads"};
  left_ -= bytes;
}

}  // namespace regista::mcap
