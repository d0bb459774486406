// SPDX-License-Identifier: MIT
#include "mcap/checksum.hpp"

#include <libdeflate.h>

namespace regista::mcap {

std::uint32_t checksum(std::string_view bytes, std::uint32_t before) {
  if (bytes.empty()) return before;  // libdeflate takes a null pointer for a question
  return libdeflate_crc32(before, bytes.data(), bytes.size());
}

}  // namespace regista::mcap
