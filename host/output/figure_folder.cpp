// SPDX-License-Identifier: MIT
#include "output/figure_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <system_error>

#include "config/bad_input.hpp"
#include "report/experiment_figures.hpp"
#include "report/gnuplot.hpp"
#include "report/svg.hpp"
#include "report/tuning_figures.hpp"

namespace regista::output {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 4> figure_endings{".csv", ".gnuplot", ".svg", ".png"};

void write_figure(const fs::path& folder, const report::Drawing& drawn, const std::string& svg, Existing existing) {
  const report::Figure& figure = drawn.figure;
  const auto write = [&](std::string_view end, std::string_view bytes) {
    if (!bytes.empty()) write_whole(folder / (figure.name + std::string(end)), bytes, existing);
  };
  write(figure_endings[0], figure.csv);
  write(figure_endings[1], report::gnuplot_script(figure, report::Picture::svg));
  write(figure_endings[2], svg);
  write(figure_endings[3], drawn.png);
}

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

DrawnFigures draw_figures(const std::vector<report::Figure>& figures, const FigureWishes& wishes) {
  if (wishes.folder) make_folder(*wishes.folder);
  if (wishes.folder && wishes.only_these) remove_study_figures(*wishes.folder);
  DrawnFigures out;
  std::string& why_not = out.why_not;
  for (const report::Figure& figure : figures) {
    report::Drawing drawing = report::draw(figure, wishes.png ? report::Png::wanted : report::Png::left_out);
    report::PageFigure& shown = out.figures.emplace_back();
    std::string file;
    try {
      if (!drawing.svg.empty()) {
        shown.svg = report::svg_for_page(drawing.svg, drawing.figure);
        file = report::svg_for_file(drawing.svg, drawing.figure);
      }
    } catch (const report::StrangePicture& error) {
      drawing.why_not = error.what();
    }
    if (wishes.folder) write_figure(*wishes.folder, drawing, file, wishes.existing);
    shown.why_not = drawing.why_not;
    if (why_not.empty() && drawing.no_gnuplot) {
      why_not = "figures are left out: gnuplot is not installed; on Debian: apt install gnuplot-nox";
    } else if (why_not.empty() && !drawing.why_not.empty()) {
      why_not = fmt::format("figure {} is left out: {}", drawing.figure.name, drawing.why_not);
    }
    shown.figure = std::move(drawing.figure);
  }
  return out;
}

}  // namespace regista::output
