// SPDX-License-Identifier: MIT
#include "report/svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <utility>
#include <vector>

#include "report/html_text.hpp"

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

struct Attribute {
  std::string_view name;
  std::string value;
};

struct Element {
  std::string_view name;
  std::vector<Attribute> attributes;
  std::vector<Element> children;
  std::string_view text;  // as it stood, its entities too

  const std::string* value(std::string_view of) const {
    const auto found = std::ranges::find(attributes, of, &Attribute::name);
    return found == attributes.end() ? nullptr : &found->value;
  }
};

class Reader {
 public:
  explicit Reader(std::string_view svg) : rest_(svg) {}

  Element read() {
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

  Element element(int depth) {
    if (depth > deepest) fail("too deep");
    want("<");
    Element out;
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
  void content(Element& out, int depth) {
    while (true) {
      const std::string_view text = until('<');
      if (out.name == "text") out.text = text;
      if (take("</")) return;
      Element child = element(depth + 1);
      if (out.name == "text") fail("an element in a text");
      if (!inside_left_out_ && !among(left_out, child.name)) out.children.push_back(std::move(child));
    }
  }

  std::string_view rest_;
  bool inside_left_out_ = false;
};

// Groups that draw nothing; gnuplot writes many.
void prune(Element& element) {
  for (Element& child : element.children) prune(child);
  std::erase_if(element.children, [](const Element& child) { return child.name == "g" && child.children.empty(); });
}

void collect_links(const Element& element, std::set<std::string>& out) {
  if (element.name == "defs") return;
  if (const std::string* const link = element.value("xlink:href")) out.insert(link->substr(1));
  for (const Element& child : element.children) collect_links(child, out);
}

// Definitions that nothing uses. A definition uses none but those before it.
void prune_definitions(Element& element, std::set<std::string>& used) {
  for (Element& child : element.children) prune_definitions(child, used);
  if (element.name != "defs") return;
  std::vector<Element> kept;
  for (auto each = element.children.rbegin(); each != element.children.rend(); ++each) {
    const std::string* const id = each->value("id");
    if (id == nullptr || !used.contains(*id)) continue;
    if (const std::string* const link = each->value("xlink:href")) used.insert(link->substr(1));
    kept.push_back(std::move(*each));
  }
  std::ranges::reverse(kept);
  element.children = std::move(kept);
}

// "rgb(  0, 114, 178)", "black" -> "#0072b2", "#000000"
std::string as_hexadecimal(const std::string& colour) {
  if (colour == "black") return "#000000";
  if (colour == "white") return "#ffffff";
  if (colour == "gray") return "#808080";
  if (!colour.starts_with("rgb(")) return colour;
  std::array<unsigned, 3> parts{};
  std::size_t part = 0;
  for (const char c : colour.substr(4)) {
    if (c >= '0' && c <= '9') parts[part] = std::min(parts[part] * 10 + static_cast<unsigned>(c - '0'), 255u);
    if (c == ',' && part < 2) ++part;
  }
  return fmt::format("#{:02x}{:02x}{:02x}", parts[0], parts[1], parts[2]);
}

bool is_colour(std::string_view attribute) {
  return attribute == "fill" || attribute == "stroke" || attribute == "color";
}

class Writer {
 public:
  Writer(const Figure& figure, bool page) : figure_(figure), page_(page) {}

  std::string write(const Element& root) {
    const std::string* const box = root.value("viewBox");
    if (box == nullptr) throw StrangePicture("picture of gnuplot: it has no size");
    const Html title = text(figure_.title), description = text(figure_.description);
    out_ = page_ ? "<svg role=\"img\" " : "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<svg ";
    out_ += fmt::format("viewBox=\"{}\" ", *box);
    if (page_) {
      out_ += fmt::format("aria-label=\"{}: {}\">", title.str(), description.str());
    } else {
      out_ += fmt::format(
          "width=\"{}\" height=\"{}\" xmlns=\"http://www.w3.org/2000/svg\" "
          "xmlns:xlink=\"http://www.w3.org/1999/xlink\">\n<title>{}</title><desc>{}</desc>",
          figure_.width, figure_.height, title.str(), description.str());
    }
    out_ += '\n';
    for (const Element& child : root.children) element(child);
    return std::move(out_) + "</svg>\n";
  }

 private:
  // The sheet under the picture: the page has its own.
  bool background(const Element& element) const {
    const std::string *const fill = element.value("fill"), *const x = element.value("x"),
                             *const width = element.value("width");
    return element.name == "rect" && fill != nullptr && x != nullptr && width != nullptr && *x == "0" &&
           *width == std::to_string(figure_.width) && as_hexadecimal(*fill) == "#ffffff";
  }

  std::string colour(const std::string& given) const {
    const std::string exact = as_hexadecimal(given);
    if (!page_) return exact;
    if (exact == "#000000") return "currentColor";
    if (exact == grid_colour || exact == "#808080") return "var(--grid)";
    if (exact == "#ffffff") return "var(--background)";
    const auto series = std::ranges::find(colours, exact);
    return series == colours.end() ? exact : fmt::format("var(--series-{})", series - colours.begin() + 1);
  }

  void attribute(const Attribute& each) {
    std::string_view name = each.name;
    std::string value = each.value;
    if (name == "font-family" && page_) return;
    if (name == "id") value = figure_.name + '-' + value;
    if (name == "xlink:href") {
      value = fmt::format("#{}-{}", figure_.name, value.substr(1));
      if (page_) name = "href";
    }
    if (is_colour(name)) {
      value = colour(value);
      if (name == "color" && value == "currentColor") return;  // inherited
    }
    out_ += fmt::format(" {}=\"{}\"", name, value);
  }

  void element(const Element& element_) {
    if (page_ && background(element_)) return;
    out_ += fmt::format("<{}", element_.name);
    for (const Attribute& each : element_.attributes) attribute(each);
    if (element_.children.empty() && element_.text.empty()) {
      out_ += "/>\n";
      return;
    }
    // Gnuplot has escaped the text; it holds no <, for it was read up to the next one.
    out_ += '>';
    out_ += element_.text;
    if (element_.text.empty()) out_ += '\n';
    for (const Element& child : element_.children) element(child);
    out_ += fmt::format("</{}>\n", element_.name);
  }

  const Figure& figure_;
  bool page_;
  std::string out_;
};

std::string rewritten(std::string_view svg, const Figure& figure, bool page) {
  Element root = Reader(svg).read();
  prune(root);
  std::set<std::string> used;
  collect_links(root, used);
  prune_definitions(root, used);
  std::erase_if(root.children, [](const Element& child) { return child.name == "defs" && child.children.empty(); });
  return Writer(figure, page).write(root);
}

}  // namespace

std::string svg_for_page(std::string_view svg, const Figure& figure) { return rewritten(svg, figure, true); }
std::string svg_for_file(std::string_view svg, const Figure& figure) { return rewritten(svg, figure, false); }

}  // namespace regista::report
