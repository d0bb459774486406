// SPDX-License-Identifier: MIT
// Texts as fields of a table (RFC 4180). A spreadsheet takes a field that begins with = + - @, a tab or a carriage
// return for a formula, and runs it: such a text gets a ' before it (OWASP, "CSV Injection"). Numbers are not touched;
// they do not come here.
#pragma once

#include <string>
#include <string_view>

namespace regista::report {

inline std::string csv_field(std::string_view text) {
  std::string out;
  if (!text.empty() && std::string_view("=+-@\t\r").find(text.front()) != std::string_view::npos) out += '\'';
  out += text;
  if (out.find_first_of(",\"\r\n") == std::string::npos) return out;
  std::string quoted = "\"";
  for (const char c : out) {
    if (c == '"') quoted += '"';
    quoted += c;
  }
  return quoted + '"';
}

}  // namespace regista::report
