// SPDX-License-Identifier: MIT
// A tuning as a study like any other: every batch of matches that its search asks for is a round.
#pragma once

#include <cstdint>
#include <functional>

#include "study/study.hpp"
#include "study/tuning/tuning.hpp"

namespace regista::study {

class TuningStudy final : public Study {
 public:
  // out_of_time: see TuningHooks; may be empty. The plan outlives it.
  TuningStudy(const TuningPlan& plan, std::function<bool(std::uint64_t evaluations)> out_of_time);

  const char* what() const override { return "tuning"; }
  std::uint64_t most_matches() const override;
  std::uint64_t counted() const override { return counted_; }
  campaign::Metrics metrics() const override;
  const campaign::Limits& limits() const override { return plan_.limits; }
  const std::string& folder() const override { return plan_.folder; }
  std::string plan() const override { return to_json(plan_); }
  std::vector<std::string> differences(const std::string& before) const override {
    return study::differences(tuning_plan_from_json(before), plan_);
  }
  void run(const PlayRound& play) override;

  const TuningRecord& record() const { return record_; }

 private:
  const TuningPlan& plan_;
  std::function<bool(std::uint64_t evaluations)> out_of_time_;
  TuningRecord record_;
  std::uint64_t counted_ = 0;
};

}  // namespace regista::study
