// SPDX-License-Identifier: MIT
#include "study/tuning/tuning.hpp"

#include "study/tuning/candidate_matches.hpp"
#include "study/tuning/match_tally.hpp"
#include "study/tuning/selection.hpp"
#include "study/tuning/slice_matches.hpp"

namespace regista::study {

void tune(const TuningPlan& plan, const TuningHooks& hooks, TuningRecord& record) {
  const TunedDocument document(plan);
  const MatchSource source{plan, document, hooks.play, record.tally};

  const SearchFindings found = search_over_pairs(source, hooks.out_of_time, record.trace);
  record.ended = found.ended;

  record.stage = TuningStage::selection;
  record.finalists = select_finalists(source, found);
  record.candidates = candidates_among(plan, record.finalists);

  record.stage = TuningStage::verification;
  verify_candidates(source, deviation_of(record.finalists, found.scores), record);

  record.stage = TuningStage::slices;
  record.slices = slices_around(source, record.finalists[record.tuned().value_or(0)].values);

  record.stage.reset();
}

}  // namespace regista::study
