// SPDX-License-Identifier: MIT
#include "study/tuning/base_team_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "texts/message.hpp"

namespace regista::study {
namespace {

// The first that the tuned team, or else one of the others, forfeited for; null where none is listed.
const campaign::Failure* first_failure(const MatchTally& tally, bool of_tuned) {
  const std::vector<Forfeits>& listed = tally.forfeits.listed();
  const auto first =
      std::ranges::find_if(listed, [of_tuned](const Forfeits& each) { return (each.team == 0) == of_tuned; });
  return first == listed.end() ? nullptr : &first->failure;
}

std::string in_words(const campaign::Failure& failure, const std::string& team) {
  const std::string plugin = failure.plugin.empty() ? "a plugin of " + team : "plugin " + failure.plugin;
  const std::string call = failure.call.empty() ? "" : " in " + failure.call;
  return texts::one_line(plugin + call + ": " + failure.what);
}

std::string why_no_number(const MatchTally& tally) {
  const std::vector<MatchRemark>& unplayed = tally.remarks.unplayed().listed();
  if (!unplayed.empty()) return ": they could not be played: " + texts::one_line(unplayed.front().text);
  const campaign::Failure* const failure = first_failure(tally, false);
  return failure == nullptr ? "" : ": opponents forfeit: " + in_words(*failure, "an opponent");
}

}  // namespace

void check_base_team(const TuningPlan& plan, const PlayedScore& played, const MatchTally& tally) {
  if (played.failed) {
    const campaign::Failure* const failure = first_failure(tally, true);
    throw TuningError("the base team forfeits its first matches" +
                      (failure == nullptr ? std::string() : ": " + in_words(*failure, "the base team")));
  }
  if (played.score.pairs == 0) {
    throw TuningError(fmt::format("the base team's first matches have no number for the objective, {}{}",
                                  in_words(plan.objective), why_no_number(tally)));
  }
}

}  // namespace regista::study
