// SPDX-License-Identifier: MIT
#include "results/results_page.hpp"

#include <fmt/format.h>

#include <fstream>
#include <string_view>
#include <system_error>

#include "command/end_of_program.hpp"
#include "output/output.hpp"
#include "process/program.hpp"
#include "report/outline.hpp"
#include "results/results_file.hpp"
#include "study/recording_place.hpp"

namespace regista::results {
namespace {

namespace fs = std::filesystem;

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
        [](const campaign::Job& job) { return process::command_line(campaign::match_arguments(job)); }, results.kinds);
    report->begin_page(results.file);
    study::read_back(report->study(), results.store, report->page_metrics(),
                     [&](const study::Round& round, std::uint64_t index, const campaign::Decided* decided) {
                       report->take(round, index, decided);
                     });
    report->end_page();
    if (const std::string incomplete = report->incomplete(); !incomplete.empty()) {
      command::complain(fmt::format("{} holds {}", results.file.string(), incomplete));
    }
    const std::vector<report::Figure> figures = report->figures();
    output::write_figures(figures, wishes.figures);
    if (!wishes.page) return;
    const report::Outline outline = report->page_outline({results.file, *wishes.page, stored_documents(results.store)});
    output::write_whole(*wishes.page, outline_page(outline, results.file.filename().string(), figures),
                        wishes.figures.existing);
  } catch (const campaign::StoreError& error) {
    throw command::BadInput(error.what());
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
      command::complain(fmt::format("no page is written: {} is none of Regista's pages, and stays", page.string()));
      return std::nullopt;
    }
    PageWishes wishes;
    wishes.page = page;
    wishes.figures.existing = exists || figures ? output::Existing::replaced : output::Existing::refused;
    if (figures) {
      wishes.figures.folder = study::figure_folder(results.file);
      wishes.figures.only_these = true;
    }
    write_page(results, wishes);
    return page;
  } catch (const std::exception& error) {
    command::complain(fmt::format("no page is written, the results are safe: {}", error.what()));
    return std::nullopt;
  }
}

}  // namespace regista::results
