// SPDX-License-Identifier: MIT
// Texts from files and plugins as a reader may be shown them: whatever the bytes are, they are well-formed UTF-8 (RFC
// 3629), and a character that would not be seen, or would move or turn what stands around it, stands there as an
// escape. The characters that turn text are those of Unicode Standard Annex #9, "Unicode Bidirectional Algorithm".
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace regista::texts {

// In one line: "a\nb" is seen as a, backslash, n, b. Bytes that are no UTF-8 become U+FFFD.
std::string visible(std::string_view text);

// The same, but the ends of lines stay.
std::string visible_lines(std::string_view text);

// The same in one line of so many characters at most; what is left out is told by "...".
std::string visible_at_most(std::string_view text, std::size_t characters);

}  // namespace regista::texts
