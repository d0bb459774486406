// SPDX-License-Identifier: MIT
#include "mcap/encoding.hpp"

#include <libdeflate.h>
#include <lz4frame.h>
#include <zstd.h>

#include <new>
#include <stdexcept>

namespace regista::mcap {

namespace {

void append_prefix(std::string& to, Opcode opcode, std::uint64_t length) { Encoder{to}(opcode, length); }

}  // namespace

std::uint32_t checksum(std::string_view bytes, std::uint32_t before) {
  if (bytes.empty()) return before;  // libdeflate ignores `before` if the pointer is null
  return libdeflate_crc32(before, bytes.data(), bytes.size());
}

Compressor::Compressor(int level) : context_(ZSTD_createCCtx(), ZSTD_freeCCtx) {
  if (context_ == nullptr) throw std::bad_alloc();
  ZSTD_CCtx_setParameter(context_.get(), ZSTD_c_compressionLevel, level);
}

void Compressor::append(std::string& to, std::string_view bytes) {
  const std::size_t before = to.size();
  to.resize(before + ZSTD_compressBound(bytes.size()));
  const std::size_t size =
      ZSTD_compress2(context_.get(), to.data() + before, to.size() - before, bytes.data(), bytes.size());
  // The buffer is large enough for the worst case, so the only possible error is missing memory.
  if (ZSTD_isError(size) != 0) throw std::runtime_error(std::string("zstd: ") + ZSTD_getErrorName(size));
  to.resize(before + size);
}

Decompressor::Decompressor() : context_(ZSTD_createDCtx(), ZSTD_freeDCtx) {
  if (context_ == nullptr) throw std::bad_alloc();
}

void Decompressor::decompress(std::string_view frames, std::uint64_t size, std::string& to) {
  // RFC 8878, section 3.1.1.2: a block takes at least 4 bytes (3 of header, 1 of content) and holds at most 128 KiB.
  constexpr std::uint64_t smallest_block = 4, largest_block = 128 * 1024;
  to.clear();
  if (size > frames.size() / smallest_block * largest_block)
    throw Malformed{"a chunk claims more bytes than it can hold"};
  to.resize(size);
  const std::size_t written = ZSTD_decompressDCtx(context_.get(), to.data(), to.size(), frames.data(), frames.size());
  if (ZSTD_isError(written) != 0) {
    throw Malformed{std::string("a chunk cannot be decompressed: ") + ZSTD_getErrorName(written)};
  }
  if (written != size) throw Malformed{"a chunk holds fewer bytes than it claims"};
}

void decompress_lz4(std::string_view frames, std::uint64_t size, std::string& to) {
  // LZ4 writes lengths as sums of bytes, so one byte of a frame stands for at most 255 bytes of content.
  if (size / 255 > frames.size()) throw Malformed{"a chunk claims more bytes than it can hold"};
  to.assign(size, '\0');
  LZ4F_dctx* created = nullptr;
  if (LZ4F_isError(LZ4F_createDecompressionContext(&created, LZ4F_VERSION)) != 0) throw std::bad_alloc();
  const std::unique_ptr<LZ4F_dctx, LZ4F_errorCode_t (*)(LZ4F_dctx*)> context(created, LZ4F_freeDecompressionContext);
  std::size_t written = 0, missing = 0;
  for (std::size_t room = 0, taken = 0; !frames.empty(); frames.remove_prefix(taken), written += room) {
    room = size - written;
    taken = frames.size();
    missing = LZ4F_decompress(created, to.data() + written, &room, frames.data(), &taken, nullptr);
    if (LZ4F_isError(missing) != 0)
      throw Malformed{std::string("a chunk cannot be decompressed: ") + LZ4F_getErrorName(missing)};
    if (room == 0 && taken == 0) throw Malformed{"a chunk holds more bytes than it claims"};
  }
  if (written != size || missing != 0) throw Malformed{"a chunk holds fewer bytes than it claims"};
}

void Encoder::put(std::string_view text) {
  append_integer(to_, static_cast<std::uint32_t>(text.size()));
  to_.append(text);
}

OpenRecord::OpenRecord(std::string& to, Opcode opcode) : to_(to), begin_(to.size()) { append_prefix(to, opcode, 0); }

OpenRecord::~OpenRecord() {
  const std::uint64_t length = to_.size() - begin_ - record_prefix;
  for (std::size_t i = 0; i < 8; ++i) to_[begin_ + 1 + i] = static_cast<char>((length >> (8 * i)) & 0xff);
}

void append_record(std::string& to, const Message& message) {
  append_prefix(to, Opcode::message, message_fields + message.data.size());
  Encoder{to}(message.channel, message.sequence, message.log_time, message.publish_time);
  to.append(message.data);
}

void append_chunk_fields(std::string& to, const ChunkIndex& index, std::uint32_t checksum) {
  append_prefix(to, Opcode::chunk, index.length - record_prefix);
  Encoder{to}(index.first_time, index.last_time, index.uncompressed_size, checksum, index.compression,
              index.compressed_size);
}

void append_footer_fields(std::string& to, std::uint64_t summary_start, std::uint64_t summary_offset_start) {
  append_prefix(to, Opcode::footer, footer_content);
  Encoder{to}(summary_start, summary_offset_start);
}

bool is_utf8(std::string_view bytes) {
  const auto at = [&](std::size_t i) { return static_cast<unsigned char>(bytes[i]); };
  for (std::size_t i = 0; i < bytes.size();) {
    const unsigned first = at(i++);
    if (first < 0x80) continue;
    const std::size_t more = first >= 0xc2 && first <= 0xdf   ? 1
                             : (first & 0xf0) == 0xe0         ? 2
                             : first >= 0xf0 && first <= 0xf4 ? 3
                                                              : 0;
    if (more == 0 || bytes.size() - i < more) return false;
    // The limits of the second byte exclude overlong characters, surrogates, and characters beyond U+10FFFF.
    const unsigned lowest = first == 0xe0 ? 0xa0 : first == 0xf0 ? 0x90 : 0x80;
    const unsigned highest = first == 0xed ? 0x9f : first == 0xf4 ? 0x8f : 0xbf;
    if (at(i) < lowest || at(i) > highest) return false;
    for (std::size_t k = 1; k < more; ++k) {
      if ((at(i + k) & 0xc0) != 0x80) return false;
    }
    i += more;
  }
  return true;
}

std::string_view Decoder::bytes(std::uint64_t count) {
  if (count > rest_.size()) throw Malformed{"a record ends within a field"};
  const std::string_view taken = rest_.substr(0, count);
  rest_.remove_prefix(count);
  return taken;
}

void Decoder::take(Pairs& pairs) {
  for (Decoder in(next<std::string_view>()); !in.rest().empty();) {
    std::string_view key, value;
    in(key, value);
    if (!pairs.emplace(key, value).second) throw Malformed{"a map has a key twice"};
  }
}

void Decoder::take(std::vector<std::pair<ChannelId, std::uint64_t>>& list) {
  for (Decoder in(next<std::string_view>()); !in.rest().empty();) {
    auto& [channel, value] = list.emplace_back();
    in(channel, value);
  }
}

void Decoder::take(std::map<ChannelId, std::uint64_t>& counts) {
  for (Decoder in(next<std::string_view>()); !in.rest().empty();) in(counts[in.next<ChannelId>()]);
}

RawRecord take_record(Decoder& from) {
  RawRecord record;
  std::uint64_t length = 0;
  from(record.opcode, length);
  record.content = from.bytes(length);
  return record;
}

Message decode_message(std::string_view content) {
  Decoder in(content);
  Message message;
  in(message.channel, message.sequence, message.log_time, message.publish_time);
  message.data = in.rest();
  return message;
}

Chunk decode_chunk(std::string_view content) {
  Decoder in(content);
  Chunk chunk;
  std::uint64_t length = 0;
  in(chunk.first_time, chunk.last_time, chunk.uncompressed_size, chunk.checksum, chunk.compression, length);
  chunk.records = in.bytes(length);
  return chunk;
}

}  // namespace regista::mcap
