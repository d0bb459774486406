// SPDX-License-Identifier: MIT
// `regista tournament`: which of two teams is better, or how several rank, in pairs of matches with the same seed and
// the sides swapped.
#include <memory>
#include <utility>

#include "cli/commands.hpp"
#include "cli/plugin_folders.hpp"
#include "cli/results_file.hpp"
#include "cli/study_commands.hpp"
#include "cli/study_run.hpp"
#include "output/output_files.hpp"
#include "report/tournament_report.hpp"
#include "study/tournament_setup.hpp"

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
A path of --set begins with a (the first team), b (the second), ..., rules, robot, disturbance or opening; without one
of these it goes to all teams. Each match runs in a process of its own: a plugin that crashes, hangs or takes all memory
forfeits its match 0:10. That keeps accidents apart; it is no protection from malice.

Exit codes: 0 played, whatever the verdict; 1 the results could not be written; 2 bad input; 3 a defect of
Regista; 130 interrupted.)";

}  // namespace

int tournament(study::TournamentRequest options, output::OutputFiles outputs, const Invocation& invocation) {
  campaign::check(options);
  const plugin::Catalogue catalogue = open_plugins(options.plugins, invocation);
  study::PlannedTournament planned = study::planned_tournament(options, catalogue);
  tell_what_is_not_used(catalogue, options.plugins);
  options.plugin_files = catalogue.used_files();
  if (options.results.empty()) {
    options.results = planned.plan.name.empty() ? "tournament.db" : planned.plan.name + ".db";
  }
  outputs.read(folders_of(catalogue), Reads::plugins);
  outputs.write_beside(options.results,
                       options.no_page ? output::OutputFiles::Page::none : output::OutputFiles::Page::alone);
  outputs.check(false);
  const auto report = report::tournament_report(std::move(planned.plan), play_again(invocation));
  campaign::Store store = open_results(options.results, options.resume, report->study(),
                                       {outputs.documents(), planned.documents}, invocation.studies);
  StudyWishes wishes;
  wishes.figures = false;
  return play_study(*report, options, invocation, store, wishes);
}

void add_tournament(Command& parent, const Invocation& invocation) {
  Command& command = parent.add("tournament", "find out which team is better");
  const auto options = std::make_shared<study::TournamentRequest>();
  command.take("file", options->file, "[T.yaml]",
               "the tournament's document, which says what the options from --team to --disturbance say, and "
               "--failures-in-a-row",
               Reads::documents);
  command.take("--team", options->teams, "FILE", "a team's file; to be given twice, or more often", Reads::documents);
  command.choose("--format", options->format, {"round-robin", "gauntlet"},
                 "of more than two teams: all against all (default), or the first against each of the others");
  command.take("--pairs", options->pairs, "N", "play so many pairs of matches of each pairing; with a test: at most");
  command.take("--sprt", options->sprt, "ELO0,ELO1", "stop when the scores tell a strength of ELO0 from one of ELO1");
  command.choose("--model", options->model, {"normalized", "logistic"},
                 "what --sprt is in: normalized (default) or logistic Elo");
  command.take("--metric", options->metric, "NAME",
               "stop when this differs: goals, or a number of a match such as "
               "striker.overlap_seconds");
  command.take("--alpha", options->alpha, "RATE", "rate of finding a difference in error; default 0.05");
  command.take("--beta", options->beta, "RATE", "of --sprt: rate of missing it; default 0.05");
  command.take("--openings", options->openings, "PATH", "scenes that matches start from: a file, or a folder of them",
               Reads::documents);
  command.take("--seed", options->seed, "N", "of the first pair; default 1");
  command.take("--limit", options->limit, "SECONDS", "end each match after so many simulated seconds");
  command.take("--rules", options->rules, "FILE", "rules profile; default: spl2023, built in", Reads::documents);
  command.take("--robot", options->robot, "FILE", "robot profile of all teams; default: nao, built in",
               Reads::documents);
  command.take("--disturbance", options->disturbance, "FILE", "disturbance profile; default: none", Reads::documents);
  command.take(
      "--set", options->overrides, "PATH=VALUE",
      "a value laid over the tournament's document; without one, over those of teams and profiles; may be repeated");
  command.take("--failures-in-a-row", options->failures_in_a_row, "N",
               "set a team aside after so many forfeits by the same plugin; default 10; 0: never");
  add_campaign_options(command, *options, "the tournament's name with .db, or tournament.db");
  command.notes(tournament_examples);
  command.run = [options, &command, &invocation] {
    return tournament(*options, output::OutputFiles(command.given(), "tournament"), invocation);
  };
}

}  // namespace regista::cli
