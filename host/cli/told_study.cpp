// SPDX-License-Identifier: MIT
#include "cli/told_study.hpp"

#include <fmt/format.h>

namespace regista::cli {

ToldStudy told_study(const StoredResults& results) {
  if (std::holds_alternative<study::TuningPlan>(results.plan)) return told_tuning(results);
  return std::holds_alternative<study::TournamentPlan>(results.plan) ? told_tournament(results)
                                                                     : told_experiment(results);
}

std::string not_at_its_end(const StoredResults& results, const char* study, std::uint64_t matches, std::uint64_t of) {
  return fmt::format("{} holds {} of {} matches without a gap: the {} is not at its end", results.file.string(),
                     matches, of, study);
}

}  // namespace regista::cli
