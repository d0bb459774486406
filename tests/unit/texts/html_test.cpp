// SPDX-License-Identifier: MIT
#include "texts/html.hpp"

#include <gmock/gmock.h>

#include <string>

#include "process/sanitized.hpp"
#include "texts/message.hpp"

namespace regista::texts {
namespace {

TEST(VisibleText, WhatIsSeenStaysAsItIs) {
  EXPECT_EQ(visible("Rot-Weiß 04, שלום, 日本, 🙂"), "Rot-Weiß 04, שלום, 日本, 🙂");
  EXPECT_EQ(visible(""), "");
}

TEST(VisibleText, WhatIsNotSeenIsEscaped) {
  EXPECT_EQ(visible(std::string("a\0b\x1b\x7f\r\n\t", 8)), "a\\x00b\\x1b\\x7f\\r\\n\\t");
  EXPECT_EQ(visible("\u202eevil\u2066 \u200b\u200f\u061c\ufeff\u2028\u0085"),
            "\\u202eevil\\u2066 \\u200b\\u200f\\u061c\\ufeff\\u2028\\x85");
  EXPECT_EQ(visible_lines("a\nb\tc\r"), "a\nb\\tc\\r");
}

// Every byte sequence of up to three bytes, and some longer ones: the result is well-formed by an independent reading.
bool well_formed(const std::string& text) {
  for (std::size_t i = 0; i < text.size();) {
    const auto byte = [&](std::size_t k) -> unsigned {
      return k < text.size() ? static_cast<unsigned char>(text[k]) : 0;
    };
    const auto next = [&](std::size_t k) { return byte(k) >= 0x80 && byte(k) <= 0xbf; };
    // Table 3-7 of the Unicode Standard.
    if (byte(i) <= 0x7f) {
      i += 1;
    } else if (byte(i) >= 0xc2 && byte(i) <= 0xdf && next(i + 1)) {
      i += 2;
    } else if (byte(i) >= 0xe0 && byte(i) <= 0xef && next(i + 1) && next(i + 2) &&
               !(byte(i) == 0xe0 && byte(i + 1) < 0xa0) && !(byte(i) == 0xed && byte(i + 1) > 0x9f)) {
      i += 3;
    } else if (byte(i) >= 0xf0 && byte(i) <= 0xf4 && next(i + 1) && next(i + 2) && next(i + 3) &&
               !(byte(i) == 0xf0 && byte(i + 1) < 0x90) && !(byte(i) == 0xf4 && byte(i + 1) > 0x8f)) {
      i += 4;
    } else {
      return false;
    }
  }
  return true;
}

TEST(VisibleText, IsWellFormedWhateverTheBytes) {
  for (unsigned a = 0; a < 256; a += sanitized ? 5 : 1) {
    for (unsigned b = 0; b < 256; b += sanitized ? 3 : 1) {
      for (const unsigned c : {0u, 0x41u, 0x80u, 0x9fu, 0xa0u, 0xbfu, 0xc2u, 0xedu, 0xffu}) {
        for (const char* end : {"", "\x80", "\xbf\xbf", "x"}) {
          const std::string bytes = {static_cast<char>(a), static_cast<char>(b), static_cast<char>(c)};
          const std::string seen = visible(bytes + end);
          ASSERT_TRUE(well_formed(seen)) << a << ' ' << b << ' ' << c;
          if (well_formed(bytes + end)) {
            ASSERT_EQ(seen.find("\xef\xbf\xbd"), std::string::npos) << a << ' ' << b;
          }
        }
      }
    }
  }
}

TEST(VisibleText, IsCutBetweenCharacters) {
  EXPECT_EQ(visible_at_most("日本語", 3), "日本語");
  EXPECT_EQ(visible_at_most("日本語", 2), "日本...");
}

TEST(HtmlText, EscapesWhatMeansSomething) {
  EXPECT_EQ(text("<script>alert('1' & \"2\")</script>").str(),
            "&lt;script&gt;alert(&#39;1&#39; &amp; &quot;2&quot;)&lt;/script&gt;");
  EXPECT_EQ(lines("a\n<b>").str(), "a\n&lt;b&gt;");
}

TEST(HtmlText, MarkupOfTheSourceIsKept) {
  Html page = "<p>"_html;
  page << text("<") << "</p>"_html;
  EXPECT_EQ(page.str(), "<p>&lt;</p>");
}

std::string decoded(std::string address) {
  std::string out;
  for (std::size_t i = 0; i < address.size(); ++i) {
    if (address[i] == '%') {
      out += static_cast<char>(std::stoi(address.substr(i + 1, 2), nullptr, 16));
      i += 2;
    } else {
      out += address[i];
    }
  }
  return out;
}

TEST(HtmlText, AddressesHoldAnyBytes) {
  std::string bytes;
  for (int i = 0; i < 256; ++i) bytes += static_cast<char>(i);
  const std::string address = data_address("text/csv", bytes).str(), begin = "data:text/csv;charset=utf-8,";
  ASSERT_TRUE(address.starts_with(begin));
  EXPECT_EQ(decoded(address.substr(begin.size())), bytes);
  EXPECT_EQ(address.find_first_of("\"'<> \n#?&"), std::string::npos);
}

TEST(HtmlText, PathsStayPaths) {
  EXPECT_EQ(path_address("a b/1.mcap").str(), "./a%20b/1.mcap");
  EXPECT_EQ(path_address("../x/1.mcap").str(), "../x/1.mcap");
  EXPECT_EQ(path_address("javascript:alert(1)").str(), "./javascript%3Aalert%281%29");
}

}  // namespace
}  // namespace regista::texts
