// SPDX-License-Identifier: MIT
// Zstandard (RFC 8878) for the records of a chunk. One context serves all chunks of a file.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace regista::mcap {

class Compressor {
 public:
  Compressor();
  ~Compressor();
  Compressor(const Compressor&) = delete;
  Compressor& operator=(const Compressor&) = delete;
  // Appends one frame. The same bytes and version of the library give the same frame.
  void append(std::string& to, std::string_view bytes);

 private:
  struct Context;
  std::unique_ptr<Context> context_;
};

class Decompressor {
 public:
  Decompressor();
  ~Decompressor();
  Decompressor(const Decompressor&) = delete;
  Decompressor& operator=(const Decompressor&) = delete;
  // Replaces `to` by what `frames` hold. Throws Malformed unless that is exactly `size` bytes; room for them is made
  // only where so few compressed bytes can hold so many.
  void decompress(std::string_view frames, std::uint64_t size, std::string& to);

 private:
  struct Context;
  std::unique_ptr<Context> context_;
};

}  // namespace regista::mcap
