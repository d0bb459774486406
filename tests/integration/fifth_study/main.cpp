// SPDX-License-Identifier: MIT
// The program with one more study: a file for the study, one for its report, and this one for its command.
#include <array>
#include <memory>
#include <utility>
#include <vector>

#include "cli/command_line.hpp"
#include "cli/plugin_folders.hpp"
#include "cli/study_commands.hpp"
#include "cli/study_options.hpp"
#include "goal_count_report.hpp"
#include "results/results_file.hpp"
#include "results/study_run.hpp"
#include "study/tournament_setup.hpp"

namespace regista::cli {
namespace {

int count_goals(StudyOptions options, const Invocation& invocation) {
  const config::Node document = config::requested(options.asked(), config::DocumentKind::tournament);
  const plugin::Catalogue catalogue = open_plugins(options.plugins, invocation);
  study::PlannedTournament planned = study::planned_tournament(document, options.plugins, catalogue);
  options.plugin_files = catalogue.used_files();
  report::GoalCountReport report(std::move(planned.plan));
  campaign::Store store = results::open_results(options.results, options.resume, report.study(),
                                                {{}, planned.documents}, invocation.studies);
  return results::play_study(report, options, invocation, store, {});
}

void add_count_goals(Command& parent, const Invocation& invocation) {
  Command& command = parent.add("count-goals", "how many goals fall in a match");
  static constexpr std::array own{DocumentOption{"--team", "teams", DocumentOption::Form::teams},
                                  DocumentOption{"--pairs", "pairs"}};
  const auto options = std::make_shared<StudyOptions>();
  options->results = "goals.db";
  options->values.declare(command, config::DocumentKind::tournament, own);
  options->values.declare_common(command, config::DocumentKind::tournament);
  add_campaign_options(command, *options, options->results);
  command.run = [options, &invocation] { return count_goals(*options, invocation); };
}

}  // namespace
}  // namespace regista::cli

int main(int argc, char** argv) {
  using namespace regista;
  std::vector<results::StudyKind> kinds(cli::study_kinds().begin(), cli::study_kinds().end());
  kinds.push_back({study::GoalCount::name, "a count of goals",
                   [](const std::string& plan, const campaign::Store&,
                      const report::CommandOf&) -> std::unique_ptr<report::StudyReport> {
                     return std::make_unique<report::GoalCountReport>(study::GoalCount::schedule_of(plan));
                   }});
  const cli::Addition addition{cli::add_count_goals, kinds};
  return cli::run(argc, argv, &addition);
}
