// SPDX-License-Identifier: MIT
#include "report/tuning_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <system_error>

#include "report/number.hpp"
#include "texts/message.hpp"

namespace regista::report {
namespace {

namespace fs = std::filesystem;

std::string signed_number(double value) { return fmt::format("{:+.3g}", value); }

// Returns the result of the verification in two lines of a YAML comment.
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

// Returns the path of the base team's file relative to the new file.
std::string base_from(const fs::path& file, const std::string& base) {
  // Resolves symbolic links, because a reader may open the file from its real folder.
  std::error_code error;
  const fs::path folder = fs::weakly_canonical(fs::absolute(file).parent_path(), error);
  const fs::path relative = fs::weakly_canonical(base, error).lexically_relative(folder);
  return relative.empty() ? fs::absolute(base).string() : relative.string();
}

}  // namespace

WhatWasPlayed TuningReport::played() const { return what_was_played(plan_); }

std::vector<std::string> TuningReport::notes() const {
  std::vector<std::string> out;
  for (const std::string& each : study::notes_on(plan_)) out.push_back("note: " + texts::one_line(each));
  return out;
}

// Describes a match: "search after 3 points, seed 12: tuned values 1:0 base team".
std::string TuningReport::match(const study::Round& round, std::uint64_t index,
                                const campaign::MatchResult& decided) const {
  std::string out = record().stage ? study::name(*record().stage) : "";
  if (record().stage == study::TuningStage::search) out += fmt::format(" after {} points", record().trace.size());
  const campaign::Job job = round.job(index);
  const std::array<std::string, 2> sides = players(round, index).sides;
  out += fmt::format(", seed {}: {} {}:{} {}", job.seed, sides[0], decided.score[0], decided.score[1], sides[1]);
  return texts::one_line(out + how_it_ended(decided, sides));
}

// The last override of a match is a value of the tuned team. Its path begins with the side of the tuned team.
MatchPlayers TuningReport::players(const study::Round& round, std::uint64_t index) const {
  MatchPlayers out = StudyReport::players(round, index);
  const campaign::Job job = round.job(index);
  if (job.overrides.empty()) return out;
  const std::size_t own = job.overrides.back().starts_with("away.") ? 1 : 0;
  if (job.teams[0] == job.teams[1]) out.sides[1 - own] = "base team";
  out.sides[own] = "tuned values";
  return out;
}

std::string TuningReport::incomplete() const {
  if (!record().stage) return {};
  return fmt::format("{} matches: the tuning is not at its end", study_.counted());
}

// The table has a line for each point of the search. Numbers have the fewest digits from which a reader gets exactly
// the same numbers. A field without a known value is empty.
std::string tuning_csv(const TuningView& view) {
  const study::TuningPlan& plan = view.plan;
  std::string out = "evaluation,pairs_from,repeated,failed,";
  for (const study::Parameter& each : plan.parameters) out += csv_field(each.path) + ',';
  out += "value,standard_error,pairs,best,matches\n";
  for (const study::SearchStep& each : view.record.trace) {
    const study::MeanEstimate& score = each.played.score;
    out += fmt::format("{},{},{},{},", each.evaluation, each.pairs_from, each.repeated ? 1 : 0,
                       each.played.failed ? 1 : 0);
    for (std::size_t i = 0; i < plan.parameters.size(); ++i) out += text_of(plan.parameters[i], each.values[i]) + ',';
    out += fmt::format("{},", of_objective(plan.objective, each.played.counted));
    if (score.pairs >= 2)
      out += fmt::format("{}", score.standard_deviation / std::sqrt(static_cast<double>(score.pairs)));
    out += fmt::format(",{},{},{}\n", score.pairs, of_objective(plan.objective, each.best), each.matches);
  }
  return out;
}

std::string tuned_file_text(const fs::path& file, const study::TuningPlan& plan, const study::TuningRecord& record,
                            const std::string& program, const std::string& fingerprint) {
  const study::Finalist& tuned = record.finalists[*record.tuned()];
  std::string name = plan.asked.name + "_tuned";
  if (name.size() > 64) name.resize(64);  // limit of config::to_name
  return header(plan, record, program, fingerprint) +
         study::tuned_team(plan, tuned.values, name, base_from(file, plan.asked.team));
}

}  // namespace regista::report
