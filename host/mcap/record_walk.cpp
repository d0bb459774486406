// SPDX-License-Identifier: MIT
#include "mcap/record_walk.hpp"

#include "mcap/decode.hpp"

namespace regista::mcap {

std::optional<RecordPlace> RecordWalk::next() {
  if (file_->size() - offset_ < record_prefix) return std::nullopt;
  file_->read(offset_, record_prefix, prefix_);
  Decoder in(prefix_);
  RecordPlace place;
  place.opcode = static_cast<Opcode>(in.u8());
  place.offset = offset_;
  place.content = in.u64();
  if (place.content > file_->size() - offset_ - record_prefix) return std::nullopt;
  offset_ += place.length();
  return place;
}

}  // namespace regista::mcap
