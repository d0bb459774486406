// SPDX-License-Identifier: MIT
#include "cli/study_commands.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>

#include "output/replaced_file.hpp"
#include "report/experiment_report.hpp"
#include "report/tournament_report.hpp"
#include "report/tuning_report.hpp"
#include "results/results_file.hpp"
#include "study/experiment_plan.hpp"
#include "study/study.hpp"
#include "study/tournament_plan.hpp"
#include "study/tuning/pair_search.hpp"
#include "study/tuning/tuning_plan.hpp"
#include "texts/message.hpp"

namespace regista::cli {
namespace {

// Prints the plugins that a repeated study used (key `played_with` of its document) and that are missing now.
void name_missing_plugins(const config::Node& document, const plugin::Catalogue& catalogue) {
  constexpr std::string_view kind = "plugin ";
  for (const config::Node& line : document["played_with"].elements()) {
    if (line.kind() != config::Node::Kind::scalar || !line.text().starts_with(kind)) continue;
    const std::string id = line.text().substr(kind.size(), line.text().find(' ', kind.size()) - kind.size());
    const bool there =
        std::ranges::any_of(catalogue.plugins(), [&](const auto& each) { return each.descriptor->id == id; });
    if (there) continue;
    complain(
        to_string(line.where()) +
        texts::one_line(fmt::format(
            ": it was played with the plugin {}, which none of the folders has; name its folder: --plugins DIR", id)));
  }
}

// --- `regista tournament`: compares two teams or ranks several. Matches of a pair have one seed and swapped sides.

constexpr auto tournament_examples = R"(Examples:
  regista tournament configs/studies/rivals.yaml
  regista tournament --team configs/teams/paper.yaml --team configs/teams/fixed_rate.yaml --pairs 100
  regista tournament --team new.yaml --team old.yaml --sprt 0,20 --openings configs/openings
  regista tournament --team a.yaml --team b.yaml --metric striker.overlap_seconds --pairs 200 --limit 300
  regista tournament --team a.yaml --team b.yaml --team c.yaml --pairs 50 --results night.db
  regista tournament --team a.yaml --team b.yaml --team c.yaml --pairs 50 --results night.db --resume
  regista tournament --team a.yaml --team b.yaml --until 08:00
  regista tournament --team a.yaml --team b.yaml --pairs 50 --record-every 20
  regista tournament --team a.yaml --team a.yaml --pairs 50 --set b.utility.terms.distance.weight=0.5

A pair is two matches with the same seed and the sides swapped; the first has a hash of --seed, each pair the seed after
that of the one before, and the k-th has the k-th opening, or under a test one drawn by its seed. The test is fixed before the first match: --sprt stops as soon as the scores of pairs speak for H1 (stronger
by ELO1) or H0 (by ELO0); --metric goals, or any number of a match, as soon as they differ, at the latest after --pairs.
Without a test all pairs are played. With --until or --minutes the tournament ends when time is over, with the pairs that
all teams have played, a number that no result decides; without --pairs and a test it plays as many as fit.
Each option takes the place of what the document says. A path of --set is one of the document, or begins with a (the
first team), b (the second), ..., rules, robot, disturbance or opening; any other goes to all teams. Each match runs in a process of its own: a plugin that crashes, hangs or takes all memory
forfeits its match 0:10. That keeps accidents apart; it is no protection from malice.)";

int tournament(const StudyOptions& options, output::OutputFiles outputs, const Invocation& invocation) {
  const config::StudyRequest asked = options.asked();
  if (asked.file.empty() && asked.options.empty()) {
    throw BadInput(
        "tournament: expected a document, or two teams or more, each by --team FILE; see: regista tournament --help");
  }
  return play(study_kind(config::DocumentKind::tournament), options, std::move(outputs), invocation);
}

// --- `regista experiment`: compares numbers from the matches of several teams against one opponent, seed by seed.

constexpr auto experiment_examples = R"(Examples:
  regista experiment configs/studies/role_overlap.yaml
  regista experiment configs/studies/role_overlap.yaml --matches 4 --csv matches.csv
  regista experiment configs/studies/role_overlap.yaml --set arms.events.set='{sender.params.reserve: 60}'
  regista experiment configs/studies/packet_loss.yaml --results night.db
  regista experiment configs/studies/packet_loss.yaml --results night.db --resume
  regista experiment configs/studies/packet_loss.yaml --until 08:00
  regista report night.db --json

The document names arms (teams, or one team with values set), one common opponent, how much is played, and what is
measured; `regista config show` explains its values, docs/experiments.md the method. Every arm plays the same seeds and
scenes at home and away, so that arms are compared pair by pair. A path of an arm's `set`, or of a sweep, is one of its
team unless it begins with opponent, rules, robot, disturbance or opponent_disturbance.
With --until or --minutes the experiment ends before its planned number of pairs if time is over: with the pairs that
every arm has played, a number that no result decides.
All arms are checked before the first match; seeds, number of matches, test and hashes of everything are stored before
it, too. At its end there are, beside the results NAME.db, the page NAME.html and the figures NAME.figures/*.svg.)";

struct ExperimentOptions : StudyOptions {
  std::string csv, summary;  // paths of files; empty: no file
  bool force = false;        // --force: outputs may replace files of another kind
};

int experiment(const ExperimentOptions& options, output::OutputFiles outputs, const Invocation& invocation) {
  if (options.force && options.csv.empty() && options.summary.empty()) {
    throw BadInput("--force: belongs to --csv and --summary, which are not given");
  }
  if (options.file.empty()) throw BadInput("experiment: which one? Name its file; see: regista experiment --help");
  std::optional<output::OutputFile> csv;
  const auto tables = [&](report::StudyReport& report, output::OutputFiles& all) {
    results::StudyHooks hooks;
    if (!options.csv.empty()) {
      csv.emplace(options.csv);
      csv->write(report.begin_table({.all_metrics = true}));
      hooks.after = [&csv, &report](const study::Round& round, std::uint64_t index,
                                    const campaign::MatchResult* decided) {
        csv->write(report.table_lines(round, index, *decided));
      };
    }
    hooks.at_end = [&options, &csv, &report, &all] {
      if (csv) csv->close();
      if (options.summary.empty()) return;
      all.check(options.force);  // a file may have appeared during the study
      output::OutputFile summary(options.summary);
      summary.write(report.summary_table());
      summary.close();
    };
    return hooks;
  };
  return play(study_kind(config::DocumentKind::experiment), options, std::move(outputs), invocation, tables,
              options.force);
}

// --- `regista tune`: searches for better numbers for a team and verifies them on other seeds.

constexpr auto tune_examples = R"(Examples:
  regista tune configs/studies/tune_paper.yaml
  regista tune configs/studies/tune_paper.yaml --matches 400 --set search.algorithm=spsa
  regista tune configs/studies/tune_paper.yaml --results night.db --resume
  regista tune configs/studies/tune_paper.yaml --minutes 60
  regista report night.db --json

The document names a team, opponents, the values that may change, what counts as better, an algorithm and how much is
played; `regista config show` explains its values, docs/tuning.md the method. What the search finds is only a guess: the
best points are played again on other seeds, and the best of these meet the base team on held-out seeds,
in a test that may stop at any pair. The team that comes of it is written beside the results, NAME.tuned.yaml, with
what was found about it in its head, whether or not it was found better.
--until and --minutes end the search, as search.minutes does; what it found is then selected and verified, which takes
its own time.)";

int tune(TuneOptions options, output::OutputFiles outputs, const Invocation& invocation) {
  if (options.file.empty()) throw BadInput("tune: which one? Name its file; see: regista tune --help");
  const results::PlannedStudy study = planned(study_kind(config::DocumentKind::tuning), options, outputs, invocation);
  return play_tuning(study.plan, options, std::move(outputs), invocation);
}

using Report = std::unique_ptr<report::StudyReport>;
using Folders = std::vector<std::string>;

// Plans of older versions lack the version of the program. This function adds the version from the file of results.
template <class Plan>
Plan stored(Plan plan, const campaign::Store* store) {
  if (plan.program.empty() && store != nullptr) plan.program = store->meta("program");
  return plan;
}

template <class Plan>
results::PlannedStudy planned(Plan plan, const config::Mistakes& mistakes, std::vector<std::string> documents = {}) {
  if (!mistakes.none()) return {};
  plan.program = REGISTA_VERSION;
  return {to_json(plan), plan.asked.name, std::move(documents)};
}

// Plans a study of one document. plan_document: study::planned_experiment() or study::planned_tuning().
template <auto plan_document>
results::PlannedStudy planned_by(const config::Node& document, const Folders& plugins,
                                 const plugin::Catalogue& catalogue, config::Mistakes& mistakes) {
  return planned(plan_document(document, plugins, catalogue, mistakes), mistakes);
}

// These functions call study::with_pairs() and study::without_end() for the text of a plan. read: reads the text.
template <auto read>
std::string with_pairs(const std::string& plan, std::uint64_t pairs, std::uint64_t matches) {
  return study::to_json(study::with_pairs(read(plan), pairs, matches));
}
template <auto read>
std::string without_end(const std::string& plan) {
  return study::to_json(study::without_end(read(plan)));
}

}  // namespace

const results::StudyKind& study_kind(const config::DocumentKind& document) {
  return *std::ranges::find_if(study_kinds(),
                               [&](const results::StudyKind& each) { return each.document == document; });
}

results::PlannedStudy planned(const results::StudyKind& kind, StudyOptions& options, output::OutputFiles& outputs,
                              const Invocation& invocation) {
  campaign::check(options);
  config::Node document = config::requested(options.asked(), kind.document);
  if (options.end_of_time && kind.until_the_clock) document = kind.until_the_clock(document);
  const plugin::Catalogue catalogue = open_plugins(options.plugins, invocation);
  name_missing_plugins(document, catalogue);
  config::Mistakes first(config::Mistakes::After::stop);
  results::PlannedStudy out = kind.plan(document, options.plugins, catalogue, first);
  tell_what_is_not_used(catalogue, options.plugins);
  options.plugin_files = catalogue.used_files();
  if (options.results.empty()) options.results = out.name + ".db";
  outputs.read(folders_of(catalogue), Reads::plugins);
  outputs.write_beside(options.results, !options.no_page, kind.figures);
  return out;
}

int play(const results::StudyKind& kind, StudyOptions options, output::OutputFiles outputs,
         const Invocation& invocation, const HooksOf& hooks, bool force) {
  const results::PlannedStudy study = planned(kind, options, outputs, invocation);
  if (kind.play) return kind.play(study.plan, options, outputs, invocation);
  outputs.check(force);
  const report::CommandOf again = results::play_again(invocation);
  auto report = kind.report(study.plan, nullptr, again);
  campaign::Store store = results::open_results(options.results, options.resume, report->study(),
                                                {outputs.documents(), study.documents}, invocation.studies);
  if (options.resume) {
    if (options.end_of_time) results::lift_end(options.results, store, invocation.studies);
    report = results::stored_study(options.results, store, again, invocation.studies);
  }
  return results::play_study(*report, options, invocation, store,
                             hooks ? hooks(*report, outputs) : results::StudyHooks());
}

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
  add_document_options(command, *options, config::DocumentKind::tournament, own, "the tournament's document");
  add_campaign_options(command, *options, "the tournament's name with .db");
  command.notes(tournament_examples, "0 played, whatever the verdict; 1 the results could not be written",
                command::resumable);
  command.run = [options, &command, &invocation] {
    return tournament(*options, command.outputs("tournament"), invocation);
  };
}

void add_experiment(Command& parent, const Invocation& invocation) {
  static constexpr std::array own{
      DocumentOption{"--game-minutes", "minutes", DocumentOption::Form::value, "matches"},
      DocumentOption{"--matches", "matches", DocumentOption::Form::value, "minutes"},
      DocumentOption{"--opponent-disturbance", "opponent_disturbance"},
  };
  Command& command = parent.add("experiment", "compare arms in numbers of their matches");
  const auto options = std::make_shared<ExperimentOptions>();
  command.take("file", options->file, "E.yaml", "the experiment's document", Reads::documents);
  add_document_options(command, *options, config::DocumentKind::experiment, own);
  command.take("--csv", options->csv, "FILE", "write every number of every match of the arms as a table",
               Writes::match_table);
  command.take("--summary", options->summary, "FILE", "write means and intervals as a table", Writes::summary_table);
  command.flag("--force", options->force, "let --csv and --summary replace files of another kind");
  add_campaign_options(command, *options, "the experiment's name with .db");
  command.notes(experiment_examples, "0 played, whatever was found; 1 the results could not be written",
                command::resumable);
  command.run = [options, &command, &invocation] {
    return experiment(*options, command.outputs("experiment"), invocation);
  };
}

int play_tuning(const std::string& plan, const TuneOptions& options, output::OutputFiles outputs,
                const Invocation& invocation) {
  const std::filesystem::path tuned =
      options.output.empty() ? study::tuned_file(options.results) : std::filesystem::path(options.output);
  outputs.write("the tuned team", tuned, Writes::tuned_team);
  outputs.check(options.force);
  study::OutOfTime clock;  // tells when the search's time is over; set after the file of results is open
  const auto out_of_time = [&clock](std::uint64_t evaluations) { return clock && clock(evaluations); };
  auto report = std::make_unique<report::TuningReport>(study::tuning_plan_from_json(plan), out_of_time);
  campaign::Store store = results::open_results(options.results, options.resume, report->study(),
                                                {outputs.documents(), {}}, invocation.studies);
  if (options.resume) {
    report =
        std::make_unique<report::TuningReport>(study::tuning_plan_from_json(results::stored_plan(store)), out_of_time);
  }
  try {
    // If this run plays no match itself, the search ends where the stored one ended, not when this run's time is over.
    const bool plays = options.plays != campaign::Options::Plays::nothing_more;
    clock =
        plays ? study::search_clock(store, report->plan(), options.end_of_time) : study::stored_end_of_search(store);
  } catch (const campaign::StoreError& error) {
    throw BadInput(error.what());
  }
  campaign::Options own = options;
  own.end_of_time.reset();  // the time limits only the search, through `clock`
  std::optional<output::OutputFile> trace;
  if (!options.trace.empty()) trace.emplace(options.trace);
  std::exception_ptr not_written;
  results::StudyHooks hooks;
  hooks.after = [&report](const study::Round& round, std::uint64_t index, const campaign::MatchResult* decided) {
    report->take(round, index, decided);
  };
  hooks.at_end = [&] {
    if (trace) {
      trace->write(report->end_table());
      trace->close();
    }
    if (!report->record().tuned()) return;
    try {
      outputs.check(options.force);  // a file may have appeared during the tuning
      output::write_whole(
          tuned,
          report::tuned_file_text(tuned, report->plan(), report->record(), REGISTA_VERSION, report->fingerprint()),
          output::Existing::replaced);
      report->tuned_file(tuned.string());
    } catch (...) {
      not_written = std::current_exception();  // rethrown below, after the findings are printed
    }
  };
  const int exit = results::play_study(*report, own, invocation, store, hooks);
  if (not_written) std::rethrow_exception(not_written);
  return exit;
}

void add_tune(Command& parent, const Invocation& invocation) {
  static constexpr std::array own{
      DocumentOption{"--matches", "search.matches"},
      DocumentOption{"--opponent-disturbance", "opponent_disturbance"},
  };
  Command& command = parent.add("tune", "search a team's numbers for better ones, and verify what was found");
  const auto options = std::make_shared<TuneOptions>();
  command.take("file", options->file, "T.yaml", "the tuning's document", Reads::documents);
  add_document_options(command, *options, config::DocumentKind::tuning, own);
  command.take("--trace", options->trace, "FILE", "write every point of the search as a table", Writes::search_table);
  command.take("--output", options->output, "FILE",
               "file for the tuned team; default: NAME.tuned.yaml beside the results", Writes::tuned_team);
  command.flag("--force", options->force, "let --trace and the tuned team replace files of another kind");
  add_campaign_options(command, *options, "the tuning's name with .db");
  command.notes(tune_examples, "0 played, whatever was found; 1 the results could not be written", command::resumable);
  command.run = [options, &command, &invocation] { return tune(*options, command.outputs("tuning"), invocation); };
}

std::span<const results::StudyKind> study_kinds() {
  using config::DocumentKind;
  using config::Mistakes;
  using config::Node;
  using plugin::Catalogue;
  static const std::array<results::StudyKind, 3> kinds{{
      {.name = study::tournament_study,
       .article = "a tournament",
       .document = DocumentKind::tournament,
       .plan =
           [](const Node& document, const Folders& plugins, const Catalogue& catalogue, Mistakes& mistakes) {
             study::PlannedTournament found = study::planned_tournament(document, plugins, catalogue, mistakes);
             return planned(std::move(found.plan), mistakes, std::move(found.documents));
           },
       .report = [](const std::string& plan, const campaign::Store* store, report::CommandOf again) -> Report {
         return report::tournament_report(stored(study::tournament_plan_from_json(plan), store), std::move(again));
       },
       .figures = false,
       .with_pairs = with_pairs<study::tournament_plan_from_json>,
       .without_end = without_end<study::tournament_plan_from_json>,
       .until_the_clock = study::until_the_clock},
      {.name = study::experiment_study,
       .article = "an experiment",
       .document = DocumentKind::experiment,
       .plan = planned_by<study::planned_experiment>,
       .report = [](const std::string& plan, const campaign::Store* store, report::CommandOf again) -> Report {
         return report::experiment_report(stored(study::experiment_plan_from_json(plan), store), std::move(again));
       },
       .with_pairs = with_pairs<study::experiment_plan_from_json>,
       .without_end = without_end<study::experiment_plan_from_json>},
      {.name = study::tuning_study,
       .article = "a tuning",
       .document = DocumentKind::tuning,
       .plan = planned_by<study::planned_tuning>,
       .report = [](const std::string& plan, const campaign::Store* store, const report::CommandOf&) -> Report {
         return std::make_unique<report::TuningReport>(
             stored(study::tuning_plan_from_json(plan), store),
             store == nullptr ? study::OutOfTime() : study::stored_end_of_search(*store));
       },
       .play =
           [](const std::string& plan, const campaign::Options& options, const output::OutputFiles& outputs,
              const Invocation& invocation) {
             TuneOptions tuning;
             static_cast<campaign::Options&>(tuning) = options;
             return play_tuning(plan, tuning, outputs, invocation);
           }},
  }};
  return kinds;
}

}  // namespace regista::cli
