// SPDX-License-Identifier: MIT
// Numbers as they were typed on a command line. Errors (BadInput) begin with the option that asks for them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace regista::config {

// A finite number and nothing else; nothing where it is none.
std::optional<double> typed_number(std::string_view text);

// A number above 0 and below 1.
double parse_rate(const std::string& option, const std::string& text);

// Decimal digits alone.
std::uint64_t parse_whole(const std::string& option, const std::string& text, std::uint64_t least, std::uint64_t most);

}  // namespace regista::config
