// SPDX-License-Identifier: MIT
// HTML that cannot be broken by what is put into it: markup comes from the source of this program alone (a literal with
// the suffix _html, checked by the compiler), and every other text enters through text(), which escapes it. There is no
// way to add a std::string as markup but Html::made_by_us, whose callers are few and say why.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace regista::texts {

// Markup that stands in the source.
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

  Html& operator<<(Markup markup);
  Html& operator<<(const Html& other);
  const std::string& str() const { return text_; }
  bool empty() const { return text_.empty(); }

 private:
  std::string text_;
};

// Text from anywhere, as a reader may see it (visible.hpp), for content and for values of attributes in double
// quotes.
Html text(std::string_view text);
Html lines(std::string_view text);  // ends of lines stay, for <pre>

// The text as an address in double quotes: "data:" and its media type, or a path relative to the page.
Html data_address(std::string_view media_type, std::string_view bytes);
Html path_address(std::string_view path);

}  // namespace regista::texts
