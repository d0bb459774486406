// SPDX-License-Identifier: MIT
#include "plugin/content_hash.hpp"

#include <fmt/format.h>
#include <xxhash.h>

namespace regista::plugin {

std::string content_hash(std::string_view bytes) {
  XXH128_canonical_t canonical;
  XXH128_canonicalFromHash(&canonical, XXH3_128bits(bytes.data(), bytes.size()));
  std::string out;
  for (const unsigned char byte : canonical.digest) out += fmt::format("{:02x}", byte);
  return out;
}

}  // namespace regista::plugin
