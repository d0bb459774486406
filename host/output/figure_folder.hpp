// SPDX-License-Identifier: MIT
// The figures of a study as files of a folder: data (CSV) and pictures (SVG).
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "output/replaced_file.hpp"
#include "report/figure.hpp"

namespace regista::output {

struct FigureWishes {
  std::optional<std::filesystem::path> folder;  // made where it is missing; without one no file is written
  Existing existing = Existing::refused;
  bool only_these = false;  // figures of an earlier study are removed from the folder first
};

// Throws BadInput when the folder cannot be made, and what write_whole() throws.
void write_figures(const std::vector<report::Figure>& figures, const FigureWishes& wishes);

}  // namespace regista::output
