// SPDX-License-Identifier: MIT
// What every page of a study has to be: whole, every element closed, no script but ours, and nothing loaded from
// elsewhere.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "report/outline.hpp"
#include "report/page_assets.hpp"

namespace regista::report {

inline std::size_t count(const std::string& text, const std::string& part) {
  std::size_t out = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++out;
  return out;
}

inline std::vector<std::string> ids(const std::string& page) {
  std::vector<std::string> out;
  constexpr std::string_view before = "<section id=\"";
  for (std::size_t at = page.find(before); at != std::string::npos; at = page.find(before, at + 1)) {
    const std::size_t begin = at + before.size();
    out.push_back(page.substr(begin, page.find('"', begin) - begin));
  }
  return out;
}

inline void expect_sound(const std::string& page) {
  EXPECT_TRUE(is_our_page(page.substr(0, page_beginning)));
  EXPECT_THAT(page, testing::EndsWith("</html>\n"));
  for (const char* each : {"section", "details", "table", "figure", "ul", "li", "header", "p", "pre", "tr"}) {
    EXPECT_EQ(count(page, std::string("<") + each + ">") + count(page, std::string("<") + each + " "),
              count(page, std::string("</") + each + ">"))
        << each;
  }
  EXPECT_EQ(count(page, "<script"), 1u);
  EXPECT_THAT(page, testing::HasSubstr("<script>" + std::string(page_script.view()) + "</script>"));
  EXPECT_THAT(page, testing::HasSubstr("script-src '" + std::string(page_script_hash.view()) + "'"));
  for (const char* each : {"<link", "<img", "<iframe", "@import", "url(", "src=", "http:", "https:"}) {
    EXPECT_THAT(page, testing::Not(testing::HasSubstr(each)));
  }
}

}  // namespace regista::report
