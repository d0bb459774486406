// SPDX-License-Identifier: MIT
// `regista experiment`: what a difference between teams does to numbers of their matches, against one common opponent,
// seed by seed.
#include <array>
#include <memory>
#include <optional>
#include <utility>

#include "cli/commands.hpp"
#include "cli/study_commands.hpp"
#include "output/output.hpp"
#include "output/output_files.hpp"

namespace regista::cli {
namespace {

constexpr auto experiment_examples = R"(Examples:
  regista experiment configs/studies/role_overlap.yaml
  regista experiment configs/studies/role_overlap.yaml --matches 4 --csv matches.csv
  regista experiment configs/studies/role_overlap.yaml --set arms.events.set='{sender.params.reserve: 60}'
  regista experiment configs/studies/packet_loss.yaml --results night.db
  regista experiment configs/studies/packet_loss.yaml --results night.db --resume
  regista report night.db --json

The document names arms (teams, or one team with values set), one common opponent, how much is played, and what is
measured; `regista config show` explains its values, docs/experiments.md the method. Every arm plays the same seeds and
scenes at home and away, so that arms are compared pair by pair. A path of an arm's `set`, or of a sweep, is one of its
team unless it begins with opponent, rules, robot, disturbance or opponent_disturbance.
All arms are checked before the first match; seeds, number of matches, test and hashes of everything are stored before
it, too. At its end there are, beside the results NAME.db, the page NAME.html and the figures NAME.figures/*.svg.

Exit codes: 0 played, whatever was found; 1 the results could not be written; 2 bad input; 3 a defect of
Regista; 130 interrupted.)";

struct ExperimentOptions : StudyOptions {
  std::string csv, summary;  // files; empty: none
  bool force = false;        // they may replace files of another kind
};

int experiment(const ExperimentOptions& options, output::OutputFiles outputs, const Invocation& invocation) {
  if (options.force && options.csv.empty() && options.summary.empty()) {
    throw BadInput("--force: belongs to --csv and --summary, which are not given");
  }
  if (options.file.empty()) throw BadInput("experiment: which one? Name its file; see: regista experiment --help");
  std::optional<output::OutputFile> csv;
  const auto tables = [&](report::StudyReport& report, output::OutputFiles& all) {
    results::StudyWishes wishes;
    if (!options.csv.empty()) {
      csv.emplace(options.csv);
      csv->write(report.begin_table({.all_metrics = true}));
      wishes.after = [&csv, &report](const study::Round& round, std::uint64_t index, const campaign::Decided* decided) {
        csv->write(report.table_lines(round, index, *decided));
      };
    }
    wishes.at_end = [&options, &csv, &report, &all] {
      if (csv) csv->close();
      if (options.summary.empty()) return;
      all.check(options.force);  // hours later, perhaps
      output::OutputFile summary(options.summary);
      summary.write(report.summary_table());
      summary.close();
    };
    return wishes;
  };
  return play(study_kind(config::DocumentKind::experiment), options, std::move(outputs), invocation, tables,
              options.force);
}

}  // namespace

void add_experiment(Command& parent, const Invocation& invocation) {
  static constexpr std::array own{
      DocumentOption{"--minutes", "minutes", DocumentOption::Form::value, "matches"},
      DocumentOption{"--matches", "matches", DocumentOption::Form::value, "minutes"},
      DocumentOption{"--opponent-disturbance", "opponent_disturbance"},
  };
  Command& command = parent.add("experiment", "compare arms in numbers of their matches");
  const auto options = std::make_shared<ExperimentOptions>();
  command.take("file", options->file, "E.yaml", "the experiment's document", Reads::documents);
  options->values.declare(command, config::DocumentKind::experiment, own);
  options->values.declare_common(command, config::DocumentKind::experiment);
  command.take("--set", options->set, "PATH=VALUE",
               "a value laid over that document, or over those of its matches; may be repeated");
  command.take("--csv", options->csv, "FILE", "write every number of every match of the arms as a table",
               Writes::match_table);
  command.take("--summary", options->summary, "FILE", "write means and intervals as a table", Writes::summary_table);
  command.flag("--force", options->force, "let --csv and --summary replace files of another kind");
  add_campaign_options(command, *options, "the experiment's name with .db");
  command.notes(experiment_examples);
  command.run = [options, &command, &invocation] {
    return experiment(*options, output::OutputFiles(command.given(), "experiment"), invocation);
  };
}

}  // namespace regista::cli
