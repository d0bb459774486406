// SPDX-License-Identifier: MIT
// Writes an outline as one page of HTML, which needs no network and no other file. Its only script is our own; without
// the script the page shows the same content. The page contains no time of day and no running time.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "report/match_remarks.hpp"
#include "report/outline.hpp"
#include "report/page_assets.hpp"

namespace regista::report {
namespace {

using texts::data_address;
using texts::Html;
using texts::lines;
using texts::Markup;
using texts::path_address;
using texts::text;
using texts::operator""_html;

// The beginning of pages of Regista. The program never overwrites a file with another beginning.
constexpr Markup ours = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="generator" content="Regista )"_html;

constexpr Markup head = R"(page of results">
<meta name="viewport" content="width=device-width">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; style-src 'unsafe-inline'; img-src data:; script-src ')"_html;

// Widths of a figure with a neighbour and of the main figure, in units of a chart. They fit the columns in page.css.
constexpr double half_page_width = 560.0, lead_width = 720.0;
constexpr std::size_t long_words = 40, long_heading = 16;  // longer cells or headings get a column with a least width

struct PageFigures {
  std::span<const Figure> all;
  std::string lead;
};

bool is_on_page(Readers readers) { return readers != Readers::terminal; }

// Returns a text in which a line may break after each character of `behind`.
Html breakable(std::string_view words, std::string_view behind) {
  Html out;
  for (std::size_t begin = 0; begin < words.size();) {
    const std::size_t end = std::min(words.find_first_of(behind, begin), words.size() - 1) + 1;
    out << text(words.substr(begin, end - begin)) << (end < words.size() ? "<wbr>"_html : ""_html);
    begin = end;
  }
  return out;
}

Html address_of(const Sentence::Piece& link) {
  if (link.file.empty() && link.fragment.empty()) return path_address(link.text);
  Html out = link.file.empty() ? Html() : path_address(link.file);
  if (!link.fragment.empty()) out << "#"_html << text(link.fragment);
  return out;
}

Html html_of(const Sentence::Piece& piece) {
  struct Element {
    Markup before, behind;
    std::string_view breaks;  // a line may break after these characters
  };
  // Same order as Sentence::Kind. <bdi> keeps a right-to-left name from moving the words around it.
  constexpr std::array<Element, 7> elements{{{""_html, ""_html, ""},
                                             {"<strong>"_html, "</strong>"_html, ""},
                                             {"<bdi>"_html, "</bdi>"_html, "."},
                                             {"<code>"_html, "</code>"_html, ""},
                                             {"<code class=\"path\">"_html, "</code>"_html, "/._["},
                                             {"<i class=\"key "_html, "\"></i>"_html, ""},
                                             {"<a href=\""_html, "</a>"_html, ""}}};
  const auto& [before, behind, breaks] = elements[static_cast<std::size_t>(piece.kind)];
  Html out = before;
  if (piece.kind == Sentence::Kind::link) out << address_of(piece) << "\">"_html;
  return out << breakable(piece.text, breaks) << behind;
}

Html html_of(const Cell& cell) {
  Html out = html(cell.words);
  if (cell.stressed) out = Html("<span class=\"differs\">"_html) << out << "</span>"_html;
  if (cell.series > 0) {
    out = Html("<span style=\"background:color-mix(in srgb,var(--series-"_html)
          << text(fmt::format("{}) {:.0f}%,transparent)", cell.series, cell.ground)) << "\">"_html << out
          << "</span>"_html;
  }
  return out;
}

Html table_link(std::string_view file, std::string_view csv) {
  return Html("<a class=\"take\" download=\""_html)
         << text(file) << "\" href=\""_html << data_address("text/csv", csv) << "\">data as CSV</a>"_html;
}

Html table_html(const Table& table) {
  const auto begin = [](Column column, bool is_long = false) {
    return column == Column::number ? " class=\"n\">"_html : is_long ? " class=\"long\">"_html : ">"_html;
  };
  Html out = "<div class=\"wide"_html;
  if (table.sortable) out << " sortable"_html;
  if (table.style == Table::Style::values || table.style == Table::Style::tight) out << " values"_html;
  if (table.style == Table::Style::tight) out << " tight"_html;
  if (table.style == Table::Style::heat) out << " heat"_html;
  out << "\"><table>\n<thead><tr>"_html;
  for (const Heading& each : table.headings) {
    if (!is_on_page(each.readers)) continue;
    out << "<th scope=\"col\""_html << begin(each.column);
    Html title = html(each.title);
    if (plain(each.title).size() > long_heading) title = Html("<div class=\"heading\">"_html) << title << "</div>"_html;
    out << title << "</th>"_html;
  }
  out << "</tr></thead>\n<tbody>\n"_html;
  for (const Row& row : table.rows) {
    if (!is_on_page(row.readers)) continue;
    assert(row.cells.size() == table.headings.size());
    out << "<tr>"_html;
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
      const Heading& heading = table.headings[i];
      if (!is_on_page(heading.readers)) continue;
      const bool is_long = i > 0 && plain(row.cells[i].words).size() > long_words;
      out << "<td"_html << begin(heading.column, is_long) << html_of(row.cells[i]) << "</td>"_html;
    }
    out << "</tr>\n"_html;
  }
  out << "</tbody></table></div>\n"_html;
  if (!table.summary.empty()) {
    out = Html(table.open ? "<details open><summary>"_html : "<details><summary>"_html)
          << text(table.summary) << "</summary>\n"_html << out << "</details>\n"_html;
  }
  if (!table.csv.empty()) out << "<p class=\"note\">"_html << table_link(table.file, table.csv) << "</p>\n"_html;
  return out;
}

Html lines_html(const Lines& lines) {
  // Same order as Lines::Style.
  constexpr std::array<std::pair<Markup, Markup>, 4> around_each{{{"<p>"_html, "</p>\n"_html},
                                                                  {"<p class=\"note\">"_html, "</p>\n"_html},
                                                                  {"<li>"_html, "</li>\n"_html},
                                                                  {"<h3>"_html, "</h3>\n"_html}}};
  const auto& [before, behind] = around_each[static_cast<std::size_t>(lines.style)];
  Html out;
  for (const Sentence& each : lines.lines) out << before << html(each) << behind;
  if (lines.style != Lines::Style::list) return out;
  return Html("<ul>\n"_html) << out << "</ul>\n"_html;
}

// Returns a figure in a box. On a narrow screen the box scrolls, so that the letters of the figure stay legible.
Html figure_html(Figure figure, double width) {
  constexpr double legible = 10.0 / 14.0;  // relative to the size of letters in charts
  figure.chart.width = width;
  Html out = "<figure>\n<div class=\"drawn\"><div style=\"min-width:"_html;
  out << text(fmt::format("{:.0f}px", std::ceil(legible * width))) << "\">\n"_html << svg(figure, Medium::page)
      << "</div></div>\n<figcaption><b>"_html << text(figure.title) << ".</b> "_html << text(figure.description)
      << " "_html << table_link(figure.name + ".csv", figure.csv);
  return out << "</figcaption>\n</figure>\n"_html;
}

const Figure* find(std::span<const Figure> figures, std::string_view name) {
  const auto found = std::ranges::find(figures, name, &Figure::name);
  return found == figures.end() ? nullptr : &*found;
}

Html figures_html(const Figures& wanted, const PageFigures& figures) {
  std::vector<const Figure*> shown;
  for (const std::string& each : wanted.names) {
    const Figure* const found = find(figures.all, each);
    if (found != nullptr && each != figures.lead) shown.push_back(found);
  }
  // Two figures share a row. A last figure without a neighbour fills the width of the page.
  const std::size_t beside = wanted.style == Figures::Style::beside ? shown.size() / 2 * 2 : 0;
  Html pairs, out;
  for (std::size_t i = 0; i < beside; ++i) pairs << figure_html(*shown[i], half_page_width);
  if (beside > 0) out << "<div class=\"two\">\n"_html << pairs << "</div>\n"_html;
  for (std::size_t i = beside; i < shown.size(); ++i) out << figure_html(*shown[i], page_width);
  return out;
}

Html listing_html(const Listing& listing) {
  const Html content = Html("<pre>"_html) << lines(listing.text) << "</pre>\n"_html;
  if (listing.open) return content;
  return Html("<details><summary>"_html) << html(listing.summary) << "</summary>\n"_html << content
                                         << "</details>\n"_html;
}

Html items_html(const Section& section, const PageFigures& figures) {
  Html out;
  for (const Item& each : section.items) {
    if (!is_on_page(each.readers)) continue;
    if (const auto* const found = std::get_if<Lines>(&each.what)) out << lines_html(*found);
    if (const auto* const found = std::get_if<Table>(&each.what)) out << table_html(*found);
    if (const auto* const found = std::get_if<Figures>(&each.what)) out << figures_html(*found, figures);
    if (const auto* const found = std::get_if<Listing>(&each.what)) out << listing_html(*found);
  }
  return out;
}

Html section_html(const Section& section, const PageFigures& figures) {
  const Html content = items_html(section, figures);
  if (content.empty()) return {};
  return Html("<section id=\""_html) << text(section.id) << "\">\n<h2>"_html << text(section.title) << "</h2>\n"_html
                                     << content << "</section>\n"_html;
}

Html div_html(const Section& section) {
  if (section.empty()) return {};
  return Html("<div id=\""_html) << text(section.id) << "\">\n"_html << items_html(section, {}) << "</div>\n"_html;
}

// Writes the sentences beside the headline. Short sentences share a paragraph. A long sentence gets its own paragraph.
Html beside_html(const std::vector<Sentence>& sentences) {
  constexpr std::size_t long_sentence = 160;  // characters
  Html out, paragraph;
  const auto end = [&] {
    if (!paragraph.empty()) out << "<p class=\"beside\">"_html << paragraph << "</p>\n"_html;
    paragraph = {};
  };
  for (const Sentence& each : sentences) {
    const bool is_long = plain(each).size() > long_sentence;
    if (is_long) end();
    paragraph << html(each) << " "_html;
    if (is_long) end();
  }
  end();
  return out;
}

Html header_html(const Outline& outline) {
  Html out = "<header>\n<p class=\"kicker\">"_html;
  out << text(outline.kind + ": " + outline.title) << "</p>\n<h1 id=\"verdict\">"_html << html(outline.headline)
      << "</h1>\n"_html << beside_html(outline.beside);
  if (const std::string question = question_of(outline); !question.empty())
    out << "<p class=\"beside\">"_html << text(question) << "</p>\n"_html;
  return out << "</header>\n"_html;
}

// Returns HTML that makes a browser without scripts reload the page. The reloaded page begins at the top.
Html reload_html(int seconds) {
  if (seconds == 0) return {};
  return Html("<noscript><meta http-equiv=\"refresh\" content=\""_html)
         << text(std::to_string(seconds)) << "\"></noscript>\n"_html;
}

// Writes the main figure with the most important numbers beside it.
Html lead_html(const std::vector<Tile>& tiles, const PageFigures& figures) {
  Html numbers = "<div class=\"tiles\">\n"_html;
  for (const Tile& each : tiles) {
    numbers << "<div class=\"tile\"><b>"_html << text(each.number) << "</b><span>"_html << html(each.what)
            << "</span></div>\n"_html;
  }
  numbers << "</div>\n"_html;
  const Figure* const lead = find(figures.all, figures.lead);
  if (lead == nullptr) return numbers;
  return Html("<div class=\"lead\">\n"_html) << figure_html(*lead, lead_width) << numbers << "</div>\n"_html;
}

Html contents_html(const std::vector<std::pair<std::string, std::string>>& sections) {
  Html out = "<nav aria-label=\"Contents\"><ul>\n<li><a href=\"#verdict\">Verdict</a></li>\n"_html;
  for (const auto& [id, title] : sections)
    out << "<li><a href=\"#"_html << text(id) << "\">"_html << text(title) << "</a></li>\n"_html;
  return out << "</ul></nav>\n"_html;
}

}  // namespace

Html html(const Sentence& sentence) {
  Html out;
  for (const Sentence::Piece& each : sentence.pieces()) out << html_of(each);
  return out;
}

bool is_our_page(std::string_view beginning) { return beginning.starts_with(ours.view()); }

std::string outline_page(const Outline& outline, const std::string& results, const std::vector<Figure>& figures) {
  const PageFigures shown{figures, outline.lead};
  Html sections;
  std::vector<std::pair<std::string, std::string>> contents;
  const auto add = [&](const Section& section) {
    const Html content = section_html(section, shown);
    if (content.empty()) return;
    sections << content;
    contents.emplace_back(section.id, section.title);
  };
  add(played_section(outline.played));
  std::ranges::for_each(outline.sections, add);
  add(again_section(outline.played, results, outline.fingerprint));
  Html out = ours;
  out << head << page_script_hash << "'\">\n"_html << reload_html(outline.reload_seconds) << "<title>"_html
      << text(outline.title) << "</title>\n<style>"_html << page_style << "</style>\n</head>\n<body data-live=\""_html
      << text(std::to_string(outline.reload_seconds)) << "\">\n<main>\n<div class=\"top\">\n"_html;
  out << div_html(doubts(outline.remarks)) << header_html(outline) << lead_html(outline.tiles, shown) << "</div>\n"_html
      << contents_html(contents) << "<div class=\"content\">\n"_html << sections << div_html(notes_on(outline.remarks))
      << "<footer>Written by <code>regista report</code> from the stored results alone.</footer>\n</div>\n</main>\n<script>"_html
      << page_script << "</script>\n</body>\n</html>\n"_html;
  return out.str();
}

}  // namespace regista::report
