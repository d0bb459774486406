// SPDX-License-Identifier: MIT
#include "study/tuning/played_score.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace regista::study {

PlayedScore played_score(const TuningPlan& plan, const PairBatch& batch, std::size_t candidate, double worst) {
  PlayedScore out{mean_of(batch.scores(candidate), plan.confidence()), batch.failed(candidate), 0.0};
  if (out.failed) {
    const std::optional<ScoreBounds> bounds = score_bounds(plan);
    out.counted = bounds ? bounds->low : worst;
  } else if (out.score.pairs == 0) {
    // An opponent's crash, or a metric that these matches do not have: known is only that it is not known to be good.
    out.counted = std::isfinite(worst) ? worst : 0.0;
  } else {
    out.counted = out.score.mean;
  }
  return out;
}

double worst_of(const PairBatch& batch, std::size_t candidates, double worst) {
  for (std::size_t i = 0; i < candidates; ++i) {
    for (const double each : batch.scores(i)) {
      if (!std::isnan(each)) worst = std::min(worst, each);
    }
  }
  return worst;
}

}  // namespace regista::study
