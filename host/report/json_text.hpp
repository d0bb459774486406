// SPDX-License-Identifier: MIT
// Writes JSON text by hand, straight into a string that is reused: a recording writes ten million numbers a match, and
// a tree of values for each message would cost more than the match. Numbers are rounded to a fixed number of decimals.
#pragma once

#include <charconv>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

namespace regista::report {

class JsonText {
 public:
  void clear() {
    text_.clear();
    first_ = true;
  }
  std::string_view text() const { return text_; }

  JsonText& key(std::string_view name) {
    comma();
    text_ += '"';
    text_ += name;  // names of this program, nothing to escape
    text_ += "\":";
    first_ = true;
    return *this;
  }
  JsonText& open(char bracket) {
    comma();
    text_ += bracket;
    first_ = true;
    return *this;
  }
  JsonText& close(char bracket) {
    text_ += bracket;
    first_ = false;
    return *this;
  }
  JsonText& null() { return raw("null"); }
  JsonText& boolean(bool value) { return raw(value ? "true" : "false"); }
  // Text that is JSON already.
  JsonText& raw(std::string_view json) {
    comma();
    text_ += json;
    first_ = false;
    return *this;
  }
  JsonText& name(std::string_view word) {
    comma();
    text_ += '"';
    text_ += word;
    text_ += '"';
    first_ = false;
    return *this;
  }
  JsonText& integer(std::int64_t value) {
    comma();
    digits(value);
    first_ = false;
    return *this;
  }
  // `decimals`, 1 to 6, are kept, without trailing zeros; null where the value is not finite.
  JsonText& number(double value, int decimals = 3) {
    if (!std::isfinite(value)) return null();
    constexpr std::int64_t powers[] = {1, 10, 100, 1000, 10'000, 100'000, 1'000'000};
    if (std::abs(value) > 1e9) return shortest(value);
    std::int64_t parts = std::llround(value * static_cast<double>(powers[decimals]));
    comma();
    first_ = false;
    if (parts < 0) text_ += '-';
    parts = parts < 0 ? -parts : parts;
    digits(parts / powers[decimals]);
    std::int64_t rest = parts % powers[decimals];
    if (rest == 0) return *this;
    char tail[7];
    tail[0] = '.';
    for (int i = decimals; i > 0; --i, rest /= 10) tail[i] = static_cast<char>('0' + rest % 10);
    int length = decimals + 1;
    while (tail[length - 1] == '0') --length;
    text_.append(tail, static_cast<std::size_t>(length));
    return *this;
  }
  // Of a size that nobody knows beforehand: about five digits.
  JsonText& quantity(double value) {
    const double size = std::abs(value);
    return size == 0.0 || (size >= 0.1 && size <= 1e9) || !std::isfinite(value) ? number(value, 5) : shortest(value);
  }

 private:
  JsonText& shortest(double value) {
    comma();
    char buffer[32];
    const auto end = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::general, 5).ptr;
    text_.append(buffer, static_cast<std::size_t>(end - buffer));
    first_ = false;
    return *this;
  }
  void comma() {
    if (!first_) text_ += ',';
  }
  void digits(std::int64_t value) {
    char buffer[20];
    const auto end = std::to_chars(buffer, buffer + sizeof buffer, value).ptr;
    text_.append(buffer, static_cast<std::size_t>(end - buffer));
  }
  std::string text_;
  bool first_ = true;
};

}  // namespace regista::report
