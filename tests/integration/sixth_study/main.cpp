// SPDX-License-Identifier: MIT
// The program with one more study: a file for its document, one for the study, one for what is said of it, and its row
// in the table of studies here.
#include <memory>
#include <vector>

#include "cli/command_line.hpp"
#include "cli/study_commands.hpp"
#include "goal_count_report.hpp"

int main(int argc, char** argv) {
  using namespace regista;
  std::vector<results::StudyKind> kinds(cli::study_kinds().begin(), cli::study_kinds().end());
  kinds.push_back({study::goal_count_study, "a count of goals", config::goal_count_kind, study::planned_goal_count,
                   [](const std::string& plan, const campaign::Store*, const report::CommandOf&) {
                     return std::make_unique<report::GoalCountReport>(study::goal_count_plan(plan));
                   }});
  return cli::run(argc, argv, kinds);
}
