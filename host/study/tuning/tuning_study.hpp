// SPDX-License-Identifier: MIT
// A tuning as a study like any other: every batch of matches that its search asks for is a round.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "study/study.hpp"
#include "study/tuning/tuning.hpp"

namespace regista::study {

class TuningStudy final : public Study {
 public:
  // out_of_time: of the search; may be empty. The plan outlives it.
  TuningStudy(const TuningPlan& plan, OutOfTime out_of_time);

  const char* what() const override { return "tuning"; }
  std::string unplayable() const override { return record_.tally.unplayable(); }
  std::uint64_t most_matches() const override { return study::most_matches(plan_); }
  std::uint64_t counted() const override { return counted_; }
  campaign::Metrics metrics() const override { return wanted_metrics(plan_); }
  campaign::Limits limits() const override { return plan_.limits(); }
  const std::string& folder() const override { return plan_.folder; }
  std::string plan() const override { return to_json(plan_); }
  std::vector<std::string> differences(const std::string& before) const override {
    return study::differences(tuning_plan_from_json(before), plan_);
  }
  void run(const PlayRound& play) override;

  const TuningRecord& record() const { return record_; }

 private:
  const TuningPlan& plan_;
  OutOfTime out_of_time_;
  TuningRecord record_;
  std::uint64_t counted_ = 0;
};

}  // namespace regista::study
