// SPDX-License-Identifier: MIT
// HTML that no inserted text can break. Markup comes only from literals of this program with the suffix _html, which
// the compiler checks. Every other text enters through text(), which escapes the text. Only Html::made_by_us turns a
// std::string into markup, and each of its few callers says why the string is safe.
#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <string>
#include <string_view>

namespace regista::texts {

// Markup from a literal in the source code.
class Markup {
 public:
  friend consteval Markup operator""_html(const char* text, std::size_t size);
  std::string_view view() const { return view_; }

 private:
  consteval explicit Markup(std::string_view view) : view_(view) {}
  std::string_view view_;
};

consteval Markup operator""_html(const char* text, std::size_t size) { return Markup({text, size}); }

class Html {
 public:
  Html() = default;
  Html(Markup markup) : text_(markup.view()) {}  // NOLINT(google-explicit-constructor): every Markup is Html
  static Html made_by_us(std::string markup);

  Html& operator<<(const Html& other) {
    text_ += other.text_;
    return *this;
  }
  const std::string& str() const { return text_; }
  bool empty() const { return text_.empty(); }

 private:
  std::string text_;
};

// Converts text to its visible form (message.hpp) with HTML escapes, for content and attribute values in double quotes.
Html text(std::string_view text);
Html lines(std::string_view text);  // keeps line ends, for <pre>

// Addresses in double quotes: data_address() returns a "data:" address, path_address() a path relative to the page.
Html data_address(std::string_view media_type, std::string_view bytes);
Html path_address(std::string_view path);

// --- SVG pictures (https://www.w3.org/TR/SVG2/) from numbers and words. The program writes SVG only through these
// functions. text() escapes all words.

// Fills the format, which is a literal of this program, with numbers and string literals. The result is markup.
template <class... Numbers>
Html drawn(fmt::format_string<Numbers...> format, Numbers... numbers) {
  return Html::made_by_us(fmt::vformat(format, fmt::make_format_args(numbers...)));
}

// `attribute` ("class" or "text-anchor") and its value are string literals.
inline Html label(double x, double y, const char* attribute, const char* value, std::string_view words) {
  Html out = drawn(R"(<text x="{:.1f}" y="{:.1f}" {}="{}">)", x, y, attribute, value);
  return out << text(words) << "</text>"_html;
}
inline Html label(double x, double y, const char* classes, std::string_view words) {
  return label(x, y, "class", classes, words);
}

// Returns a label that is turned around (x, y) by `degrees`.
inline Html turned_label(double x, double y, double degrees, const char* attribute, const char* value,
                         std::string_view words) {
  Html out =
      drawn(R"x(<text {}="{}" transform="translate({:.1f} {:.1f}) rotate({:.0f})">)x", attribute, value, x, y, degrees);
  return out << text(words) << "</text>"_html;
}

// Begins a picture file with a white background. "</svg>" ends it.
inline Html sheet(double width, double height) {
  return drawn(R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {0:.0f} {1:.0f}" width="{0:.0f}" )"
               R"(height="{1:.0f}"><rect width="100%" height="100%" fill="#fff"/>)",
               width, height);
}

// --- Base64 of RFC 4648, section 4: converts bytes to text for a page.

inline void append_base64(std::string& to, std::string_view bytes) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const auto byte = [&](std::size_t i) { return i < bytes.size() ? static_cast<unsigned char>(bytes[i]) : 0u; };
  to.reserve(to.size() + (bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const unsigned group = byte(i) << 16 | byte(i + 1) << 8 | byte(i + 2);
    to += digits[group >> 18];
    to += digits[group >> 12 & 63];
    to += i + 1 < bytes.size() ? digits[group >> 6 & 63] : '=';
    to += i + 2 < bytes.size() ? digits[group & 63] : '=';
  }
}

}  // namespace regista::texts
