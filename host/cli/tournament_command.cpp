// SPDX-License-Identifier: MIT
// `regista tournament`: which of two teams is better, or how several rank, in pairs of matches with the same seed and
// the sides swapped.
#include <array>
#include <memory>
#include <utility>

#include "cli/commands.hpp"
#include "cli/study_commands.hpp"
#include "output/output_files.hpp"

namespace regista::cli {
namespace {

constexpr auto tournament_examples = R"(Examples:
  regista tournament configs/studies/rivals.yaml
  regista tournament --team configs/teams/paper.yaml --team configs/teams/fixed_rate.yaml --pairs 100
  regista tournament --team new.yaml --team old.yaml --sprt 0,20 --openings configs/openings
  regista tournament --team a.yaml --team b.yaml --metric striker.overlap_seconds --pairs 200 --limit 300
  regista tournament --team a.yaml --team b.yaml --team c.yaml --pairs 50 --results night.db
  regista tournament --team a.yaml --team b.yaml --team c.yaml --pairs 50 --results night.db --resume
  regista tournament --team a.yaml --team b.yaml --pairs 50 --record-every 20
  regista tournament --team a.yaml --team a.yaml --pairs 50 --set b.utility.terms.distance.weight=0.5

A pair is two matches with the same seed and the sides swapped; pair k has the seed of --seed plus k - 1, and the k-th
opening, or under a test one drawn by that seed. The test is fixed before the first match: --sprt stops as soon as the scores of pairs speak for H1 (stronger
by ELO1) or H0 (by ELO0); --metric goals, or any number of a match, as soon as they differ, at the latest after --pairs.
Without a test all pairs are played.
Each option takes the place of what the document says. A path of --set is one of the document, or begins with a (the
first team), b (the second), ..., rules, robot, disturbance or opening; any other goes to all teams. Each match runs in a process of its own: a plugin that crashes, hangs or takes all memory
forfeits its match 0:10. That keeps accidents apart; it is no protection from malice.

Exit codes: 0 played, whatever the verdict; 1 the results could not be written; 2 bad input; 3 a defect of
Regista; 130 interrupted.)";

int tournament(const StudyOptions& options, output::OutputFiles outputs, const Invocation& invocation) {
  const config::StudyRequest asked = options.asked();
  if (asked.file.empty() && asked.options.empty()) {
    throw BadInput(
        "tournament: expected a document, or two teams or more, each by --team FILE; see: regista tournament --help");
  }
  return play(study_kind(config::DocumentKind::tournament), options, std::move(outputs), invocation);
}

}  // namespace

void add_tournament(Command& parent, const Invocation& invocation) {
  using enum DocumentOption::Form;
  static constexpr std::array own{
      DocumentOption{"--team", "teams", teams},
      DocumentOption{"--format", "format"},
      DocumentOption{"--pairs", "pairs"},
      DocumentOption{"--sprt", "test.elo", pair},
      DocumentOption{"--model", "test.model"},
      DocumentOption{"--metric", "test.metric"},
      DocumentOption{"--alpha", "test.alpha"},
      DocumentOption{"--beta", "test.beta"},
      DocumentOption{"--failures-in-a-row", "failures_in_a_row"},
  };
  Command& command = parent.add("tournament", "find out which team is better");
  const auto options = std::make_shared<StudyOptions>();
  command.take("file", options->file, "[T.yaml]", "the tournament's document; without it the options say all",
               Reads::documents);
  options->values.declare(command, config::DocumentKind::tournament, own);
  options->values.declare_common(command, config::DocumentKind::tournament);
  command.take("--set", options->set, "PATH=VALUE",
               "a value laid over the tournament's document, or over those of its matches; may be repeated");
  add_campaign_options(command, *options, "the tournament's name with .db");
  command.notes(tournament_examples);
  command.run = [options, &command, &invocation] {
    return tournament(*options, output::OutputFiles(command.given(), "tournament"), invocation);
  };
}

}  // namespace regista::cli
