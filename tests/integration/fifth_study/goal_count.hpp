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

#include "study/plan_names.hpp"
#include "study/study.hpp"
#include "study/tournament_plan.hpp"
#include "texts/json.hpp"

namespace regista::study {

class GoalCount final : public Study {
 public:
  static constexpr auto name = "goal_count";

  // schedule: of two teams; whose matches are played.
  explicit GoalCount(TournamentPlan schedule) : schedule_(std::move(schedule)), calendar_(schedule_) {}
  // Throws std::invalid_argument.
  static TournamentPlan schedule_of(const std::string& plan) {
    if (study_of(plan) != name) throw std::invalid_argument("these are results of another study");
    return tournament_plan_from_json(nlohmann::json::parse(plan).at("schedule").get<std::string>());
  }

  const char* what() const override { return "count of goals"; }
  std::uint64_t most_matches() const override { return calendar_.matches(); }
  std::uint64_t counted() const override { return counted_; }
  campaign::Metrics metrics() const override { return campaign::Metrics::left_out; }
  campaign::Limits limits() const override { return schedule_.limits(); }
  const std::string& folder() const override { return schedule_.folder; }
  std::string plan() const override {
    return nlohmann::ordered_json{{"study", name}, {"schedule", to_json(schedule_)}}.dump();
  }
  std::vector<std::string> differences(const std::string& before) const override {
    return study::differences(schedule_of(before), schedule_);
  }

  void run(const PlayRound& play) override {
    Round round;
    round.matches = calendar_.matches();
    round.fixtures = fixtures(schedule_);
    round.at = [this](std::uint64_t index) -> std::optional<Round::Place> {
      const Fixture fixture = calendar_.at(index);
      return Round::Place{fixture.number, fixture.seed};
    };
    round.job = [this](std::uint64_t index) { return job(schedule_, calendar_.at(index)); };
    round.take = [this](std::uint64_t, const campaign::Decided* decided) {
      ++counted_;
      const int goals = decided->score[0] + decided->score[1];
      ++matches_[goals];
      over_ = goals == 0 || counted_ == calendar_.matches();
      return !over_;
    };
    play(round);
  }

  const TournamentPlan& schedule() const { return schedule_; }
  const std::map<int, std::uint64_t>& matches() const { return matches_; }  // by goals
  bool over() const { return over_; }

 private:
  TournamentPlan schedule_;
  Calendar calendar_;
  std::map<int, std::uint64_t> matches_;
  std::uint64_t counted_ = 0;
  bool over_ = false;
};

}  // namespace regista::study
