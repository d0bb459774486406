// SPDX-License-Identifier: MIT
#include "study/tuning/tuning_record.hpp"

namespace regista::study {

VerifiedAs TuningRecord::finding(std::size_t candidate) const {
  const VerifiedAs found = verification.findings()[candidate];
  return found == VerifiedAs::better && candidate_failed[candidate] ? VerifiedAs::undecided : found;
}

std::optional<std::size_t> TuningRecord::tuned() const {
  for (std::size_t i = 0; i < verification.of().size(); ++i) {
    if (finding(i) == VerifiedAs::better) return candidates[i];
  }
  return candidates.empty() ? std::nullopt : std::optional(candidates.front());
}

bool TuningRecord::verified() const {
  for (std::size_t i = 0; i < verification.of().size(); ++i) {
    if (finding(i) == VerifiedAs::better) return true;
  }
  return false;
}

}  // namespace regista::study
