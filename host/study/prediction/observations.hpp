// SPDX-License-Identifier: MIT
// What of a recording a predictor is shown: everything, or so little as would come in packets.
#pragma once

#include <vector>

#include "config/predictor_study.hpp"
#include "study/prediction/recording.hpp"

namespace regista::study {

// For every sample of the stretch, whether it is shown. Of each object at most one in `every` seconds, of which each is
// lost with probability `drop`, by a draw of its own from (seed, stretch, object, number of the sample): Philox4x32 of
// Salmon et al., "Parallel Random Numbers: As Easy as 1, 2, 3", SC 2011.
std::vector<bool> shown(const Stretch& stretch, const config::PredictorStudy::Observations& observations);

}  // namespace regista::study
