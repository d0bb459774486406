// SPDX-License-Identifier: MIT
// What is said of a count of goals.
#pragma once

#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

#include "goal_count.hpp"
#include "report/html.hpp"
#include "report/page_parts.hpp"
#include "report/study_report.hpp"
#include "report/tournament.hpp"
#include "texts/json.hpp"

namespace regista::report {

class GoalCountReport final : public StudyReport {
 public:
  explicit GoalCountReport(study::TournamentPlan schedule) : study_(std::move(schedule)) {}

  study::Study& study() override { return study_; }
  const study::Study& study() const override { return study_; }

  WhatWasPlayed played() const override { return what_was_played(study_.schedule()); }
  std::string title() const override { return "goals of a match"; }
  std::string headline() const override { return fmt::format("{} matches were counted.", study_.counted()); }
  std::string standing() const override { return text(); }
  std::string match(const study::Round& round, std::uint64_t index, const campaign::Decided& decided) const override {
    return fmt::format("seed {}: {} goals", round.job(index).seed, decided.score[0] + decided.score[1]);
  }
  std::string text() const override {
    std::string out;
    for (const auto& [goals, matches] : study_.matches()) out += fmt::format("{} goals: {} matches\n", goals, matches);
    return out;
  }
  std::string json() const override {
    nlohmann::ordered_json out = nlohmann::ordered_json::object();
    for (const auto& [goals, matches] : study_.matches()) out[std::to_string(goals)] = matches;
    return out.dump() + '\n';
  }
  std::string incomplete() const override {
    return study_.over() ? "" : fmt::format("{} matches: the count is not at its end", study_.counted());
  }

  std::string begin_table(const TableWish&) override { return "row,goals\n"; }
  std::string table_lines(const study::Round&, std::uint64_t index, const campaign::Decided& decided) override {
    return fmt::format("{},{}\n", index + 1, decided.score[0] + decided.score[1]);
  }

  void take(const study::Round&, std::uint64_t, const campaign::Decided*) override { ++noted_; }
  std::vector<Figure> figures() const override { return {}; }
  std::string page(PageFrame frame) const override {
    Html out = page_begin("Count of goals");
    out << text_of_page(frame.program) << page_end();
    return out.str();
  }

 private:
  Html text_of_page(const std::string& program) const {
    Html out = "<p>"_html;
    return out << report::text(fmt::format("{} of {} matches, written by {}", noted_, study_.most_matches(), program))
               << "</p>\n"_html;
  }

  study::GoalCount study_;
  std::uint64_t noted_ = 0;
};

}  // namespace regista::report
