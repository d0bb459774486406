// SPDX-License-Identifier: MIT
#include "cli/results_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <string_view>
#include <system_error>
#include <vector>

#include "campaign/shell.hpp"
#include "cli/end_of_program.hpp"
#include "cli/results_file.hpp"
#include "output/output.hpp"
#include "report/experiment_figures.hpp"
#include "report/gnuplot.hpp"
#include "report/page_parts.hpp"
#include "report/svg.hpp"
#include "report/tuning_figures.hpp"
#include "study/recording_place.hpp"

namespace regista::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::array<std::string_view, 4> figure_endings{".csv", ".gnuplot", ".svg", ".png"};

void write_figure(const fs::path& folder, const report::Drawing& drawn, const std::string& svg,
                  output::Existing existing) {
  const report::Figure& figure = drawn.figure;
  const auto write = [&](std::string_view end, std::string_view bytes) {
    if (!bytes.empty()) output::write_whole(folder / (figure.name + std::string(end)), bytes, existing);
  };
  write(figure_endings[0], figure.csv);
  write(figure_endings[1], report::gnuplot_script(figure, report::Picture::svg));
  write(figure_endings[2], svg);
  write(figure_endings[3], drawn.png);
}

// Draws what there is to draw; complains once for all that cannot be drawn.
std::vector<report::PageFigure> drawn_figures(const std::vector<report::Figure>& figures, const PageWishes& wishes) {
  std::vector<report::PageFigure> out;
  std::string why_not;
  for (const report::Figure& figure : figures) {
    report::Drawing drawing = report::draw(figure, wishes.png ? report::Png::wanted : report::Png::left_out);
    report::PageFigure& shown = out.emplace_back();
    std::string file;
    try {
      if (!drawing.svg.empty()) {
        shown.svg = report::svg_for_page(drawing.svg, drawing.figure);
        file = report::svg_for_file(drawing.svg, drawing.figure);
      }
    } catch (const report::StrangePicture& error) {
      drawing.why_not = error.what();
    }
    if (wishes.figures) write_figure(*wishes.figures, drawing, file, wishes.existing);
    shown.why_not = drawing.why_not;
    if (why_not.empty() && drawing.no_gnuplot) {
      why_not = "figures are left out: gnuplot is not installed; on Debian: apt install gnuplot-nox";
    } else if (why_not.empty() && !drawing.why_not.empty()) {
      why_not = fmt::format("figure {} is left out: {}", drawing.figure.name, drawing.why_not);
    }
    shown.figure = std::move(drawing.figure);
  }
  if (!why_not.empty()) complain(why_not);
  return out;
}

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directory(folder, error);
  if (!error && fs::is_directory(folder)) return;
  throw BadInput(fmt::format("cannot make the folder {}: {}", folder.string(),
                             error ? error.message() : std::string("there is a file of this name")));
}

// Files of the names that an experiment's figures have, and no others. What cannot be removed stays.
void remove_experiment_figures(const fs::path& folder) {
  std::vector<fs::path> found;
  std::error_code error;
  for (const fs::directory_entry& each : fs::directory_iterator(folder, error)) {
    const fs::path& file = each.path();
    std::error_code unknown;
    if (!fs::is_regular_file(each.symlink_status(unknown))) continue;
    const bool ours = std::ranges::find(figure_endings, file.extension().string()) != figure_endings.end();
    const std::string stem = file.stem().string();
    if (ours && (report::is_experiment_figure(stem) || report::is_tuning_figure(stem))) found.push_back(file);
  }
  for (const fs::path& each : found) fs::remove(each, error);
}

// Whatever else it may be is not opened: a pipe would wait for ever.
bool is_our_page(const fs::path& file) {
  std::error_code error;
  if (!fs::is_regular_file(file, error)) return false;
  std::string beginning(report::page_beginning, '\0');
  std::ifstream in(file, std::ios::binary);
  in.read(beginning.data(), static_cast<std::streamsize>(beginning.size()));
  return report::is_our_page(beginning);
}

}  // namespace

void write_page(const StoredResults& results, const PageWishes& wishes) {
  try {
    // A page is read on any machine, where the program is called as it is.
    const auto report = stored_study(
        results.file.string(), results.store,
        [](const campaign::Job& job) { return campaign::command_line(campaign::match_arguments(job)); }, results.kinds);
    report->begin_page(results.file);
    study::read_back(report->study(), results.store, report->page_metrics(),
                     [&](const study::Round& round, std::uint64_t index, const campaign::Decided* decided) {
                       report->take(round, index, decided);
                     });
    report->end_page();
    if (const std::string incomplete = report->incomplete(); !incomplete.empty()) {
      complain(fmt::format("{} holds {}", results.file.string(), incomplete));
    }
    if (wishes.figures) make_folder(*wishes.figures);
    if (wishes.figures && wishes.only_these) remove_experiment_figures(*wishes.figures);
    report::PageFrame frame;
    frame.figures = drawn_figures(report->figures(), wishes);
    if (!wishes.page) return;
    frame.results = results.file;
    frame.page = *wishes.page;
    frame.program = results.store.meta("program");
    frame.documents = stored_documents(results.store);
    output::write_whole(*wishes.page, report->page(std::move(frame)), wishes.existing);
  } catch (const campaign::StoreError& error) {
    throw BadInput(error.what());
  } catch (const std::system_error& error) {
    throw output::WriteError(error.what());
  }
}

std::optional<fs::path> write_page_beside(const StoredResults& results, bool figures) {
  const fs::path page = study::page_file(results.file);
  try {
    std::error_code error;
    const bool exists = fs::exists(page, error);
    if (exists && !is_our_page(page)) {
      complain(fmt::format("no page is written: {} is none of Regista's pages, and stays", page.string()));
      return std::nullopt;
    }
    PageWishes wishes{page, std::nullopt, false, exists ? output::Existing::replaced : output::Existing::refused};
    if (figures) {
      wishes.figures = study::figure_folder(results.file);
      wishes.png = true;
      wishes.existing = output::Existing::replaced;
      wishes.only_these = true;
    }
    write_page(results, wishes);
    return page;
  } catch (const std::exception& error) {
    complain(fmt::format("no page is written, the results are safe: {}", error.what()));
    return std::nullopt;
  }
}

}  // namespace regista::cli
