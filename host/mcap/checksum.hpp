// SPDX-License-Identifier: MIT
// CRC-32 as MCAP uses it (the polynomial of IEEE 802.3, as in zip and gzip).
#pragma once

#include <cstdint>
#include <string_view>

namespace regista::mcap {

// The checksum of what `before` is the checksum of, followed by `bytes`.
std::uint32_t checksum(std::string_view bytes, std::uint32_t before = 0);

}  // namespace regista::mcap
