// SPDX-License-Identifier: MIT
// What is said of a count of goals.
#pragma once

#include <fmt/format.h>

#include <string>
#include <utility>
#include <vector>

#include "goal_count.hpp"
#include "report/study_report.hpp"
#include "report/tournament_report.hpp"
#include "texts/json.hpp"

namespace regista::report {

class GoalCountReport final : public StudyReport {
 public:
  explicit GoalCountReport(study::GoalCountPlan plan) : plan_(std::move(plan)), study_(plan_) {}

  study::Study& study() override { return study_; }
  const study::Study& study() const override { return study_; }

  WhatWasPlayed played() const override {
    WhatWasPlayed out = what_was_played(plan_.schedule);
    out.document = config::document_text(plan_.asked);
    return out;
  }
  Outline outline() const override {
    Outline out;
    out.kind = "Count of goals";
    out.title = "goals of a match";
    out.headline = fmt::format("{} matches were counted.", study_.counted());
    out.played = played();
    Table goals{{{"Goals"}, {"Matches"}}};
    nlohmann::ordered_json counts = nlohmann::ordered_json::object();
    for (const auto& [number, matches] : study_.matches()) {
      goals.row({number, matches});
      counts[std::to_string(number)] = matches;
    }
    out.data = [counts] { return nlohmann::ordered_json{{"goals", counts}}; };
    Section section("goals", "Matches by their goals");
    section.table(std::move(goals));
    out.add(std::move(section));
    return out;
  }
  std::string standing() const override { return outline_text(outline()); }
  std::string match(const study::Round& round, std::uint64_t index,
                    const campaign::MatchResult& decided) const override {
    return fmt::format("seed {}: {} goals", round.job(index).seed, decided.score[0] + decided.score[1]);
  }
  std::string incomplete() const override {
    return study_.over() ? "" : fmt::format("{} matches: the count is not at its end", study_.counted());
  }

  std::string begin_table(const TableOptions&) override { return "row,goals\n"; }
  std::string table_lines(const study::Round&, std::uint64_t index, const campaign::MatchResult& decided) override {
    return fmt::format("{},{}\n", index + 1, decided.score[0] + decided.score[1]);
  }

  void take(const study::Round&, std::uint64_t, const campaign::MatchResult*) override {}
  std::vector<Figure> figures() const override { return {}; }

 private:
  study::GoalCountPlan plan_;
  study::GoalCount study_;
};

}  // namespace regista::report
