// SPDX-License-Identifier: MIT
// `regista experiment`: what a difference between teams does to numbers of their matches, against one common opponent,
// seed by seed.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <optional>

#include "cli/command.hpp"
#include "cli/end_of_program.hpp"
#include "cli/file_options.hpp"
#include "cli/output.hpp"
#include "cli/output_files.hpp"
#include "cli/plugin_folders.hpp"
#include "cli/results_file.hpp"
#include "cli/results_page.hpp"
#include "cli/study_progress.hpp"
#include "cli/study_run.hpp"
#include "cli/terminal.hpp"
#include "config/text.hpp"
#include "report/experiment.hpp"
#include "report/tournament.hpp"
#include "study/experiment.hpp"
#include "study/experiment_setup.hpp"

namespace regista::cli {
namespace {

struct ExperimentOptions : study::ExperimentRequest {
  std::string csv, summary;  // files; empty: none
  bool force = false;        // they may replace files of another kind
};

constexpr auto examples = R"(Examples:
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
it, too. At its end there are, beside the results NAME.db, the page NAME.html and the figures NAME.figures/*.svg, *.png.
Exit codes: 0 played, whatever was found; 1 interrupted, or the results could not be written; 2 bad input; 3 a defect of
Regista.)";

class Played {
 public:
  Played(const ExperimentOptions& options, OutputFiles outputs, const Invocation& invocation,
         study::ExperimentPlan plan)
      : options_(options),
        outputs_(std::move(outputs)),
        invocation_(invocation),
        plan_(std::move(plan)),
        course_(plan_),
        view_{plan_, course_, [this](std::uint64_t index) { return play_again(job(index), invocation_); }} {}
  Played(const Played&) = delete;
  Played& operator=(const Played&) = delete;

  int play() {
    outputs_.check(options_.force);
    std::optional<OutputFile> csv;
    campaign::Store store = open_results(options_.results, options_.resume, plan_, {});
    if (!options_.csv.empty()) {
      csv.emplace(options_.csv);
      csv->write(report::experiment_csv_head(plan_));
    }
    StudyProgress progress(words(), !options_.quiet);
    tell_of_equal_arms(progress);
    play_study({"experiment", plan_.matches(), [this] { return course_.taken(); }}, options_, invocation_, store,
               progress, [&](const PlayRun& play) { play(run(csv ? &*csv : nullptr)); });
    if (csv) csv->close();
    if (!options_.summary.empty()) write_summary();
    print(options_.json ? report::experiment_json(view_) : report::experiment_text(view_));
    if (!options_.no_page) write_page(store);
    return exit_done;
  }

 private:
  // After hours, perhaps: what stands there now need not be what stood there before the first match.
  void write_summary() const {
    outputs_.check(options_.force);
    OutputFile summary(options_.summary);
    summary.write(report::experiment_summary_csv(view_));
    summary.close();
  }

  void write_page(const campaign::Store& store) const {
    const StudyPlan plan = plan_;
    const auto page = write_page_beside({options_.results, store, plan}, true);
    if (page && !options_.quiet) say(fmt::format("page: {}\n", config::one_line(page->string())));
  }

  StudyRun run(OutputFile* csv) {
    StudyRun out;
    out.matches = plan_.matches();
    out.fixtures = study::fixtures(plan_);
    out.at = [this](std::uint64_t index) -> std::optional<StudyRun::Place> {
      const study::Trial trial = study::trial(plan_, index);
      return StudyRun::Place{trial.number, trial.seed};
    };
    out.job = [this](std::uint64_t index) { return job(index); };
    out.take = [this, csv](std::uint64_t index, const campaign::Decided* decided) {
      course_.take(*decided);  // all matches are wanted
      if (csv) csv->write(report::experiment_csv_lines(plan_, index, *decided, report::CsvMeasures::all));
      return true;
    };
    out.first_of_pairing = [this](std::uint64_t index) {
      const study::Trial trial = study::trial(plan_, index);
      return trial.pair == 0 && trial.side == 0;
    };
    out.limits = plan_.limits;
    out.metrics = campaign::Metrics::wanted;
    return out;
  }

  StudyWords words() const {
    StudyWords out;
    out.matches = plan_.matches();
    out.taken = [this] { return course_.taken(); };
    out.standing = [this] { return report::experiment_standing(view_); };
    out.whole = [this] { return course_.taken() > 0 ? report::experiment_text(view_) : std::string(); };
    out.match = [this](std::uint64_t index, const campaign::Decided& decided) { return match_text(index, decided); };
    return out;
  }

  std::string match_text(std::uint64_t index, const campaign::Decided& decided) const {
    const study::Trial trial = study::trial(plan_, index);
    const std::string scene =
        plan_.openings.empty() ? "" : ", " + std::filesystem::path(plan_.openings[trial.opening].file).stem().string();
    const std::string arm = label(plan_, trial.condition);
    std::string out =
        fmt::format("seed {}{}: {} {} {}:{}", trial.seed, scene, config::one_line(arm),
                    trial.side == 0 ? "at home" : "away", decided.score[trial.side], decided.score[1 - trial.side]);
    if (decided.set_aside()) out += ", could not be played: " + config::one_line(decided.why_set_aside);
    if (decided.failure) {
      const bool own = static_cast<std::size_t>(decided.failure->side) == trial.side;
      out += ", " + report::forfeit_text(own ? arm : "the opponent", *decided.failure);
    }
    return out;
  }

  void tell_of_equal_arms(StudyProgress& progress) const {
    for (const study::Comparison& each : plan_.comparisons) {
      if (!study::equal_conditions(plan_, each)) continue;
      progress.note(fmt::format("A/A: {} and {} are equal, so they do not differ by construction",
                                config::one_line(label(plan_, each.first)),
                                config::one_line(label(plan_, each.second))));
    }
  }

  campaign::Job job(std::uint64_t index) const { return study::job(plan_, study::trial(plan_, index)); }

  const ExperimentOptions& options_;
  const OutputFiles outputs_;
  const Invocation& invocation_;
  study::ExperimentPlan plan_;
  study::Experiment course_;
  report::ExperimentView view_;
};

int experiment(ExperimentOptions options, OutputFiles outputs, const Invocation& invocation) {
  campaign::check(options);
  if (options.force && options.csv.empty() && options.summary.empty()) {
    throw BadInput("--force: belongs to --csv and --summary, which are not given");
  }
  if (options.file.empty()) throw BadInput("experiment: which one? Name its file; see: regista experiment --help");
  const plugin::Catalogue catalogue = open_plugins(options.plugins, invocation);
  study::ExperimentPlan plan = study::planned_experiment(options, catalogue);
  tell_what_is_not_used(catalogue, options.plugins);
  options.plugin_files = catalogue.used_files();
  if (options.results.empty()) options.results = plan.name + ".db";
  outputs.read(folders_of(catalogue), Reads::plugins);
  outputs.write_beside(options.results, options.no_page ? OutputFiles::Page::none : OutputFiles::Page::with_figures);
  return Played(options, std::move(outputs), invocation, std::move(plan)).play();
}

}  // namespace

Command add_experiment(CLI::App& parent, const Invocation& invocation) {
  CLI::App& app = *parent.add_subcommand("experiment", "compare arms in numbers of their matches");
  const auto options = std::make_shared<ExperimentOptions>();
  reads(app.add_option("file", options->file, "the experiment's document")->type_name("E.yaml"), Reads::documents);
  app.add_option("--set", options->overrides, "a value laid over that document; may be repeated")
      ->type_name("PATH=VALUE")
      ->allow_extra_args(false);
  app.add_option("--minutes", options->minutes,
                 "play so much of the game's clock for each arm, whatever the document says")
      ->type_name("N");
  app.add_option("--matches", options->matches, "play so many matches for each arm, whatever the document says")
      ->type_name("N");
  writes(app.add_option("--csv", options->csv, "write every number of every match of the arms as a table")
             ->type_name("FILE"),
         Writes::match_table);
  writes(app.add_option("--summary", options->summary, "write means and intervals as a table")->type_name("FILE"),
         Writes::summary_table);
  app.add_flag("--force", options->force, "let --csv and --summary replace files of another kind")
      ->disable_flag_override();
  add_campaign_options(app, *options, "the experiment's name with .db");
  app.footer(examples);
  return {&app,
          [options, &app, &invocation] { return experiment(*options, OutputFiles(app, "experiment"), invocation); }};
}

}  // namespace regista::cli
