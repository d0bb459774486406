// SPDX-License-Identifier: MIT
#include "report/tuned_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>
#include <system_error>
#include <vector>

#include "report/number.hpp"
#include "study/tuning/tuned_team.hpp"
#include "texts/message.hpp"

namespace regista::report {
namespace {

namespace fs = std::filesystem;

std::string signed_number(double value) { return fmt::format("{:+.3g}", value); }

// What the verification found, a line or two.
std::string verdict(const study::TuningPlan& plan, const study::TuningRecord& record) {
  const auto which = std::ranges::find(record.candidates, *record.tuned()) - record.candidates.begin();
  const auto candidate = static_cast<std::size_t>(which);
  const study::ScoreDifference& found = record.verification.of()[candidate];
  const statistics::Estimate estimate = found.estimate();
  const char* const words =
      record.finding(candidate) == study::VerifiedAs::better      ? "VERIFIED better than the base team"
      : record.finding(candidate) == study::VerifiedAs::worse     ? "NOT VERIFIED: worse than the base team"
      : record.finding(candidate) == study::VerifiedAs::prevented ? "NOT VERIFIED: pairs that could not be played"
                                                                  : "NOT VERIFIED: no difference was found";
  const double sign = study::value_of(plan.objective, 1.0);
  const double low = sign > 0 ? estimate.interval.low : -estimate.interval.high,
               high = sign > 0 ? estimate.interval.high : -estimate.interval.low;
  const std::string interval = estimate.interval.bounded() ? fmt::format("[{}, {}] at {:.4g} %", signed_number(low),
                                                                         signed_number(high), 100.0 * plan.confidence())
                                                           : std::string("(too few pairs for an interval)");
  return fmt::format("{}, on {} pairs with held-out seeds:\n#   {} {} {}, p = {:.2g} after Holm", words,
                     record.verification.pairs(), study::in_words(plan.objective), signed_number(sign * estimate.value),
                     interval, record.verification.adjusted()[candidate]);
}

std::string header(const study::TuningPlan& plan, const study::TuningRecord& record, const std::string& program,
                   const std::string& fingerprint) {
  std::vector<std::string> opponents;
  for (const study::TuningOpponent& each : plan.opponents) {
    opponents.push_back(fmt::format("{} ({:.3g})", texts::one_line(each.file), each.weight));
  }
  return fmt::format(
      "{} {} from {}; {}\n"
      "# Objective: {} {}, against {}\n"
      "# Search: {}, {} points, seed {}; results of all matches: {}\n"
      "# Begun in {}; to play it again: regista report RESULTS.db --study FOLDER\n",
      tuned_file_begin, program, texts::one_line(plan.asked.team), verdict(plan, record),
      plan.objective.minimise ? "minimise" : "maximise", study::in_words(plan.objective), fmt::join(opponents, ", "),
      study::name(plan.algorithm()), record.trace.size(), plan.seed(), fingerprint, texts::one_line(plan.folder));
}

// The base team's file as the new one is to name it.
std::string base_from(const fs::path& file, const std::string& base) {
  // As links lead: the file may be opened from where its folder really is.
  std::error_code error;
  const fs::path folder = fs::weakly_canonical(fs::absolute(file).parent_path(), error);
  const fs::path relative = fs::weakly_canonical(base, error).lexically_relative(folder);
  return relative.empty() ? fs::absolute(base).string() : relative.string();
}

}  // namespace

std::string tuned_file_text(const fs::path& file, const study::TuningPlan& plan, const study::TuningRecord& record,
                            const std::string& program, const std::string& fingerprint) {
  const study::Finalist& tuned = record.finalists[*record.tuned()];
  std::string name = plan.asked.name + "_tuned";
  if (name.size() > 64) name.resize(64);  // config::to_name
  return header(plan, record, program, fingerprint) +
         study::tuned_team(plan, tuned.values, name, base_from(file, plan.asked.team));
}

}  // namespace regista::report
