// SPDX-License-Identifier: MIT
// What the text of a YAML value means, by the core schema of YAML 1.2 less everything that two readers could take
// differently: no octal or hexadecimal numbers, no leading zeros, no yes/no, nothing that is not finite.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "config/node.hpp"

namespace regista::config {

// Each throws Error at the node, "what: reason", where the node is anything else. `what` is the path of the value, such
// as "field.length".
double to_real(const Node& node, std::string_view what);
std::int64_t to_integer(const Node& node, std::string_view what);
bool to_boolean(const Node& node, std::string_view what);
std::string to_text(const Node& node, std::string_view what);

// A name of something: a letter, then letters, digits, '_' and '-'.
std::string to_name(const Node& node, std::string_view what);
inline constexpr std::string_view name_pattern = "^[A-Za-z][A-Za-z0-9_-]*$";

// What a node is, for messages: "a map", "a list", "nothing", `"abc"`.
std::string described(const Node& node);

// Throws Error at the node, "what: <described>; <wanted> is wanted".
[[noreturn]] void refuse_kind(const Node& node, std::string_view what, std::string_view wanted);

// Those of a list that has some. Throws Error at the node, as refuse_kind does, or for an empty list.
std::span<const Node> elements_of(const Node& node, std::string_view what, std::string_view wanted);

// The shortest text that to_real reads as exactly this number.
std::string real_text(double value);

}  // namespace regista::config
