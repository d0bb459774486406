// SPDX-License-Identifier: MIT
// A comparison of search algorithms as a study: each algorithm searches, several times with other seeds, and what each
// run recommends first is judged, with all others and the base team, on the same pairs that no search has seen.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "study/paired_estimates.hpp"
#include "study/study.hpp"
#include "study/tuning/match_tally.hpp"
#include "study/tuning/search_comparison_plan.hpp"
#include "study/tuning/tuning_plan.hpp"

namespace regista::study {

// A search, and the point that it recommended.
struct ComparedRun {
  Algorithm algorithm = Algorithm::sbplx;
  std::uint64_t repeat = 0;
  std::uint64_t evaluations = 0, matches = 0;
  std::string ended;
  ParameterValues values;
  std::optional<double> seen;  // its score in the search; larger is better
  MeanEstimate judged;         // less the base team's, pair by pair, on seeds no search has seen
};

struct SearchComparisonRecord {
  explicit SearchComparisonRecord(const SearchComparisonPlan& plan) : tally(plan.tuning) {}

  // Under way: search, then verification, in which the runs are judged; nothing: all is done.
  std::optional<TuningStage> stage = TuningStage::search;
  std::vector<ComparedRun> runs;  // that have come to their end; repeat after repeat, algorithms in the plan's order
  MatchTally tally;
};

// Fills the record as far as it comes: a function of the plan and of the results of matches. Throws TuningError
// (base_team_check.hpp), and what `play` throws.
void compare_searches(const SearchComparisonPlan& plan, const PlayMatches& play, SearchComparisonRecord& record);

class SearchComparison final : public Study {
 public:
  // The plan outlives it.
  explicit SearchComparison(const SearchComparisonPlan& plan) : plan_(plan), record_(plan) {}

  const char* what() const override { return "comparison of search algorithms"; }
  std::string unplayable() const override { return record_.tally.unplayable(); }
  std::uint64_t most_matches() const override { return study::most_matches(plan_); }
  std::uint64_t counted() const override { return counted_; }
  campaign::Metrics metrics() const override { return wanted_metrics(plan_.tuning); }
  const campaign::Limits& limits() const override { return plan_.tuning.limits; }
  const std::string& folder() const override { return plan_.tuning.folder; }
  std::string plan() const override { return to_json(plan_); }
  std::vector<std::string> differences(const std::string& before) const override {
    return study::differences(search_comparison_plan_from_json(before), plan_);
  }
  void run(const PlayRound& play) override;

  const SearchComparisonRecord& record() const { return record_; }

 private:
  const SearchComparisonPlan& plan_;
  SearchComparisonRecord record_;
  std::uint64_t counted_ = 0;
};

}  // namespace regista::study
