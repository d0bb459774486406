// SPDX-License-Identifier: MIT
// How texts of users are put into messages: in one line, and not too long.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace regista::texts {

// The text as a terminal may be given it, in one line: see visible.hpp.
std::string one_line(std::string_view text);

// "text" in double quotes, in one line, cut after 40 characters.
std::string in_quotes(std::string_view text);

// "a, b, c"
std::string join(std::span<const std::string> names);

// "1 pair", "3 pairs"
std::string counted(std::uint64_t count, std::string_view one, std::string_view many);

// `unknown key "a" in b; nearest: "c"; known: c, d`, the message for anything that is asked for by name. `what` is what
// was asked for ("key"), `where` where it was looked for, "" where that is plain.
std::string unknown(std::string_view what, std::string_view asked, std::string_view where,
                    std::span<const std::string> known);

}  // namespace regista::texts
