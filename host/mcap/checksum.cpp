// SPDX-License-Identifier: MIT
#include "mcap/checksum.hpp"

#include <zlib.h>

namespace regista::mcap {

std::uint32_t checksum(std::string_view bytes, std::uint32_t before) {
  if (bytes.empty()) return before;  // zlib takes a null pointer for a question
  return static_cast<std::uint32_t>(crc32_z(before, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

}  // namespace regista::mcap
