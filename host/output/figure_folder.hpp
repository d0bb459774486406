// SPDX-License-Identifier: MIT
// The figures of a study: drawn for its page and, where a folder is named, kept there as data (CSV), script (gnuplot)
// and pictures (SVG, PNG).
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "output/replaced_file.hpp"
#include "report/page_parts.hpp"

namespace regista::output {

struct FigureWishes {
  std::optional<std::filesystem::path> folder;  // made where it is missing
  bool png = false;
  Existing existing = Existing::refused;
  bool only_these = false;  // figures of an earlier study are removed from the folder first
};

struct DrawnFigures {
  std::vector<report::PageFigure> figures;
  std::string why_not;  // one line for all that could not be drawn; empty: all were
};

// Throws BadInput when the folder cannot be made, and what write_whole() throws.
DrawnFigures draw_figures(const std::vector<report::Figure>& figures, const FigureWishes& wishes);

}  // namespace regista::output
