// SPDX-License-Identifier: MIT
#include "cli/replayed_match.hpp"

#include <fmt/format.h>

#include <string>

#include "campaign/engine.hpp"
#include "cli/common_names.hpp"
#include "match/names.hpp"
#include "output/output.hpp"
#include "texts/message.hpp"

namespace regista::cli {

std::string end_in_words(const campaign::Decided& decided) {
  if (decided.set_aside()) return "could not be played: " + decided.why_set_aside;
  if (!decided.failure) return "was played to its end";
  const campaign::Failure& failure = *decided.failure;
  return fmt::format("was forfeited: {}, plugin {}, {}: {}", failure.side == 0 ? "home" : "away", failure.plugin,
                     failure.call, failure.what);
}

int play_failed(const MatchOptions& options, const results::StoredMatch& stored, campaign::Job job) {
  campaign::Decided now;
  try {
    job.record = options.record;
    job.expects_failure = stored.decided.failure.has_value();
    now = campaign::play_alone(job, stored.limits);
  } catch (const campaign::CampaignError& error) {
    if (error.kind() == campaign::CampaignError::Kind::input) throw BadInput(error.what());
    throw output::WriteError(error.what());
  }
  const bool same_side = now.failure && stored.decided.failure && now.failure->side == stored.decided.failure->side;
  if (same_side || (now.set_aside() && stored.decided.set_aside())) {
    output::print(texts::one_line(fmt::format("row {}, again: {}", options.row, end_in_words(now))) + '\n');
    return exit_done;
  }
  complain(texts::one_line(
      fmt::format("row {} {}; this time it {}", options.row, end_in_words(stored.decided), end_in_words(now))));
  return exit_no;
}

int compare(const MatchOptions& options, const campaign::Decided& stored, const match::Result& played) {
  const std::string hash = match::hash_text(played.hash);
  if (hash != stored.hash) {
    complain(
        fmt::format("row {} has the hash {}, this match {}: they are not the same", options.row, stored.hash, hash));
    return exit_no;
  }
  if (!options.quiet) complain(fmt::format("the same match as row {}: hash {}", options.row, hash));
  return exit_done;
}

}  // namespace regista::cli
