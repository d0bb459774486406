// SPDX-License-Identifier: MIT
// `regista tune`: searches the numbers of a team for better ones, and says on other seeds whether they are.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <exception>
#include <filesystem>
#include <memory>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

#include "cli/command.hpp"
#include "cli/end_of_program.hpp"
#include "cli/file_options.hpp"
#include "cli/output.hpp"
#include "cli/output_files.hpp"
#include "cli/plugin_folders.hpp"
#include "cli/results_file.hpp"
#include "cli/results_page.hpp"
#include "cli/stored_tuning.hpp"
#include "cli/study_progress.hpp"
#include "cli/study_run.hpp"
#include "cli/terminal.hpp"
#include "cli/tuned_file.hpp"
#include "config/text.hpp"
#include "report/fingerprint.hpp"
#include "report/tournament.hpp"
#include "report/tuning.hpp"
#include "study/tuning/tuning_setup.hpp"

namespace regista::cli {
namespace {

struct TuneOptions : study::TuningRequest {
  std::string trace, output;  // files; empty: none, beside the results
  bool force = false;         // they may replace files of another kind
};

constexpr auto examples = R"(Examples:
  regista tune configs/studies/tune_paper.yaml
  regista tune configs/studies/tune_paper.yaml --matches 400 --set search.algorithm=spsa
  regista tune configs/studies/tune_paper.yaml --results night.db --resume
  regista tune configs/studies/tune_paper.yaml --compare sbplx,spsa,sep_cma_es,random_search --repeats 9
  regista report night.db --json

The document names a team, opponents, the values that may change, what counts as better, an algorithm and how much is
played; `regista config show` explains its values, docs/tuning.md the method. What the search finds is only a guess: the
best points are played again on other seeds, and the best of these meet the base team on seeds that nobody has chosen by,
in a test that may stop at any pair. The team that comes of it is written beside the results, NAME.tuned.yaml, with
what was found about it in its head, whether or not it was found better.
--compare plays the search of several algorithms with equal numbers of matches, repeated with other seeds, and judges what
each came to on seeds that none has seen; no team is written.
Exit codes: 0 played, whatever was found; 1 interrupted, or the results could not be written; 2 bad input; 3 a defect of
Regista.)";

using Clock = std::chrono::steady_clock;

class Played {
 public:
  Played(const TuneOptions& options, OutputFiles outputs, const Invocation& invocation, study::TuningPlan plan)
      : options_(options),
        outputs_(std::move(outputs)),
        invocation_(invocation),
        plan_(std::move(plan)),
        record_(plan_),
        tuned_file_(options.output.empty() ? tuned_file_beside(options.results)
                                           : std::filesystem::path(options.output)) {
    if (!plan_.compares()) outputs_.write("the tuned team", tuned_file_, Writes::tuned_team);
  }
  Played(const Played&) = delete;
  Played& operator=(const Played&) = delete;

  int play() {
    outputs_.check(options_.force);
    std::optional<OutputFile> trace;
    campaign::Store store = open_results(options_.results, options_.resume, plan_, {});
    if (!options_.trace.empty()) trace.emplace(options_.trace);
    StudyProgress progress(words(), !options_.quiet);
    for (const std::string& each : study::notes_on(plan_)) progress.note("note: " + config::one_line(each));
    try {
      play_study({"tuning", most_matches(plan_), [this] { return counted_; }}, options_, invocation_, store, progress,
                 [&](const PlayRun& play) { study::tune(plan_, hooks(store, play), record_); });
    } catch (const study::TuningError& error) {
      progress.clear();
      throw BadInput(fmt::format("tune: {}", error.what()));
    }
    if (trace) {
      trace->write(report::tuning_csv(view()));
      trace->close();
    }
    std::exception_ptr not_written;
    if (!plan_.compares() && record_.tuned()) {
      try {
        outputs_.check(options_.force);  // hours later, perhaps
        write_tuned_file(tuned_file_, plan_, record_, fingerprint_.text());
        written_ = tuned_file_.string();
      } catch (...) {
        not_written = std::current_exception();  // what was found is told all the same
      }
    }
    print(options_.json ? report::tuning_json(view()) : report::tuning_text(view()));
    if (!options_.no_page) write_page(store);
    if (not_written) std::rethrow_exception(not_written);
    return exit_done;
  }

 private:
  report::TuningView view() const { return {plan_, record_, written_}; }

  void write_page(const campaign::Store& store) const {
    const StudyPlan plan = plan_;
    const auto page = write_page_beside({options_.results, store, plan}, true);
    if (page && !options_.quiet) say(fmt::format("page: {}\n", config::one_line(page->string())));
  }

  study::TuningHooks hooks(campaign::Store& store, const PlayRun& play) {
    study::TuningHooks out;
    out.play = [this, &play](const study::MatchList& list, const study::TakeMatch& take) { play(run(list, take)); };
    const std::optional<std::uint64_t> ended = stored_end_of_search(store);
    const SearchTime before = stored_time_of_search(store);
    out.out_of_time = [this, &store, ended, before,
                       began = std::optional<Clock::time_point>()](std::uint64_t evaluations) mutable {
      if (ended) return evaluations >= *ended;
      // What an earlier run has come to is told, not played: it was in time, and takes none.
      if (!plan_.minutes || evaluations < before.evaluations) return false;
      if (!began) began = Clock::now();
      const double seconds = before.seconds + std::chrono::duration<double>(Clock::now() - *began).count();
      store_time_of_search(store, {evaluations, seconds});
      if (seconds < 60.0 * *plan_.minutes) return false;
      // From here on it is part of the results: however often they are read, the search ends here.
      store_end_of_search(store, evaluations);
      return true;
    };
    return out;
  }

  StudyRun run(const study::MatchList& list, const study::TakeMatch& take) {
    StudyRun out;
    out.matches = list.matches.size();
    out.first_row = list.first_row;
    out.fixtures = list.fixtures;
    out.at = [&list](std::uint64_t index) -> std::optional<StudyRun::Place> {
      const study::MatchList::Match& match = list.matches[index];
      return StudyRun::Place{match.fixture, match.seed};
    };
    out.job = [&list](std::uint64_t index) { return list.job(index); };
    out.take = [this, &list, &take](std::uint64_t index, const campaign::Decided* decided) {
      fingerprint_.take(list.first_row + index, *decided);  // all matches are wanted
      ++counted_;
      last_ = list.job(index);
      return take(index, *decided);
    };
    // Candidates differ in numbers alone: the first match of all speaks for them.
    out.first_of_pairing = [&list](std::uint64_t index) { return list.first_row + index == 0; };
    out.limits = plan_.limits;
    out.metrics = metrics_wanted(plan_);
    return out;
  }

  StudyWords words() const {
    StudyWords out;
    out.matches = most_matches(plan_);
    out.taken = [this] { return counted_; };
    out.standing = [this] { return report::tuning_standing(view()); };
    out.whole = [this] { return counted_ > 0 ? report::tuning_text(view()) : std::string(); };
    out.match = [this](std::uint64_t, const campaign::Decided& decided) { return match_text(decided); };
    return out;
  }

  std::string match_text(const campaign::Decided& decided) const {
    std::string out = record_.stage ? study::name(*record_.stage) : "";
    if (record_.stage == study::TuningStage::search && !plan_.compares()) {
      out += fmt::format(" after {} points", record_.trace.size());
    }
    out += fmt::format(", seed {}: {} {}:{} {}", last_.seed, std::filesystem::path(last_.teams[0]).stem().string(),
                       decided.score[0], decided.score[1], std::filesystem::path(last_.teams[1]).stem().string());
    if (decided.set_aside()) out += ", could not be played: " + decided.why_set_aside;
    if (decided.failure) {
      const auto side = static_cast<std::size_t>(decided.failure->side);
      out += ", " + report::forfeit_text(std::filesystem::path(last_.teams[side]).stem().string(), *decided.failure);
    }
    return config::one_line(out);
  }

  const TuneOptions& options_;
  OutputFiles outputs_;
  const Invocation& invocation_;
  study::TuningPlan plan_;
  study::TuningRecord record_;
  std::filesystem::path tuned_file_;
  std::string written_;
  report::Fingerprint fingerprint_;
  campaign::Job last_;
  std::uint64_t counted_ = 0;
};

int tune(TuneOptions options, OutputFiles outputs, const Invocation& invocation) {
  campaign::check(options);
  if (options.file.empty()) throw BadInput("tune: which one? Name its file; see: regista tune --help");
  const plugin::Catalogue catalogue = open_plugins(options.plugins, invocation);
  study::TuningPlan plan = study::planned_tuning(options, catalogue);
  tell_what_is_not_used(catalogue, options.plugins);
  options.plugin_files = catalogue.used_files();
  if (options.results.empty()) options.results = plan.name + (plan.compares() ? ".compare.db" : ".db");
  outputs.read(folders_of(catalogue), Reads::plugins);
  outputs.write_beside(options.results, options.no_page ? OutputFiles::Page::none : OutputFiles::Page::with_figures);
  return Played(options, std::move(outputs), invocation, std::move(plan)).play();
}

}  // namespace

Command add_tune(CLI::App& parent, const Invocation& invocation) {
  CLI::App& app = *parent.add_subcommand("tune", "search a team's numbers for better ones, and verify what was found");
  const auto options = std::make_shared<TuneOptions>();
  reads(app.add_option("file", options->file, "the tuning's document")->type_name("T.yaml"), Reads::documents);
  app.add_option("--set", options->overrides, "a value laid over that document; may be repeated")
      ->type_name("PATH=VALUE")
      ->allow_extra_args(false);
  app.add_option("--matches", options->matches, "search with so many matches, whatever the document says")
      ->type_name("N");
  app.add_option("--compare", options->compare, "compare these algorithms instead, divided by commas")
      ->type_name("A,B,...");
  app.add_option("--repeats", options->repeats, "of each algorithm that is compared; default 5")->type_name("N");
  writes(app.add_option("--trace", options->trace, "write every point of the search as a table")->type_name("FILE"),
         Writes::search_table);
  writes(app.add_option("--output", options->output,
                        "file for the tuned team; default: NAME.tuned.yaml beside the results")
             ->type_name("FILE"),
         Writes::tuned_team);
  app.add_flag("--force", options->force, "let --trace and the tuned team replace files of another kind")
      ->disable_flag_override();
  add_campaign_options(app, *options, "the tuning's name with .db");
  app.footer(examples);
  return {&app, [options, &app, &invocation] { return tune(*options, OutputFiles(app, "tuning"), invocation); }};
}

}  // namespace regista::cli
