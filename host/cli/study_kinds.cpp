// SPDX-License-Identifier: MIT
// The table of all studies.
#include <array>
#include <utility>

#include "cli/study_commands.hpp"
#include "report/experiment_report.hpp"
#include "report/tournament_report.hpp"
#include "report/tuning_report.hpp"
#include "study/plan_names.hpp"
#include "study/tuning/search_time.hpp"
#include "study/tuning/tuning_plan.hpp"

namespace regista::cli {

std::span<const results::StudyKind> study_kinds() {
  using Report = std::unique_ptr<report::StudyReport>;
  static const std::array<results::StudyKind, 3> kinds{{
      {study::tournament_study, "a tournament",
       [](const std::string& plan, const campaign::Store&, report::CommandOf again) -> Report {
         return report::tournament_report(study::tournament_plan_from_json(plan), std::move(again));
       },
       false,
       [](const std::string& plan, std::uint64_t pairs) {
         return study::to_json(study::with_pairs(study::tournament_plan_from_json(plan), pairs));
       }},
      {study::experiment_study, "an experiment",
       [](const std::string& plan, const campaign::Store&, report::CommandOf again) -> Report {
         return report::experiment_report(study::experiment_plan_from_json(plan), std::move(again));
       }},
      {study::tuning_study,
       "a tuning",
       [](const std::string& plan, const campaign::Store& store, const report::CommandOf&) -> Report {
         return std::make_unique<report::TuningReport>(study::tuning_plan_from_json(plan),
                                                       study::stored_end_of_search(store));
       },
       true,
       {},
       [](const std::string& plan, const campaign::Options& options, const output::OutputFiles& outputs,
          const Invocation& invocation) {
         TuneOptions tuning;
         static_cast<campaign::Options&>(tuning) = options;
         return tune_by_plan(study::tuning_plan_from_json(plan), tuning, outputs, invocation);
       }},
  }};
  return kinds;
}

}  // namespace regista::cli
