// SPDX-License-Identifier: MIT
// A reader of pictures: the elements of an SVG and where they are, for tests.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace regista::report {

struct Element {
  std::string name, text;
  std::map<std::string, std::string> attributes;
  std::size_t parent;

  double number(const std::string& attribute) const { return std::stod(attributes.at(attribute)); }
};

std::string unescaped(std::string text) {
  for (const auto& [written, meant] : std::vector<std::pair<std::string, std::string>>{
           {"&lt;", "<"}, {"&gt;", ">"}, {"&quot;", "\""}, {"&#39;", "'"}, {"&amp;", "&"}}) {
    for (std::size_t at = 0; (at = text.find(written, at)) != std::string::npos; at += meant.size())
      text.replace(at, written.size(), meant);
  }
  return text;
}

// Of well-formed XML; else a failure.
std::vector<Element> read(const std::string& xml) {
  std::vector<Element> out;
  std::vector<std::size_t> open;
  std::size_t at = xml.starts_with("<?xml") ? xml.find("?>") + 2 : 0;
  while (at < xml.size()) {
    const std::size_t tag = std::min(xml.find('<', at), xml.size());
    const std::string text = xml.substr(at, tag - at);
    EXPECT_EQ(text.find('>'), std::string::npos) << text;
    if (!open.empty()) out[open.back()].text += unescaped(text);
    if (tag == xml.size()) break;
    const std::size_t end = xml.find('>', tag);
    if (end == std::string::npos) {
      ADD_FAILURE() << "a tag without an end";
      break;
    }
    std::string inside = xml.substr(tag + 1, end - tag - 1);
    at = end + 1;
    if (inside.starts_with('/')) {
      if (open.empty() || out[open.back()].name != inside.substr(1)) {
        ADD_FAILURE() << "it ends what is not open: " << inside;
        break;
      }
      open.pop_back();
      continue;
    }
    const bool empty = inside.ends_with('/');
    if (empty) inside.pop_back();
    Element element{inside.substr(0, inside.find(' ')), "", {}, open.empty() ? 0 : open.back()};
    for (std::size_t space = inside.find(' '); space < inside.size();) {
      const std::size_t equals = inside.find("=\"", space), quote = inside.find('"', equals + 2);
      if (equals == std::string::npos || quote == std::string::npos) {
        ADD_FAILURE() << "an attribute without a value: " << inside;
        break;
      }
      const std::string name = inside.substr(space + 1, equals - space - 1);
      EXPECT_TRUE(element.attributes.emplace(name, unescaped(inside.substr(equals + 2, quote - equals - 2))).second);
      EXPECT_EQ(name.find_first_not_of("abcdefghijklmnopqrstuvwxyzBox-:"), std::string::npos) << name;
      space = quote + 1;
    }
    out.push_back(std::move(element));
    if (!empty) open.push_back(out.size() - 1);
  }
  EXPECT_TRUE(open.empty());
  return out;
}

struct Segment {
  double x0, y0, x1, y1;
};

// Of the paths in this colour.
std::vector<Segment> segments(const std::vector<Element>& picture, const std::string& stroke) {
  std::vector<Segment> out;
  for (const Element& each : picture) {
    if (each.name != "path" || !each.attributes.contains("stroke") || each.attributes.at("stroke") != stroke) continue;
    double x = 0.0, y = 0.0;
    const std::string& d = each.attributes.at("d");
    for (std::size_t at = 0; at < d.size();) {
      std::size_t first = 0, second = 0;
      const double to_x = std::stod(d.substr(at + 1), &first), to_y = std::stod(d.substr(at + 1 + first), &second);
      if (d[at] == 'L') out.push_back({x, y, to_x, to_y});
      x = to_x;
      y = to_y;
      at += 1 + first + second;
    }
  }
  return out;
}

struct Place {
  double at, value;
};

// The ticks of an axis: their marks, and the numbers beside them.
std::vector<Place> ticks_of(const std::vector<Element>& picture, bool x) {
  std::vector<double> marks, numbers;
  for (const Segment& each : segments(picture, "#000000")) {
    const double across = x ? each.y1 - each.y0 : each.x1 - each.x0, along = x ? each.x1 - each.x0 : each.y1 - each.y0;
    if (along == 0.0 && std::abs(across) < 10.0) marks.push_back(x ? each.x0 : each.y0);
  }
  for (const Element& each : picture) {
    if (each.name != "text" || each.attributes.at("text-anchor") != (x ? "middle" : "end")) continue;
    std::size_t end = 0;
    const bool number = each.text.find_first_not_of("0123456789.e+-") == std::string::npos;
    if (number) numbers.push_back(std::stod(each.text, &end));
  }
  EXPECT_EQ(marks.size(), numbers.size());
  std::vector<Place> out;
  for (std::size_t i = 0; i < std::min(marks.size(), numbers.size()); ++i) out.push_back({marks[i], numbers[i]});
  return out;
}

// Where a value has to lie, by the first and the last tick.
double expected(const std::vector<Place>& ticks, double value, bool logarithmic = false) {
  const auto of = [&](double each) { return logarithmic ? std::log10(each) : each; };
  const Place &first = ticks.front(), &last = ticks.back();
  return first.at + (of(value) - of(first.value)) / (of(last.value) - of(first.value)) * (last.at - first.at);
}

std::vector<Element> all(const std::vector<Element>& picture, const std::string& name) {
  std::vector<Element> out;
  std::ranges::copy_if(picture, std::back_inserter(out), [&](const Element& each) { return each.name == name; });
  return out;
}

}  // namespace regista::report
