// SPDX-License-Identifier: MIT
#include "report/tournament_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>

#include "process/program.hpp"
#include "report/course_record.hpp"
#include "report/page_recordings.hpp"
#include "report/tournament.hpp"
#include "report/tournament_figures.hpp"
#include "report/tournament_outline.hpp"
#include "study/recording_place.hpp"
#include "study/tournament.hpp"
#include "texts/message.hpp"

namespace regista::report {
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

class TournamentReport final : public StudyReport {
 public:
  TournamentReport(study::TournamentPlan plan, CommandOf again)
      : plan_(std::move(plan)), course_(plan_), again_(std::move(again)) {}
  TournamentReport(const TournamentReport&) = delete;
  TournamentReport& operator=(const TournamentReport&) = delete;

  study::Study& study() override { return course_; }
  const study::Study& study() const override { return course_; }

  std::vector<std::string> teams() const override {
    std::vector<std::string> out;
    for (const study::Entrant& each : plan_.teams) out.push_back(each.label);
    return out;
  }
  WhatWasPlayed played() const override { return what_was_played(plan_); }
  Outline outline() const override { return tournament_outline(view()); }
  Outline page_outline(const PageFiles& files) const override;
  std::vector<std::string> notes() const override;
  std::string standing() const override { return fmt::format("{}\n{}", title(view()), standing_text(view())); }
  std::string match(const study::Round& round, std::uint64_t index, const campaign::Decided& decided) const override;

  std::string incomplete() const override {
    if (course_.complete()) return {};
    return fmt::format("{} of {} matches without a gap: the tournament is not at its end", course_.matches(),
                       course_.calendar().matches());
  }

  bool has_a_column_for_each_metric() const override { return true; }
  std::string begin_table(const TableWish& wish) override {
    columns_ = match::MetricColumns(wish.all_metrics ? wish.metrics : csv_metrics(plan_));
    return csv_head(columns_.paths());
  }
  std::string table_lines(const study::Round& /*round*/, std::uint64_t index,
                          const campaign::Decided& decided) override {
    return csv_line(view(), index, decided, columns_);
  }

  campaign::Metrics page_metrics() const override { return campaign::Metrics::wanted; }
  void begin_page(const fs::path& results) override { record_.emplace(plan_, course_, recorded(results)); }
  void take(const study::Round& /*round*/, std::uint64_t /*index*/, const campaign::Decided* decided) override {
    record_->take(decided);
  }
  void end_page() override { record_->end(); }
  std::vector<Figure> figures() const override { return tournament_figures(view(), *record_); }

 private:
  campaign::Job job(std::uint64_t index) const { return study::job(plan_, course_.calendar().at(index)); }
  TournamentView view() const {
    return {plan_, course_, [this](std::uint64_t index) { return again_(job(index)); }};
  }

  study::TournamentPlan plan_;
  study::Tournament course_;
  CommandOf again_;
  match::MetricColumns columns_;  // of the table that was begun
  std::optional<CourseRecord> record_;
};

std::vector<std::string> TournamentReport::notes() const {
  std::vector<std::string> out;
  for (const study::Pairing& pairing : course_.calendar().pairings()) {
    if (!study::equal_teams(plan_, pairing)) continue;
    out.push_back(fmt::format("A/A: {} and {} are equal, so every pair is a draw by construction",
                              plan_.teams[pairing.first].label, plan_.teams[pairing.second].label));
  }
  return out;
}

std::string TournamentReport::match(const study::Round& /*round*/, std::uint64_t index,
                                    const campaign::Decided& decided) const {
  const study::Fixture fixture = course_.calendar().at(index);
  const std::string scene = scene_of(view(), fixture);
  std::string line =
      fmt::format("seed {}{}{}: {} {}:{} {}", fixture.seed, scene.empty() ? "" : ", ", scene,
                  plan_.teams[fixture.home].label, decided.score[0], decided.score[1], plan_.teams[fixture.away].label);
  if (decided.set_aside()) line += ", could not be played: " + texts::one_line(decided.why_set_aside);
  if (decided.failure) {
    const std::size_t loser = decided.failure->side == 0 ? fixture.home : fixture.away;
    line += ", " + forfeit_text(plan_.teams[loser].label, *decided.failure);
  }
  return line;
}

Outline TournamentReport::page_outline(const PageFiles& files) const {
  const auto link = [&files](std::uint64_t match) {
    const fs::path file = study::recording_file(files.results, static_cast<std::int64_t>(match) + 1);
    const std::string from_page =
        fs::absolute(file).lexically_relative(fs::absolute(files.page).parent_path()).generic_string();
    const std::string shown = study::beside(files.results, fmt::format("-{}.html", match + 1)).filename().string();
    const auto word = [](const std::string& path) { return path.starts_with('-') ? "./" + path : path; };
    return RecordingLink{from_page,
                         process::command_line(std::vector<std::string>{"view", word(from_page), "-o", word(shown)})};
  };
  const TournamentView view = this->view();
  const TournamentPage page{*record_, files.documents, page_recordings(view, *record_, files.results), link};
  return tournament_outline(view, &page);
}

}  // namespace

std::unique_ptr<StudyReport> tournament_report(study::TournamentPlan plan, CommandOf again) {
  return std::make_unique<TournamentReport>(std::move(plan), std::move(again));
}

}  // namespace regista::report
