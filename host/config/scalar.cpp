// SPDX-License-Identifier: MIT
#include "config/scalar.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "texts/message.hpp"

namespace regista::config {
namespace {

bool digit(char c) { return c >= '0' && c <= '9'; }
bool letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }

std::string lower(std::string_view text) {
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return result;
}

// The number without its sign.
std::string_view magnitude(std::string_view text) {
  if (!text.empty() && (text[0] == '+' || text[0] == '-')) text.remove_prefix(1);
  return text;
}

// Both kinds of number: what is refused for them alike.
void check_number(const Node& node, std::string_view what, std::string_view wanted) {
  if (node.kind() != Node::Kind::scalar) refuse_kind(node, what, wanted);
  const std::string& text = node.text();
  const auto refuse = [&](std::string_view reason) {
    throw Error(node.where(), fmt::format("{}: {} {}", what, texts::in_quotes(text), reason));
  };
  if (node.quoted()) refuse(fmt::format("is text, being quoted; expected {}", wanted));
  const std::string_view digits = magnitude(text);
  const std::string word = lower(digits);
  if (word == ".nan" || word == ".inf" || word == "nan" || word == "inf") refuse("is not finite");
  if (word.size() > 2 && word[0] == '0' && (word[1] == 'x' || word[1] == 'o' || word[1] == 'b')) {
    refuse("is not decimal; write it in base ten");
  }
  if (digits.size() > 1 && digits[0] == '0' && digit(digits[1])) {
    refuse("begins with zero, which some read as octal; leave the zero out");
  }
}

// [digits][.digits][e[sign]digits], with a digit before the exponent
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
  if (!decimal(digits)) throw Error(node.where(), fmt::format("{}: {} is not a number", what, texts::in_quotes(text)));
  double value = 0.0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc{} || !std::isfinite(value)) {
    throw Error(node.where(), fmt::format("{}: {} is beyond what a number can hold", what, texts::in_quotes(text)));
  }
  return text[0] == '-' ? -value : value;
}

std::int64_t to_integer(const Node& node, std::string_view what) {
  check_number(node, what, "an integer");
  const std::string& text = node.text();
  const std::string_view digits = magnitude(text);
  if (digits.empty() || !std::all_of(digits.begin(), digits.end(), digit)) {
    throw Error(node.where(), fmt::format("{}: {} is not an integer", what, texts::in_quotes(text)));
  }
  std::int64_t value = 0;
  const char* begin = text.data() + (text[0] == '+' ? 1 : 0);
  const auto [end, error] = std::from_chars(begin, text.data() + text.size(), value);
  if (error != std::errc{}) {
    throw Error(node.where(), fmt::format("{}: {} is beyond what an integer can hold", what, texts::in_quotes(text)));
  }
  return value;
}

bool to_boolean(const Node& node, std::string_view what) {
  if (node.kind() != Node::Kind::scalar) refuse_kind(node, what, "true or false");
  const std::string& text = node.text();
  if (!node.quoted()) {
    if (text == "true" || text == "True" || text == "TRUE") return true;
    if (text == "false" || text == "False" || text == "FALSE") return false;
  }
  const std::string word = lower(text);
  std::string hint;
  if (word == "yes" || word == "on" || word == "y" || word == "true" || word == "1") hint = "; write true";
  if (word == "no" || word == "off" || word == "n" || word == "false" || word == "0") hint = "; write false";
  throw Error(node.where(), fmt::format("{}: {} is neither true nor false{}", what, texts::in_quotes(text), hint));
}

std::string to_text(const Node& node, std::string_view what) {
  if (node.kind() != Node::Kind::scalar) refuse_kind(node, what, "text");
  return node.text();
}

std::string to_name(const Node& node, std::string_view what) {
  if (node.kind() != Node::Kind::scalar) refuse_kind(node, what, "a name");
  const std::string& text = node.text();
  const std::string word = lower(text);
  if (!node.quoted() && (word == "true" || word == "false")) {
    throw Error(node.where(), fmt::format("{}: {} is a boolean; expected a name", what, texts::in_quotes(text)));
  }
  const bool good = !text.empty() && letter(text[0]) && std::all_of(text.begin(), text.end(), [](char c) {
    return letter(c) || digit(c) || c == '_' || c == '-';
  });
  if (!good) {
    throw Error(node.where(), fmt::format("{}: {} is not a name (a letter, then letters, digits, '_' and '-')", what,
                                          texts::in_quotes(text)));
  }
  constexpr std::size_t longest = 64;
  if (text.size() > longest) {
    throw Error(node.where(),
                fmt::format("{}: {} is longer than {} characters", what, texts::in_quotes(text), longest));
  }
  return text;
}

std::string described(const Node& node) {
  switch (node.kind()) {
    case Node::Kind::map:
      return "a map";
    case Node::Kind::sequence:
      return "a list";
    case Node::Kind::scalar:
      return texts::in_quotes(node.text());
    default:
      return "nothing";
  }
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

}  // namespace regista::config
