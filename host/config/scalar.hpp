// SPDX-License-Identifier: MIT
// Converts the text of a YAML value to a number, boolean or text. Follows the core schema of YAML 1.2 without its
// ambiguous forms: no octal or hexadecimal numbers, no leading zeros, no yes/no, finite numbers only.
#pragma once

#include <charconv>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <system_error>

#include "config/node.hpp"

namespace regista::config {

// Each function throws Error ("what: reason") if the node is not of its type. `what` is a path such as "field.length".
double to_real(const Node& node, std::string_view what);
std::int64_t to_integer(const Node& node, std::string_view what);
bool to_boolean(const Node& node, std::string_view what);
std::string to_text(const Node& node, std::string_view what);
std::string to_line(const Node& node, std::string_view what);  // a text of one line

struct Range {
  double least, most;  // closed range
};

// Returns text such as "0 to 1.5 m". `unit` is "1" or "" for numbers without a unit.
std::string range_text(Range range, std::string_view unit);

// These functions also throw Error for a number outside of the range.
double real_within(const Node& node, std::string_view what, Range range, std::string_view unit);
std::int64_t integer_within(const Node& node, std::string_view what, Range range, std::string_view unit);

// Reads a name: a letter, then letters, digits, '_' and '-'.
std::string to_name(const Node& node, std::string_view what);
inline constexpr std::string_view name_pattern = "^[A-Za-z][A-Za-z0-9_-]*$";

// Describes a node for messages: "a map", "a list", "nothing", `"abc"`.
std::string described(const Node& node);

// Throws Error at the node, "what: <described>; expected <wanted>".
[[noreturn]] void refuse_kind(const Node& node, std::string_view what, std::string_view wanted);

// Returns the elements of a list. Throws Error like refuse_kind() if the node is not a list or is empty.
std::span<const Node> elements_of(const Node& node, std::string_view what, std::string_view wanted);

// Returns the shortest text that to_real() reads as exactly this number.
std::string real_text(double value);

// --- Numbers of a command line. The message of BadInput begins with the name of the option.

// Returns the number if the text is exactly one number of this type; otherwise nothing.
template <class Number>
std::optional<Number> number_in(std::string_view text) {
  Number out{};
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), out);
  return error == std::errc() && rest == text.data() + text.size() ? std::optional(out) : std::nullopt;
}

// Returns the number if the text is exactly one finite number; otherwise nothing.
std::optional<double> typed_number(std::string_view text);

// Reads a number above 0 and below 1. Throws BadInput.
double parse_rate(const std::string& option, const std::string& text);

// Reads a number in [least, most] that consists only of decimal digits. Throws BadInput.
std::uint64_t parse_whole(const std::string& option, const std::string& text, std::uint64_t least, std::uint64_t most);

}  // namespace regista::config
