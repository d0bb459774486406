// SPDX-License-Identifier: MIT
#include "report/svg_tree.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

namespace regista::report {
namespace {

constexpr int deepest = 40;

constexpr std::array<std::string_view, 11> elements{"svg",     "g",        "defs",    "path", "rect", "circle",
                                                    "polygon", "polyline", "ellipse", "use",  "text"};
constexpr std::array<std::string_view, 3> left_out{"title", "desc", "filter"};
constexpr std::array<std::string_view, 30> attributes{"id",
                                                      "d",
                                                      "points",
                                                      "x",
                                                      "y",
                                                      "width",
                                                      "height",
                                                      "cx",
                                                      "cy",
                                                      "r",
                                                      "rx",
                                                      "ry",
                                                      "transform",
                                                      "fill",
                                                      "fill-opacity",
                                                      "stroke",
                                                      "stroke-opacity",
                                                      "stroke-width",
                                                      "color",
                                                      "xlink:href",
                                                      "viewBox",
                                                      "font-size",
                                                      "font-weight",
                                                      "font-family",
                                                      "stroke-linecap",
                                                      "text-anchor",
                                                      "stroke-linejoin",
                                                      "fill-rule",
                                                      "stroke-dasharray",
                                                      "shape-rendering"};

template <class Names>
bool among(const Names& names, std::string_view name) {
  return std::ranges::find(names, name) != names.end();
}

class Reader {
 public:
  explicit Reader(std::string_view svg) : rest_(svg) {}

  SvgElement read() {
    const std::size_t begin = rest_.find("<svg");
    if (begin == std::string_view::npos) fail("no <svg>");
    rest_.remove_prefix(begin);
    return element(0);
  }

 private:
  [[noreturn]] static void fail(const std::string& what) { throw StrangePicture("picture of gnuplot: " + what); }

  void skip_space() {
    while (!rest_.empty() && std::string_view(" \t\r\n").find(rest_.front()) != std::string_view::npos) {
      rest_.remove_prefix(1);
    }
  }
  bool take(std::string_view token) {
    if (!rest_.starts_with(token)) return false;
    rest_.remove_prefix(token.size());
    return true;
  }
  void want(std::string_view token) {
    if (!take(token)) fail(fmt::format("\"{}\" is missing", token));
  }
  std::string_view word() {
    std::size_t end = 0;
    const auto belongs = [](char c) {
      return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == ':' || c == '-';
    };
    while (end < rest_.size() && belongs(rest_[end])) ++end;
    if (end == 0) fail("a name is missing");
    return std::exchange(rest_, rest_.substr(end)).substr(0, end);
  }
  std::string_view until(char end) {
    const std::size_t found = rest_.find(end);
    if (found == std::string_view::npos) fail("it ends too early");
    return std::exchange(rest_, rest_.substr(found)).substr(0, found);
  }

  // Numbers, names of colours, transformations, paths of lines.
  static void check(std::string_view name, std::string_view value) {
    const bool plain = std::ranges::all_of(value, [](char c) {
      return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
             std::string_view(" \t\n#.,()+-_").find(c) != std::string_view::npos;
    });
    if (!plain || value.find("url") != std::string_view::npos) fail(fmt::format("value of {}", name));
    if (name == "xlink:href" && !value.starts_with('#')) fail("a link that leads out of it");
  }

  SvgElement element(int depth) {
    if (depth > deepest) fail("too deep");
    want("<");
    SvgElement out;
    out.name = word();
    const bool skipped = among(left_out, out.name);
    if (depth > 0 && !skipped && !inside_left_out_ && !among(elements, out.name)) {
      fail(fmt::format("element {}", out.name));
    }
    for (skip_space(); !rest_.starts_with('/') && !rest_.starts_with('>'); skip_space()) {
      const std::string_view name = word();
      skip_space();
      want("=");
      skip_space();
      const char quote = rest_.empty() ? '\0' : rest_.front();
      if (quote != '"' && quote != '\'') fail("a quote is missing");
      rest_.remove_prefix(1);
      const std::string_view value = until(quote);
      rest_.remove_prefix(1);
      if (skipped || inside_left_out_ || !among(attributes, name)) continue;
      check(name, value);
      out.attributes.push_back({name, std::string(value)});
    }
    if (take("/>")) return out;
    want(">");
    const bool before = std::exchange(inside_left_out_, inside_left_out_ || skipped);
    content(out, depth);
    inside_left_out_ = before;
    want(out.name);
    skip_space();
    want(">");
    return out;
  }

  // Up to the name in the end tag.
  void content(SvgElement& out, int depth) {
    while (true) {
      const std::string_view text = until('<');
      if (out.name == "text") out.text = text;
      if (take("</")) return;
      SvgElement child = element(depth + 1);
      if (out.name == "text") fail("an element in a text");
      if (!inside_left_out_ && !among(left_out, child.name)) out.children.push_back(std::move(child));
    }
  }

  std::string_view rest_;
  bool inside_left_out_ = false;
};

}  // namespace

SvgElement svg_tree(std::string_view svg) { return Reader(svg).read(); }

}  // namespace regista::report
