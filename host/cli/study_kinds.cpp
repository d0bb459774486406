// SPDX-License-Identifier: MIT
// The table of all studies.
#include <array>
#include <utility>

#include "cli/study_commands.hpp"
#include "report/experiment_report.hpp"
#include "report/tournament_report.hpp"
#include "report/tuning_report.hpp"
#include "study/experiment_setup.hpp"
#include "study/plan_names.hpp"
#include "study/tournament_setup.hpp"
#include "study/tuning/search_time.hpp"
#include "study/tuning/tuning_setup.hpp"

namespace regista::cli {
namespace {

using Report = std::unique_ptr<report::StudyReport>;
using Folders = std::vector<std::string>;

// A plan that an older version stored does not say which that was; its file of results does.
template <class Plan>
Plan stored(Plan plan, const campaign::Store* store) {
  if (plan.program.empty() && store != nullptr) plan.program = store->meta("program");
  return plan;
}

template <class Plan>
results::PlannedStudy planned(Plan plan, std::vector<std::string> documents = {}) {
  plan.program = REGISTA_VERSION;
  return {to_json(plan), plan.asked.name, std::move(documents)};
}

}  // namespace

std::span<const results::StudyKind> study_kinds() {
  using config::DocumentKind;
  static const std::array<results::StudyKind, 3> kinds{{
      {study::tournament_study,
       "a tournament",
       DocumentKind::tournament,
       [](const config::Node& document, const Folders& plugins, const plugin::Catalogue& catalogue) {
         study::PlannedTournament found = study::planned_tournament(document, plugins, catalogue);
         return planned(std::move(found.plan), std::move(found.documents));
       },
       [](const std::string& plan, const campaign::Store* store, report::CommandOf again) -> Report {
         return report::tournament_report(stored(study::tournament_plan_from_json(plan), store), std::move(again));
       },
       false,
       [](const std::string& plan, std::uint64_t pairs) {
         return study::to_json(study::with_pairs(study::tournament_plan_from_json(plan), pairs));
       },
       {},
       study::check_tournament},
      {study::experiment_study,
       "an experiment",
       DocumentKind::experiment,
       [](const config::Node& document, const Folders& plugins, const plugin::Catalogue& catalogue) {
         return planned(study::planned_experiment(document, plugins, catalogue));
       },
       [](const std::string& plan, const campaign::Store* store, report::CommandOf again) -> Report {
         return report::experiment_report(stored(study::experiment_plan_from_json(plan), store), std::move(again));
       },
       true,
       {},
       {},
       study::check_experiment},
      {study::tuning_study,
       "a tuning",
       DocumentKind::tuning,
       [](const config::Node& document, const Folders& plugins, const plugin::Catalogue& catalogue) {
         return planned(study::planned_tuning(document, plugins, catalogue));
       },
       [](const std::string& plan, const campaign::Store* store, const report::CommandOf&) -> Report {
         return std::make_unique<report::TuningReport>(
             stored(study::tuning_plan_from_json(plan), store),
             store == nullptr ? study::OutOfTime() : study::stored_end_of_search(*store));
       },
       true,
       {},
       [](const std::string& plan, const campaign::Options& options, const output::OutputFiles& outputs,
          const Invocation& invocation) {
         TuneOptions tuning;
         static_cast<campaign::Options&>(tuning) = options;
         return play_tuning(plan, tuning, outputs, invocation);
       },
       study::check_tuning},
  }};
  return kinds;
}

}  // namespace regista::cli
