// SPDX-License-Identifier: MIT
// Writes JSON text directly into reused memory. A recording writes ten million numbers a match, and a tree of values
// for each message would take more time than the match. Numbers are rounded to a fixed number of decimals.
#pragma once

#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <vector>

namespace regista::texts {

// Writes JSON. key() and word() take names of this program, which need no escapes. string() takes any UTF-8.
class JsonText {
 public:
  JsonText() : memory_(4096), end_(memory_.data()) {}
  JsonText(const JsonText&) = delete;
  JsonText& operator=(const JsonText&) = delete;

  void clear() {
    end_ = memory_.data();
    first_ = true;
  }
  std::string_view text() const { return {memory_.data(), static_cast<std::size_t>(end_ - memory_.data())}; }

  JsonText& string(std::string_view text) {
    constexpr std::size_t longest_escape = 6;
    begin_value(longest_escape * text.size() + 3);
    *end_++ = '"';
    for (const char each : text) {
      const auto byte = static_cast<unsigned char>(each);
      if (each == '"' || each == '\\') *end_++ = '\\';
      if (byte >= 0x20) {
        *end_++ = each;
        continue;
      }
      constexpr char digits[] = "0123456789abcdef";
      put("\\u00");
      *end_++ = digits[byte >> 4];
      *end_++ = digits[byte & 15u];
    }
    *end_++ = '"';
    return *this;
  }

  JsonText& key(std::string_view name) {
    word(name);
    make_room(1);
    *end_++ = ':';
    first_ = true;
    return *this;
  }
  JsonText& open(char bracket) {
    begin_value(2);
    *end_++ = bracket;
    first_ = true;
    return *this;
  }
  JsonText& close(char bracket) {
    make_room(1);
    *end_++ = bracket;
    first_ = false;
    return *this;
  }
  JsonText& null() { return json("null"); }
  JsonText& boolean(bool value) { return json(value ? "true" : "false"); }
  // Adds a value whose text is already JSON.
  JsonText& json(std::string_view text) {
    begin_value(text.size() + 1);
    put(text);
    return *this;
  }
  JsonText& word(std::string_view word) {
    begin_value(word.size() + 3);
    *end_++ = '"';
    put(word);
    *end_++ = '"';
    return *this;
  }
  JsonText& integer(std::int64_t value) {
    begin_value(24);
    end_ = std::to_chars(end_, end_ + 24, value).ptr;
    return *this;
  }
  // Adds a number with `decimals` decimals, 1 to 6, without trailing zeros; null if the value is not finite.
  JsonText& number(double value, int decimals = 3) {
    constexpr double powers[] = {1, 10, 100, 1e3, 1e4, 1e5, 1e6};
    if (!(std::abs(value) < 1e9)) return std::isfinite(value) ? shortest(value) : null();
    const double scaled = value * powers[decimals];
    auto parts = static_cast<std::int64_t>(scaled + std::copysign(0.5, scaled));
    begin_value(24);
    if (parts < 0) {
      *end_++ = '-';
      parts = -parts;
    }
    while (decimals > 0 && parts % 10 == 0) {
      parts /= 10;
      --decimals;
    }
    char digits[20];
    char* first = digits + sizeof digits;
    for (int i = 0; i < decimals; ++i, parts /= 10) *--first = static_cast<char>('0' + parts % 10);
    if (decimals > 0) *--first = '.';
    do {
      *--first = static_cast<char>('0' + parts % 10);
      parts /= 10;
    } while (parts != 0);
    put({first, static_cast<std::size_t>(digits + sizeof digits - first)});
    return *this;
  }
  // Adds a number of unknown size: five significant digits below 0.1, otherwise `decimals` decimals.
  JsonText& quantity(double value, int decimals) {
    const double size = std::abs(value);
    return size > 0.0 && size < 0.1 ? shortest(value) : number(value, decimals);
  }

 private:
  JsonText& shortest(double value) {
    begin_value(32);
    end_ = std::to_chars(end_, end_ + 32, value, std::chars_format::general, 5).ptr;
    return *this;
  }
  void begin_value(std::size_t bytes) {
    make_room(bytes + 1);
    if (!first_) *end_++ = ',';
    first_ = false;
  }
  void make_room(std::size_t bytes) {
    const std::size_t used = text().size();
    if (memory_.size() - used >= bytes) return;
    memory_.resize(2 * (used + bytes));
    end_ = memory_.data() + used;
  }
  void put(std::string_view text) {
    std::memcpy(end_, text.data(), text.size());
    end_ += text.size();
  }

  std::vector<char> memory_;
  char* end_;
  bool first_ = true;
};

}  // namespace regista::texts
