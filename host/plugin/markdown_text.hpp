// SPDX-License-Identifier: MIT
// Texts of plugins in Markdown: they stand there as themselves, and no link, picture, tag, emphasis or end of a table's
// cell comes of them. (CommonMark 0.31, section 2.4; GitHub Flavored Markdown, section 4.10.)
#pragma once

#include <string>
#include <string_view>

namespace regista::plugin {

// Within a line or a table's cell. `code` is left to be code, as long as each backtick has its partner.
std::string as_text(std::string_view text);

// The same at the beginning of a line, where a heading or a list might come of it.
std::string as_paragraph(std::string_view text);

// As code: between more backticks than stand in it.
std::string as_code(std::string_view text);

}  // namespace regista::plugin
