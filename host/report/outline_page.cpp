// SPDX-License-Identifier: MIT
// An outline as one page of HTML that needs nothing else: no network, no script. A function of the outline and of the
// figures; no time of day and no running time is in it.
#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <utility>

#include "report/match_remarks.hpp"
#include "report/outline.hpp"
#include "report/page_style.hpp"

namespace regista::report {
namespace {

// What a file begins with that may be replaced by one of ours.
constexpr Markup ours = R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="generator" content="Regista )"_html;

constexpr Markup head = R"(page of results">
<meta name="viewport" content="width=device-width">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; style-src 'unsafe-inline'; img-src data:">
)"_html;

bool is_on_page(Readers readers) { return readers != Readers::terminal; }

// It may go on in a new line behind each of these characters.
Html breakable(std::string_view words, std::string_view behind) {
  Html out;
  for (std::size_t begin = 0; begin < words.size();) {
    const std::size_t end = std::min(words.find_first_of(behind, begin), words.size() - 1) + 1;
    out << text(words.substr(begin, end - begin)) << (end < words.size() ? "<wbr>"_html : ""_html);
    begin = end;
  }
  return out;
}

Html html_of(const Sentence::Piece& piece) {
  Html out;
  switch (piece.kind) {
    case Sentence::Kind::words:
      return text(piece.text);
    case Sentence::Kind::strong:
      return out << "<strong>"_html << text(piece.text) << "</strong>"_html;
    case Sentence::Kind::name:
      // Set apart so that its direction of writing does not move what surrounds it.
      return out << "<bdi>"_html << breakable(piece.text, ".") << "</bdi>"_html;
    case Sentence::Kind::code:
      return out << "<code>"_html << text(piece.text) << "</code>"_html;
    case Sentence::Kind::path:
      return out << "<code class=\"path\">"_html << breakable(piece.text, "._") << "</code>"_html;
    case Sentence::Kind::mark:
      return out << "<i class=\"key "_html << text(piece.text) << "\"></i>"_html;
    case Sentence::Kind::link:
      return out << "<a href=\""_html << path_address(piece.text) << "\">"_html << text(piece.text) << "</a>"_html;
  }
  return out;
}

Html html_of(const Cell& cell) {
  Html out = html(cell.words);
  if (cell.stressed) {
    Html stressed = "<span class=\"differs\">"_html;
    out = stressed << out << "</span>"_html;
  }
  if (cell.series > 0) {
    Html ground = "<span style=\"background:color-mix(in srgb,var(--series-"_html;
    out = ground << text(fmt::format("{}) {:.0f}%,transparent)", cell.series, cell.ground)) << "\">"_html << out
                 << "</span>"_html;
  }
  return out;
}

Html table_link(std::string_view file, std::string_view csv) {
  Html out = "<a class=\"take\" download=\""_html;
  return out << text(file) << "\" href=\""_html << data_address("text/csv", csv) << "\">data as CSV</a>"_html;
}

Html table_html(const Table& table) {
  const auto begin = [](Column column) { return column == Column::number ? " class=\"n\">"_html : ">"_html; };
  Html out = "<div class=\"wide"_html;
  switch (table.look) {
    case Table::Look::plain:
      break;
    case Table::Look::values:
      out << " values"_html;
      break;
    case Table::Look::tight:
      out << " values tight"_html;
      break;
    case Table::Look::heat:
      out << " heat"_html;
      break;
  }
  out << "\"><table>\n<thead><tr>"_html;
  for (const Heading& each : table.headings) {
    if (!is_on_page(each.readers)) continue;
    out << "<th scope=\"col\""_html << begin(each.column) << html(each.title) << "</th>"_html;
  }
  out << "</tr></thead>\n<tbody>\n"_html;
  for (const Row& row : table.rows) {
    if (!is_on_page(row.readers)) continue;
    assert(row.cells.size() == table.headings.size());
    out << "<tr>"_html;
    for (std::size_t i = 0; i < row.cells.size(); ++i) {
      const Heading& heading = table.headings[i];
      if (is_on_page(heading.readers))
        out << "<td"_html << begin(heading.column) << html_of(row.cells[i]) << "</td>"_html;
    }
    out << "</tr>\n"_html;
  }
  out << "</tbody></table></div>\n"_html;
  if (!table.summary.empty()) {
    Html folded = table.open ? "<details open><summary>"_html : "<details><summary>"_html;
    out = folded << text(table.summary) << "</summary>\n"_html << out << "</details>\n"_html;
  }
  if (!table.csv.empty()) out << "<p class=\"note\">"_html << table_link(table.file, table.csv) << "</p>\n"_html;
  return out;
}

// What is put around each line, and behind it.
std::pair<Markup, Markup> marks_of(Lines::Look look) {
  switch (look) {
    case Lines::Look::note:
      return {"<p class=\"note\">"_html, "</p>\n"_html};
    case Lines::Look::list:
      return {"<li>"_html, "</li>\n"_html};
    case Lines::Look::heading:
      return {"<h3>"_html, "</h3>\n"_html};
    case Lines::Look::paragraphs:
      break;
  }
  return {"<p>"_html, "</p>\n"_html};
}

Html lines_html(const Lines& lines) {
  Html out;
  const auto [before, behind] = marks_of(lines.look);
  for (const Sentence& each : lines.lines) out << before << html(each) << behind;
  if (lines.look != Lines::Look::list) return out;
  Html list = "<ul>\n"_html;
  return list << out << "</ul>\n"_html;
}

Html figure(std::span<const Figure> figures, std::string_view figure_name) {
  const auto found = std::ranges::find(figures, figure_name, &Figure::name);
  if (found == figures.end()) return {};
  Html out = "<figure>\n"_html;
  return out << svg(*found, Look::page) << "<figcaption><b>"_html << text(found->title) << ".</b> "_html
             << text(found->description) << " "_html << table_link(found->name + ".csv", found->csv)
             << "</figcaption>\n</figure>\n"_html;
}

Html figures_html(const Figures& wanted, const std::vector<Figure>& figures) {
  Html out;
  for (const std::string& each : wanted.names) out << figure(figures, each);
  if (out.empty() || wanted.look == Figures::Look::single) return out;
  Html box = wanted.look == Figures::Look::wide ? "<div class=\"full\">\n"_html : "<div class=\"two\">\n"_html;
  return box << out << "</div>\n"_html;
}

Html listing_html(const Listing& listing) {
  Html content = "<pre>"_html;
  content << lines(listing.text) << "</pre>\n"_html;
  if (listing.open) return content;
  Html out = "<details><summary>"_html;
  return out << html(listing.summary) << "</summary>\n"_html << content << "</details>\n"_html;
}

Html items_html(const Section& section, const std::vector<Figure>& figures) {
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

Html section_html(const Section& section, const std::vector<Figure>& figures) {
  const Html content = items_html(section, figures);
  if (content.empty()) return {};
  Html out = "<section id=\""_html;
  return out << text(section.id) << "\">\n<h2>"_html << text(section.title) << "</h2>\n"_html << content
             << "</section>\n"_html;
}

// Without a title.
Html div_html(const Section& section) {
  if (section.empty()) return {};
  Html out = "<div id=\""_html;
  return out << text(section.id) << "\">\n"_html << items_html(section, {}) << "</div>\n"_html;
}

Html header_html(const Outline& outline) {
  Html out = "<header>\n<p class=\"kicker\">"_html;
  out << text(outline.kind + ": " + outline.title) << "</p>\n<h1 id=\"verdict\">"_html << html(outline.headline)
      << "</h1>\n<p class=\"beside\">"_html;
  for (const Sentence& each : outline.beside) out << html(each) << " "_html;
  out << "</p>\n"_html;
  if (const std::string question = question_of(outline); !question.empty())
    out << "<p class=\"beside\">"_html << text(question) << "</p>\n"_html;
  return out << "</header>\n"_html;
}

Html tiles_html(const std::vector<Tile>& tiles) {
  Html out = "<div class=\"tiles\">\n"_html;
  for (const Tile& each : tiles) {
    out << "<div class=\"tile\"><b>"_html << text(each.number) << "</b><span>"_html << html(each.what)
        << "</span></div>\n"_html;
  }
  return out << "</div>\n"_html;
}

}  // namespace

Html html(const Sentence& sentence) {
  Html out;
  for (const Sentence::Piece& each : sentence.pieces()) out << html_of(each);
  return out;
}

bool is_our_page(std::string_view beginning) { return beginning.starts_with(ours.view()); }

std::string outline_page(const Outline& outline, const std::string& results, const std::vector<Figure>& figures) {
  Html out = ours;
  out << head << "<title>"_html << text(outline.title) << "</title>\n<style>"_html << page_style
      << "</style>\n</head>\n<body>\n<main>\n"_html;
  out << div_html(doubts(outline.remarks)) << header_html(outline) << tiles_html(outline.tiles)
      << section_html(played_section(outline.played), {});
  for (const Section& each : outline.sections) out << section_html(each, figures);
  out << section_html(again_section(outline.played, results, outline.fingerprint), {});
  out << div_html(notes_on(outline.remarks))
      << "<footer>Written by <code>regista report</code> from the stored results alone.</footer>\n</main>\n</body>\n</html>\n"_html;
  return out.str();
}

}  // namespace regista::report
