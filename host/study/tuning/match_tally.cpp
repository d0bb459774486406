// SPDX-License-Identifier: MIT
#include "study/tuning/match_tally.hpp"

namespace regista::study {

void play_batch(const MatchSource& source, PairBatch& batch, const std::function<bool()>& after_pair) {
  MatchTally& tally = source.tally;
  batch.list().first_row = tally.matches;
  tally.matches += batch.list().matches.size();
  source.play(batch.list(), [&](std::uint64_t, const campaign::Decided& decided) {
    const std::uint64_t unplayed = batch.unplayed_pairs();
    const bool pair = batch.take(decided, tally.forfeits, tally.remarks);
    tally.unplayed_pairs += batch.unplayed_pairs() - unplayed;
    return !pair || !after_pair || after_pair();
  });
}

}  // namespace regista::study
