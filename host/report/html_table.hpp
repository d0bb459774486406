// SPDX-License-Identifier: MIT
// A table of a page. Columns of numbers stand at the right, so that digits stand below each other.
#pragma once

#include <initializer_list>
#include <vector>

#include "report/html.hpp"

namespace regista::report {

enum class Column { words, number };

struct Heading {
  Html title;
  Column column = Column::number;
};

class HtmlTable {
 public:
  explicit HtmlTable(std::vector<Heading> headings);
  // As many cells as there are headings.
  void row(const std::vector<Html>& cells);
  bool empty() const { return rows_ == 0; }
  Html html() const;  // in a box that can be moved sideways where it is too wide

 private:
  std::vector<Column> columns_;
  Html text_;
  std::size_t rows_ = 0;
};

}  // namespace regista::report
