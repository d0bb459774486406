// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>

namespace regista::mcap {

// Whether the bytes are well-formed UTF-8 (RFC 3629, section 4), as names and metadata of MCAP files have to be.
bool is_utf8(std::string_view bytes);

}  // namespace regista::mcap
