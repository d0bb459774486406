// SPDX-License-Identifier: MIT
#include "report/html_table.hpp"

#include <cassert>

namespace regista::report {

HtmlTable::HtmlTable(std::vector<Heading> headings) {
  text_ << "<div class=\"wide\"><table>\n<thead><tr>"_html;
  for (const Heading& each : headings) {
    columns_.push_back(each.column);
    text_ << (each.column == Column::number ? "<th scope=\"col\" class=\"n\">"_html : "<th scope=\"col\">"_html)
          << each.title << "</th>"_html;
  }
  text_ << "</tr></thead>\n<tbody>\n"_html;
}

void HtmlTable::row(const std::vector<Html>& cells) {
  assert(cells.size() == columns_.size());
  text_ << "<tr>"_html;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    text_ << (columns_[i] == Column::number ? "<td class=\"n\">"_html : "<td>"_html) << cells[i] << "</td>"_html;
  }
  text_ << "</tr>\n"_html;
  ++rows_;
}

Html HtmlTable::html() const {
  Html out = text_;
  return out << "</tbody></table></div>\n"_html;
}

}  // namespace regista::report
