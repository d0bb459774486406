// SPDX-License-Identifier: MIT
#include "mcap/compression.hpp"

#include <zstd.h>

#include <new>
#include <stdexcept>

#include "mcap/decode.hpp"

namespace regista::mcap {
namespace {

constexpr int level = 1;  // of 19; numbers as text get larger, not smaller, by 2, 3, 5 and 7 (benchmarks/README.md)

}  // namespace

struct Compressor::Context {
  ZSTD_CCtx* zstd = ZSTD_createCCtx();
  ~Context() { ZSTD_freeCCtx(zstd); }
};

Compressor::Compressor() : context_(std::make_unique<Context>()) {
  if (context_->zstd == nullptr) throw std::bad_alloc();
  ZSTD_CCtx_setParameter(context_->zstd, ZSTD_c_compressionLevel, level);
}

Compressor::~Compressor() = default;

void Compressor::append(std::string& to, std::string_view bytes) {
  const std::size_t before = to.size();
  to.resize(before + ZSTD_compressBound(bytes.size()));
  const std::size_t size =
      ZSTD_compress2(context_->zstd, to.data() + before, to.size() - before, bytes.data(), bytes.size());
  // With room for the worst case only memory can be missing.
  if (ZSTD_isError(size) != 0) throw std::runtime_error(std::string("zstd: ") + ZSTD_getErrorName(size));
  to.resize(before + size);
}

struct Decompressor::Context {
  ZSTD_DCtx* zstd = ZSTD_createDCtx();
  ~Context() { ZSTD_freeDCtx(zstd); }
};

Decompressor::Decompressor() : context_(std::make_unique<Context>()) {
  if (context_->zstd == nullptr) throw std::bad_alloc();
}

Decompressor::~Decompressor() = default;

void Decompressor::decompress(std::string_view frames, std::uint64_t size, std::string& to) {
  // RFC 8878, section 3.1.1.2: a block takes at least 4 bytes (3 of header, 1 of content) and holds at most 128 KiB.
  constexpr std::uint64_t smallest_block = 4, largest_block = 128 * 1024;
  to.clear();
  if (size > frames.size() / smallest_block * largest_block)
    throw Malformed{"a chunk claims more bytes than it can hold"};
  to.resize(size);
  const std::size_t written = ZSTD_decompressDCtx(context_->zstd, to.data(), to.size(), frames.data(), frames.size());
  if (ZSTD_isError(written) != 0) {
    throw Malformed{std::string("a chunk cannot be decompressed: ") + ZSTD_getErrorName(written)};
  }
  if (written != size) throw Malformed{"a chunk holds fewer bytes than it claims"};
}

}  // namespace regista::mcap
