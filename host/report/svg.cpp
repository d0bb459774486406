// SPDX-License-Identifier: MIT
#include "report/svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <utility>
#include <vector>

#include "report/html.hpp"
#include "report/svg_tree.hpp"

namespace regista::report {
namespace {

// Groups that draw nothing; gnuplot writes many.
void prune(SvgElement& element) {
  for (SvgElement& child : element.children) prune(child);
  std::erase_if(element.children, [](const SvgElement& child) { return child.name == "g" && child.children.empty(); });
}

void collect_links(const SvgElement& element, std::set<std::string>& out) {
  if (element.name == "defs") return;
  if (const std::string* const link = element.value("xlink:href")) out.insert(link->substr(1));
  for (const SvgElement& child : element.children) collect_links(child, out);
}

// Definitions that nothing uses. A definition uses none but those before it.
void prune_definitions(SvgElement& element, std::set<std::string>& used) {
  for (SvgElement& child : element.children) prune_definitions(child, used);
  if (element.name != "defs") return;
  std::vector<SvgElement> kept;
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

  std::string write(const SvgElement& root) {
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
    for (const SvgElement& child : root.children) element(child);
    return std::move(out_) + "</svg>\n";
  }

 private:
  // The sheet under the picture: the page has its own.
  bool background(const SvgElement& element) const {
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

  void attribute(const SvgAttribute& each) {
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

  void element(const SvgElement& element_) {
    if (page_ && background(element_)) return;
    out_ += fmt::format("<{}", element_.name);
    for (const SvgAttribute& each : element_.attributes) attribute(each);
    if (element_.children.empty() && element_.text.empty()) {
      out_ += "/>\n";
      return;
    }
    // Gnuplot has escaped the text; it holds no <, for it was read up to the next one.
    out_ += '>';
    out_ += element_.text;
    if (element_.text.empty()) out_ += '\n';
    for (const SvgElement& child : element_.children) element(child);
    out_ += fmt::format("</{}>\n", element_.name);
  }

  const Figure& figure_;
  bool page_;
  std::string out_;
};

std::string rewritten(std::string_view svg, const Figure& figure, bool page) {
  SvgElement root = svg_tree(svg);
  prune(root);
  std::set<std::string> used;
  collect_links(root, used);
  prune_definitions(root, used);
  std::erase_if(root.children, [](const SvgElement& child) { return child.name == "defs" && child.children.empty(); });
  return Writer(figure, page).write(root);
}

}  // namespace

std::string svg_for_page(std::string_view svg, const Figure& figure) { return rewritten(svg, figure, true); }
std::string svg_for_file(std::string_view svg, const Figure& figure) { return rewritten(svg, figure, false); }

}  // namespace regista::report
