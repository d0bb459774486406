// SPDX-License-Identifier: MIT
#include "cli/results_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <memory>
#include <stdexcept>
#include <system_error>
#include <vector>

#include "cli/end_of_program.hpp"
#include "cli/output.hpp"
#include "cli/shell.hpp"
#include "cli/stored_course.hpp"
#include "cli/tournament_files.hpp"
#include "report/course_record.hpp"
#include "report/gnuplot.hpp"
#include "report/reproduction.hpp"
#include "report/svg.hpp"
#include "report/tournament_figures.hpp"
#include "report/tournament_page.hpp"
#include "study/recording_place.hpp"

namespace regista::cli {
namespace {

namespace fs = std::filesystem;

// Places in the schedule that recordings are called by, ascending; what these hold is another matter.
std::vector<std::uint64_t> recorded(const fs::path& results) {
  std::vector<std::uint64_t> out;
  std::error_code error;
  for (fs::directory_iterator each(study::recording_folder(results), error), end; !error && each != end;
       each.increment(error)) {
    if (each->path().extension() != ".mcap") continue;
    const std::string stem = each->path().stem().string();
    std::uint64_t row = 0;
    const auto [rest, wrong] = std::from_chars(stem.data(), stem.data() + stem.size(), row);
    if (wrong == std::errc() && stem == std::to_string(row) && row > 0) out.push_back(row - 1);
  }
  std::ranges::sort(out);
  return out;
}

// By the program's name and not by the path that was typed this time: the same results make the same page.
std::string command_line(std::vector<std::string> words) {
  words.insert(words.begin(), "regista");
  return shell_line(words);
}

// The course of a tournament, with all that a page wants to know of it.
class Told {
 public:
  explicit Told(const StoredResults& results)
      : results_(results),
        course_(results.plan),
        recorded_(recorded(results.file)),
        record_(results.plan, course_, recorded_) {
    const StoredCourse stored(results.store, results.plan);
    stored.play(course_, campaign::Metrics::wanted,
                [this](std::uint64_t, const campaign::Decided* decided) { record_.take(decided); });
  }
  Told(const Told&) = delete;
  Told& operator=(const Told&) = delete;

  const study::Tournament& course() const { return course_; }
  std::vector<report::Figure> figures() const { return report::tournament_figures(view(), record_); }

  std::string page(const fs::path& page, std::vector<report::PageFigure> figures) const {
    const auto link = [&](std::uint64_t match) {
      const fs::path file = study::recording_file(results_.file, static_cast<std::int64_t>(match) + 1);
      const std::string from_page =
          fs::absolute(file).lexically_relative(fs::absolute(page).parent_path()).generic_string();
      const std::string shown = study::beside(results_.file, fmt::format("-{}.html", match + 1)).filename().string();
      const auto word = [](const std::string& path) { return path.starts_with('-') ? "./" + path : path; };
      return report::RecordingLink{from_page, command_line({"view", word(from_page), "-o", word(shown)})};
    };
    return report::tournament_page({view(), record_, std::move(figures), stored_documents(results_.store),
                                    results_.store.meta("program"),
                                    command_line(report::tournament_arguments(results_.plan)),
                                    report::page_recordings(view(), record_, recorded_.size(), results_.file), link});
  }

 private:
  report::TournamentView view() const {
    return {results_.plan, course_, [this](std::uint64_t index) {
              return command_line(campaign::match_arguments(study::job(results_.plan, course_.calendar().at(index))));
            }};
  }

  const StoredResults& results_;
  study::Tournament course_;
  std::vector<std::uint64_t> recorded_;
  report::CourseRecord record_;
};

void write_figure(const fs::path& folder, const report::Drawing& drawn, const std::string& svg, Existing existing) {
  const report::Figure& figure = drawn.figure;
  const auto write = [&](const char* end, std::string_view bytes) {
    if (!bytes.empty()) write_whole(folder / (figure.name + end), bytes, existing);
  };
  write(".csv", figure.csv);
  write(".gnuplot", report::gnuplot_script(figure, report::Picture::svg));
  write(".svg", svg);
  write(".png", drawn.png);
}

// Draws what there is to draw; complains once for all that cannot be drawn.
std::vector<report::PageFigure> drawn_figures(const Told& told, const PageWishes& wishes) {
  std::vector<report::PageFigure> out;
  std::string why_not;
  for (report::Figure& figure : told.figures()) {
    report::Drawing drawing = report::draw(std::move(figure), wishes.png ? report::Png::wanted : report::Png::left_out);
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

void refuse_results_as_page(const fs::path& results, const fs::path& page) {
  std::error_code error;
  if (fs::equivalent(results, page, error)) {
    throw BadInput(fmt::format("-o {}: these are the results themselves", page.string()));
  }
}

void make_folder(const fs::path& folder) {
  std::error_code error;
  fs::create_directory(folder, error);
  if (!error && fs::is_directory(folder)) return;
  throw BadInput(fmt::format("cannot make the folder {}: {}", folder.string(),
                             error ? error.message() : std::string("there is a file of this name")));
}

// Before work begins, for what is known by then.
void refuse_existing(const fs::path& file, Existing existing) {
  std::error_code error;
  if (existing == Existing::refused && fs::exists(fs::status(file, error))) {
    throw BadInput(fmt::format("{} exists already; --force replaces it", file.string()));
  }
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
  if (wishes.page) {
    refuse_results_as_page(results.file, *wishes.page);
    refuse_existing(*wishes.page, wishes.existing);
  }
  try {
    const Told told(results);
    if (!told.course().complete()) {
      complain(fmt::format("{} holds {} of {} matches without a gap: the tournament is not at its end",
                           results.file.string(), told.course().matches(), told.course().calendar().matches()));
    }
    if (wishes.figures) make_folder(*wishes.figures);
    std::vector<report::PageFigure> figures = drawn_figures(told, wishes);
    if (wishes.page) write_whole(*wishes.page, told.page(*wishes.page, std::move(figures)), wishes.existing);
  } catch (const campaign::StoreError& error) {
    throw BadInput(error.what());
  } catch (const std::invalid_argument& error) {
    throw BadInput(damaged_metrics(results.file.string(), error));
  } catch (const std::system_error& error) {
    throw WriteError(error.what());
  }
}

std::optional<fs::path> write_page_beside(const StoredResults& results) {
  const fs::path page = study::page_file(results.file);
  try {
    std::error_code error;
    const bool exists = fs::exists(page, error);
    if (exists && !is_our_page(page)) {
      complain(fmt::format("no page is written: {} is none of Regista's pages, and stays", page.string()));
      return std::nullopt;
    }
    write_page(results, {page, std::nullopt, false, exists ? Existing::replaced : Existing::refused});
    return page;
  } catch (const std::exception& error) {
    complain(fmt::format("no page is written, the results are safe: {}", error.what()));
    return std::nullopt;
  }
}

}  // namespace regista::cli
