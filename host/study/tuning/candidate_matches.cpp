// SPDX-License-Identifier: MIT
#include "study/tuning/candidate_matches.hpp"

#include <cstddef>
#include <cstdint>
#include <vector>

#include "study/tuning/drawn_seed.hpp"

namespace regista::study {

void verify_candidates(const MatchSource& source, double deviation, TuningRecord& record) {
  const TuningPlan& plan = source.plan;
  std::vector<ParameterValues> played;
  for (const std::size_t each : record.candidates) played.push_back(record.finalists[each].values);
  const std::size_t candidates = played.size();
  record.verification =
      Verification(candidates, plan.confidence(), deviation, widest_difference(plan), difference_bound(plan));
  record.candidate_failed.assign(candidates, false);
  record.candidate_packets.assign(candidates, {});
  const std::uint64_t pairs = verification_pairs_of(plan, candidates);
  if (pairs == 0) return;
  const std::uint64_t first_seed = drawn_seed(plan, source.document, played);
  if (!plan.head_to_head()) played.push_back(start_values(plan));
  PairBatch batch(plan, source.document, played, {TuningStage::verification, first_seed, 0, pairs},
                  plan.head_to_head());
  play_batch(source, batch, [&] {
    std::vector<double> scores;
    std::vector<bool> unplayed;
    for (std::size_t i = 0; i < candidates; ++i) {
      scores.push_back(batch.scores(i).back());
      unplayed.push_back(batch.unplayed(i).back() || (!plan.head_to_head() && batch.unplayed(candidates).back()));
      record.candidate_failed[i] = batch.failed(i);
      record.candidate_packets[i] = batch.packets(i);
    }
    record.verification.add(plan.head_to_head() ? 0.0 : batch.scores(candidates).back(), scores, unplayed);
    return !record.verification.decided();
  });
}

}  // namespace regista::study
