// SPDX-License-Identifier: MIT
#include "study/tuning/search_comparison.hpp"

#include <utility>

#include "study/tuning/drawn_seed.hpp"
#include "study/tuning/match_rounds.hpp"
#include "study/tuning/pair_search.hpp"

namespace regista::study {
namespace {

ComparedRun run_of(const MatchSource& source, Algorithm algorithm, std::uint64_t repeat) {
  const std::uint64_t before = source.tally.matches;
  std::vector<SearchStep> steps;
  SearchFindings found = search_over_pairs(source, algorithm, repeat, {}, steps);
  ComparedRun out;
  out.algorithm = algorithm;
  out.repeat = repeat;
  out.evaluations = steps.size();
  out.matches = source.tally.matches - before;
  out.ended = std::move(found.ended);
  out.values = std::move(found.recommended.front());
  if (const auto seen = seen_in_search(found.scores, out.values, source.plan.confidence)) out.seen = seen->score.mean;
  return out;
}

// All of them and the base team on the same pairs.
void judge(const MatchSource& source, std::vector<ComparedRun>& runs) {
  const TuningPlan& plan = source.plan;
  std::vector<ParameterValues> points;
  points.reserve(runs.size() + 1);
  for (const ComparedRun& each : runs) points.push_back(each.values);
  const std::uint64_t first_seed = drawn_seed(plan, source.document, points);
  points.push_back(start_values(plan));
  PairBatch batch(plan, source.document, points,
                  {TuningStage::verification, 0, first_seed, 0, plan.verification_pairs});
  play_batch(source, batch);
  const std::vector<double>& base = batch.scores(runs.size());
  for (std::size_t i = 0; i < runs.size(); ++i) {
    runs[i].judged = difference_of(batch.scores(i), base, plan.confidence);
  }
}

}  // namespace

void compare_searches(const SearchComparisonPlan& plan, const PlayMatches& play, SearchComparisonRecord& record) {
  const TunedDocument document(plan.tuning);
  const MatchSource source{plan.tuning, document, play, record.tally};
  for (std::uint64_t repeat = 0; repeat < plan.repeats; ++repeat) {
    for (const Algorithm each : plan.algorithms) record.runs.push_back(run_of(source, each, repeat));
  }
  record.stage = TuningStage::verification;
  judge(source, record.runs);
  record.stage.reset();
}

void SearchComparison::run(const PlayRound& play) { compare_searches(plan_, in_rounds(play, counted_), record_); }

}  // namespace regista::study
