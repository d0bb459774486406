// SPDX-License-Identifier: MIT
#include "output/figure_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <system_error>

#include "config/bad_input.hpp"
#include "report/experiment_figures.hpp"
#include "report/tuning_figures.hpp"

namespace regista::output {
namespace {

namespace fs = std::filesystem;

// Scripts and pixels were written by versions before this one.
constexpr std::array<std::string_view, 4> figure_endings{".csv", ".svg", ".gnuplot", ".png"};

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directory(folder, error);
  if (!error && fs::is_directory(folder)) return;
  throw config::BadInput(fmt::format("cannot make the folder {}: {}", folder.string(),
                                     error ? error.message() : std::string("there is a file of this name")));
}

// Files of the names that a study's figures have, and no others. What cannot be removed stays.
void remove_study_figures(const fs::path& folder) {
  std::vector<fs::path> found;
  std::error_code error;
  for (const fs::directory_entry& each : fs::directory_iterator(folder, error)) {
    const fs::path& file = each.path();
    std::error_code unknown;
    if (!fs::is_regular_file(each.symlink_status(unknown))) continue;
    const bool ours = std::ranges::find(figure_endings, file.extension().string()) != figure_endings.end();
    const std::string stem = file.stem().string();
    const bool known = report::is_experiment_figure(stem) || report::is_tuning_figure(stem);
    if (ours && known) found.push_back(file);
  }
  for (const fs::path& each : found) fs::remove(each, error);
}

}  // namespace

void write_figures(const std::vector<report::Figure>& figures, const FigureWishes& wishes) {
  if (!wishes.folder) return;
  make_folder(*wishes.folder);
  if (wishes.only_these) remove_study_figures(*wishes.folder);
  for (const report::Figure& each : figures) {
    write_whole(*wishes.folder / (each.name + ".csv"), each.csv, wishes.existing);
    write_whole(*wishes.folder / (each.name + ".svg"), svg(each, report::Look::file).str(), wishes.existing);
  }
}

}  // namespace regista::output
