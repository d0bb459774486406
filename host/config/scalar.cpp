// SPDX-License-Identifier: MIT
#include "config/scalar.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "config/errors.hpp"
#include "texts/message.hpp"

namespace regista::config {
namespace {

bool digit(char c) { return c >= '0' && c <= '9'; }
bool letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

bool among(std::string_view word, std::initializer_list<std::string_view> words) {
  return std::ranges::find(words, word) != words.end();
}

// Throws Error at the node: `what: "abc" reason`.
[[noreturn]] void refuse_text(const Node& node, std::string_view what, std::string_view reason) {
  throw Error(node.where(), fmt::format("{}: {} {}", what, texts::in_quotes(node.text()), reason));
}

std::string_view magnitude(std::string_view text) {
  if (!text.empty() && (text[0] == '+' || text[0] == '-')) text.remove_prefix(1);
  return text;
}

// Throws Error for forms that neither a real nor a whole number may have.
void check_number(const Node& node, std::string_view what, std::string_view wanted) {
  if (node.kind() != Node::Kind::scalar) refuse_kind(node, what, wanted);
  if (node.quoted()) refuse_text(node, what, fmt::format("is text, being quoted; expected {}", wanted));
  const std::string word = texts::lower(std::string(magnitude(node.text())));
  if (among(word, {".nan", ".inf", "nan", "inf"})) refuse_text(node, what, "is not finite");
  if (word.size() > 2 && among(word.substr(0, 2), {"0x", "0o", "0b"})) {
    refuse_text(node, what, "is not decimal; write it in base ten");
  }
  if (word.size() > 1 && word[0] == '0' && digit(word[1])) {
    refuse_text(node, what, "begins with zero, which some read as octal; leave the zero out");
  }
}

// Returns whether the text is [digits][.digits][e[sign]digits] with a digit before the exponent.
bool decimal(std::string_view text) {
  std::size_t i = 0, before = 0, after = 0, exponent = 0;
  for (; i < text.size() && digit(text[i]); ++i) ++before;
  if (i < text.size() && text[i] == '.') {
    for (++i; i < text.size() && digit(text[i]); ++i) ++after;
  }
  if (before + after == 0) return false;
  if (i < text.size() && (text[i] == 'e' || text[i] == 'E')) {
    if (++i < text.size() && (text[i] == '+' || text[i] == '-')) ++i;
    for (; i < text.size() && digit(text[i]); ++i) ++exponent;
    if (exponent == 0) return false;
  }
  return i == text.size();
}

}  // namespace

double to_real(const Node& node, std::string_view what) {
  check_number(node, what, "a number");
  const std::string& text = node.text();
  const std::string_view digits = magnitude(text);
  if (!decimal(digits)) refuse_text(node, what, "is not a number");
  double value = 0.0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc{} || !std::isfinite(value)) refuse_text(node, what, "is beyond what a number can hold");
  return text[0] == '-' ? -value : value;
}

std::int64_t to_integer(const Node& node, std::string_view what) {
  check_number(node, what, "an integer");
  const std::string& text = node.text();
  const std::string_view digits = magnitude(text);
  if (digits.empty() || !std::ranges::all_of(digits, digit)) refuse_text(node, what, "is not an integer");
  std::int64_t value = 0;
  const char* begin = text.data() + (text[0] == '+' ? 1 : 0);
  const auto [end, error] = std::from_chars(begin, text.data() + text.size(), value);
  if (error != std::errc{}) refuse_text(node, what, "is beyond what an integer can hold");
  return value;
}

std::string range_text(Range range, std::string_view unit) {
  return fmt::format("{} to {}{}{}", range.least, range.most, unit.empty() || unit == "1" ? "" : " ",
                     unit == "1" ? "" : unit);
}

double real_within(const Node& node, std::string_view what, Range range, std::string_view unit) {
  const double value = to_real(node, what);
  if (value >= range.least && value <= range.most) return value;
  throw Error(node.where(),
              fmt::format("{}: {} is outside {}", what, texts::in_quotes(node.text()), range_text(range, unit)));
}

std::int64_t integer_within(const Node& node, std::string_view what, Range range, std::string_view unit) {
  const std::int64_t value = to_integer(node, what);
  if (value >= static_cast<std::int64_t>(range.least) && value <= static_cast<std::int64_t>(range.most)) return value;
  throw Error(node.where(), fmt::format("{}: {} is outside {}", what, value, range_text(range, unit)));
}

bool to_boolean(const Node& node, std::string_view what) {
  if (node.kind() != Node::Kind::scalar) refuse_kind(node, what, "true or false");
  if (!node.quoted() && among(node.text(), {"true", "True", "TRUE"})) return true;
  if (!node.quoted() && among(node.text(), {"false", "False", "FALSE"})) return false;
  const std::string word = texts::lower(node.text());
  const bool yes = among(word, {"yes", "on", "y", "true", "1"}), no = among(word, {"no", "off", "n", "false", "0"});
  refuse_text(node, what, fmt::format("is neither true nor false{}", yes ? "; write true" : no ? "; write false" : ""));
}

std::string to_text(const Node& node, std::string_view what) {
  if (node.kind() != Node::Kind::scalar) refuse_kind(node, what, "text");
  return node.text();
}

std::string to_line(const Node& node, std::string_view what) {
  std::string text = to_text(node, what);
  if (text.find('\n') != std::string::npos) throw Error(node.where(), fmt::format("{}: expected one line", what));
  return text;
}

std::string to_name(const Node& node, std::string_view what) {
  if (node.kind() != Node::Kind::scalar) refuse_kind(node, what, "a name");
  const std::string& text = node.text();
  if (!node.quoted() && among(texts::lower(text), {"true", "false"})) {
    refuse_text(node, what, "is a boolean; expected a name");
  }
  const auto allowed = [](char c) { return letter(c) || digit(c) || c == '_' || c == '-'; };
  if (text.empty() || !letter(text[0]) || !std::ranges::all_of(text, allowed)) {
    const char* const hint = what == "team" ? "; a name for people is a value of the key title" : "";
    refuse_text(node, what, fmt::format("is not a name (a letter, then letters, digits, '_' and '-'){}", hint));
  }
  constexpr std::size_t longest = 64;
  if (text.size() > longest) refuse_text(node, what, fmt::format("is longer than {} characters", longest));
  return text;
}

std::string described(const Node& node) {
  if (node.kind() == Node::Kind::map) return "a map";
  if (node.kind() == Node::Kind::sequence) return "a list";
  return node.kind() == Node::Kind::scalar ? texts::in_quotes(node.text()) : "nothing";
}

void refuse_kind(const Node& node, std::string_view what, std::string_view wanted) {
  throw Error(node.where(), fmt::format("{}: {}; expected {}", what, described(node), wanted));
}

std::span<const Node> elements_of(const Node& node, std::string_view what, std::string_view wanted) {
  if (node.kind() != Node::Kind::sequence) refuse_kind(node, what, wanted);
  if (node.elements().empty()) throw Error(node.where(), fmt::format("{}: the list is empty", what));
  return node.elements();
}

std::string real_text(double value) { return fmt::format("{}", value); }

std::optional<double> typed_number(std::string_view text) {
  const auto value = number_in<double>(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

double parse_rate(const std::string& option, const std::string& text) {
  const auto rate = typed_number(text);
  if (!rate || !(*rate > 0.0 && *rate < 1.0)) {
    throw BadInput(fmt::format("{}: {}; expected a number above 0 and below 1", option, texts::in_quotes(text)));
  }
  return *rate;
}

std::uint64_t parse_whole(const std::string& option, const std::string& text, std::uint64_t least, std::uint64_t most) {
  const auto value = number_in<std::uint64_t>(text);
  if (!value || *value < least || *value > most) {
    throw BadInput(
        fmt::format("{}: {}; expected a whole number from {} to {}", option, texts::in_quotes(text), least, most));
  }
  return *value;
}

}  // namespace regista::config
