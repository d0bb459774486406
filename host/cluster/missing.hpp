// SPDX-License-Identifier: MIT
// What a study still needs, by the matches that a file of results holds.
#pragma once

#include <cstdint>
#include <vector>

#include "campaign/store.hpp"
#include "cluster/batch.hpp"
#include "study/study.hpp"

namespace regista::cluster {

struct Missing {
  std::uint64_t first_row = 0;       // of the round that goes on: see study::Round
  Slices places;                     // of that round: which have not been played, ascending
  std::vector<std::uint64_t> twice;  // of these places: those that are played twice
  std::uint64_t round = 0;           // matches of that round
  bool may_end_early = false;        // that round: see study::Round
  std::uint64_t seen = 0;            // results that the study has taken, in their order
  bool is_first = true;              // of the study's rounds
  bool complete() const { return places.empty(); }
};

// Takes what there is, and adds what is to be played to the file. At most so many places are looked for; of equal
// matches only the first. Throws campaign::StoreError, study::StudyError.
Missing missing_of(study::Study& study, campaign::Store& store, std::uint64_t most);

}  // namespace regista::cluster
