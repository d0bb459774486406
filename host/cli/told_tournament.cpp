// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <memory>
#include <utility>

#include "campaign/shell.hpp"
#include "cli/stored_course.hpp"
#include "cli/told_study.hpp"
#include "report/course_record.hpp"
#include "report/reproduction.hpp"
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

// The course of a tournament, with all that a page wants to know of it.
class ToldTournament {
 public:
  ToldTournament(const StoredResults& results, const study::TournamentPlan& plan)
      : results_(results),
        plan_(plan),
        course_(plan),
        recorded_(recorded(results.file)),
        record_(plan, course_, recorded_) {
    const StoredCourse stored(results.store, plan);
    stored.play(course_, campaign::Metrics::wanted,
                [this](std::uint64_t, const campaign::Decided* decided) { record_.take(decided); });
    record_.end();
  }
  ToldTournament(const ToldTournament&) = delete;
  ToldTournament& operator=(const ToldTournament&) = delete;

  const study::Tournament& course() const { return course_; }
  std::vector<report::Figure> figures() const { return report::tournament_figures(view(), record_); }

  std::string page(const fs::path& page, std::vector<report::PageFigure> figures) const {
    const auto link = [&](std::uint64_t match) {
      const fs::path file = study::recording_file(results_.file, static_cast<std::int64_t>(match) + 1);
      const std::string from_page =
          fs::absolute(file).lexically_relative(fs::absolute(page).parent_path()).generic_string();
      const std::string shown = study::beside(results_.file, fmt::format("-{}.html", match + 1)).filename().string();
      const auto word = [](const std::string& path) { return path.starts_with('-') ? "./" + path : path; };
      return report::RecordingLink{
          from_page, campaign::command_line(std::vector<std::string>{"view", word(from_page), "-o", word(shown)})};
    };
    return report::tournament_page({view(), record_, std::move(figures), stored_documents(results_.store),
                                    results_.store.meta("program"),
                                    campaign::command_line(report::tournament_arguments(plan_)),
                                    report::page_recordings(view(), record_, results_.file), link});
  }

 private:
  report::TournamentView view() const {
    return {plan_, course_, [this](std::uint64_t index) {
              return campaign::command_line(campaign::match_arguments(study::job(plan_, course_.calendar().at(index))));
            }};
  }

  const StoredResults& results_;
  const study::TournamentPlan& plan_;
  study::Tournament course_;
  std::vector<std::uint64_t> recorded_;
  report::CourseRecord record_;
};

}  // namespace

ToldStudy told_tournament(const StoredResults& results) {
  const auto told = std::make_shared<const ToldTournament>(results, std::get<study::TournamentPlan>(results.plan));
  ToldStudy out;
  const study::Tournament& course = told->course();
  if (!course.complete())
    out.incomplete = not_at_its_end(results, "tournament", course.matches(), course.calendar().matches());
  out.figures = told->figures();
  out.page = [told](const fs::path& page, std::vector<report::PageFigure> figures) {
    return told->page(page, std::move(figures));
  };
  return out;
}

}  // namespace regista::cli
