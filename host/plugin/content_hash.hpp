// SPDX-License-Identifier: MIT
// A name for the content of a file: XXH3 with 128 bits, as 32 hexadecimal digits in canonical (big-endian) order, as
// `xxh128sum` prints it. Tells accidents apart, not forgeries.
#pragma once

#include <string>
#include <string_view>

namespace regista::plugin {

std::string content_hash(std::string_view bytes);

}  // namespace regista::plugin
