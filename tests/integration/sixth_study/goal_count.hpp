// SPDX-License-Identifier: MIT
// A study that the program does not have: how many goals fall in a match of two teams. It ends after so many matches,
// or with the first that ends with no goal at all.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "config/parse.hpp"
#include "config/values.hpp"
#include "goal_count_document.hpp"
#include "results/study_kind.hpp"
#include "study/study.hpp"
#include "study/tournament_calendar.hpp"
#include "study/tournament_plan.hpp"
#include "texts/json.hpp"

namespace regista::study {

struct GoalCountPlan {
  config::GoalCount asked;
  TournamentPlan schedule;  // whose matches are played
};

inline constexpr auto goal_count_study = "goal_count";

inline std::string to_json(const GoalCountPlan& plan) {
  return nlohmann::ordered_json{{"study", goal_count_study},
                                {"document", config::document_text(plan.asked)},
                                {"schedule", to_json(plan.schedule)}}
      .dump();
}

// Throws std::invalid_argument.
inline GoalCountPlan goal_count_plan(const std::string& text) {
  if (study_of(text) != goal_count_study) throw std::invalid_argument("these are results of another study");
  const auto json = nlohmann::json::parse(text);
  config::Mistakes first(config::Mistakes::After::stop, config::Mistakes::Files::as_they_stand);
  return {config::read_document<config::GoalCount>(
              config::parse_text(json.at("document").get<std::string>(), "its document"), first),
          tournament_plan_from_json(json.at("schedule").get<std::string>())};
}

inline results::PlannedStudy planned_goal_count(const config::Node& document, const std::vector<std::string>& plugins,
                                                const plugin::Catalogue& catalogue, config::Mistakes& mistakes) {
  GoalCountPlan plan{config::read_document<config::GoalCount>(document), {}};
  config::Tournament schedule;
  schedule.name = plan.asked.name;
  schedule.teams = {{plan.asked.home, ""}, {plan.asked.away, ""}};
  schedule.pairs = plan.asked.pairs;
  schedule.settings = plan.asked.settings;
  const config::Node document_of_schedule = config::parse_text(config::document_text(schedule), "goal_count");
  plan.schedule = planned_tournament(document_of_schedule, plugins, catalogue, mistakes).plan;
  if (!mistakes.none()) return {};
  return {to_json(plan), plan.asked.name};
}

class GoalCount final : public Study {
 public:
  explicit GoalCount(const GoalCountPlan& plan) : plan_(plan), calendar_(plan_.schedule) {}

  const char* what() const override { return "count of goals"; }
  std::uint64_t most_matches() const override { return calendar_.matches(); }
  std::uint64_t counted() const override { return counted_; }
  campaign::Metrics metrics() const override { return campaign::Metrics::left_out; }
  campaign::Limits limits() const override { return plan_.schedule.limits(); }
  const std::string& folder() const override { return plan_.schedule.folder; }
  std::string plan() const override { return to_json(plan_); }
  std::vector<std::string> differences(const std::string& before) const override {
    return study::differences(goal_count_plan(before).schedule, plan_.schedule);
  }

  void run(const PlayRound& play) override {
    Round round;
    round.matches = calendar_.matches();
    round.fixtures = fixtures(plan_.schedule);
    round.at = [this](std::uint64_t index) -> std::optional<Round::Place> {
      const Fixture fixture = calendar_.at(index);
      return Round::Place{fixture.number, fixture.seed};
    };
    round.job = [this](std::uint64_t index) { return job(plan_.schedule, calendar_.at(index)); };
    round.take = [this](std::uint64_t, const campaign::MatchResult* decided) {
      ++counted_;
      const int goals = decided->score[0] + decided->score[1];
      ++matches_[goals];
      over_ = goals == 0 || counted_ == calendar_.matches();
      return !over_;
    };
    play(round);
  }

  const std::map<int, std::uint64_t>& matches() const { return matches_; }  // by goals
  bool over() const { return over_; }

 private:
  GoalCountPlan plan_;
  Calendar calendar_;
  std::map<int, std::uint64_t> matches_;
  std::uint64_t counted_ = 0;
  bool over_ = false;
};

}  // namespace regista::study
