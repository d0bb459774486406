// SPDX-License-Identifier: MIT
// `regista tournament`: which of two teams is better, or how several rank, in pairs of matches with the same seed and
// the sides swapped.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>
#include <stdexcept>
#include <system_error>

#include "campaign/engine.hpp"
#include "cli/command.hpp"
#include "cli/end_of_program.hpp"
#include "cli/interruption.hpp"
#include "cli/output.hpp"
#include "cli/plugin_folders.hpp"
#include "cli/results_page.hpp"
#include "cli/shell.hpp"
#include "cli/terminal.hpp"
#include "cli/tournament_files.hpp"
#include "cli/tournament_options.hpp"
#include "cli/tournament_progress.hpp"
#include "config/text.hpp"
#include "report/tournament.hpp"
#include "study/recording_place.hpp"
#include "study/tournament.hpp"

namespace regista::cli {
namespace {

constexpr auto examples = R"(Examples:
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
Exit codes: 0 played, whatever the verdict; 1 interrupted, or the results could not be written; 2 bad input; 3 a defect
of Regista.)";

class Played {
 public:
  Played(const TournamentOptions& options, const Invocation& invocation, PlannedTournament planned)
      : options_(options),
        invocation_(invocation),
        workers_(number_of_workers(options)),
        record_every_(record_every(options)),
        plan_(std::move(planned.plan)),
        documents_(std::move(planned.documents)),
        course_(plan_),
        view_{plan_, course_, [this](std::uint64_t index) { return again(job(index)); }} {}
  Played(const Played&) = delete;
  Played& operator=(const Played&) = delete;

  int play() {
    campaign::Store store = open_results(options_.results, options_.resume, plan_, documents_);
    const Interruption interruption(fmt::format("regista: interrupted; to go on: {}\n", resume_line()));
    TournamentProgress progress(view_, !options_.quiet);
    progress.begin();
    try {
      numbers_ = store.add(study::fixtures(plan_));
      const campaign::Schedule schedule = schedule_with(progress, interruption);
      const campaign::Finish finish = campaign::run(schedule, store, workers_, plan_.limits);
      progress.clear();
      if (finish == campaign::Finish::interrupted) {
        progress.stopped();
        throw Interrupted(fmt::format("interrupted after {} of {} matches; to go on: {}", course_.matches(),
                                      schedule.matches, resume_line()));
      }
    } catch (const campaign::CampaignError& error) {
      progress.clear();
      if (error.kind() == campaign::CampaignError::Kind::input) {
        throw BadInput(fmt::format("while the tournament was played: {}", error.what()));
      }
      throw WriteError(fmt::format("{}; to go on: {}", error.what(), resume_line()));
    } catch (const campaign::StoreError& error) {
      progress.clear();
      throw WriteError(fmt::format("{}; to go on: {}", error.what(), resume_line()));
    } catch (const std::invalid_argument& error) {
      progress.clear();
      throw BadInput(damaged_metrics(options_.results, error));
    } catch (const std::system_error& error) {
      progress.clear();
      throw WriteError(fmt::format("{}; to go on: {}", error.what(), resume_line()));
    }
    progress.finish();
    print(options_.json ? report::tournament_json(view_) : report::tournament_text(view_));
    if (!options_.no_page) write_page(store);
    return exit_done;
  }

 private:
  void write_page(const campaign::Store& store) const {
    const auto page = write_page_beside({options_.results, store, plan_});
    if (page && !options_.quiet) say(fmt::format("page: {}\n", config::one_line(page->string())));
  }

  campaign::Schedule schedule_with(TournamentProgress& progress, const Interruption& interruption) {
    campaign::Schedule out;
    out.matches = course_.calendar().matches();
    out.at = [this](std::uint64_t index) -> std::optional<campaign::MatchKey> {
      if (!course_.wanted(index)) return std::nullopt;
      const study::Fixture fixture = course_.calendar().at(index);
      return campaign::MatchKey{numbers_[fixture.number], fixture.seed};
    };
    out.job = [this](std::uint64_t index) {
      campaign::Job match = job(index);
      if (record_every_ > 0 && index % record_every_ == 0) match.record = recording(index);
      return match;
    };
    out.record_failure = [this](std::uint64_t index) { return recording(index); };
    out.not_recorded = [this, &progress](const campaign::Job& job, const std::string& why) {
      progress.tell(
          fmt::format("a match was not recorded: {}; it can be played again with --record: {}", why, again(job)));
    };
    out.take = [this, &progress](std::uint64_t index, const campaign::Decided* decided, bool fresh) {
      const bool more = course_.take(decided);
      progress.match(index, decided, fresh);
      return more;
    };
    out.metrics = course_.needs_metrics() ? campaign::Metrics::wanted : campaign::Metrics::left_out;
    out.accident = [this, &progress](const campaign::Job& job, const campaign::End& death) {
      progress.tell(
          fmt::format("a worker died ({}), but not when its match was played again: {}", death.text, again(job)));
    };
    out.asked_to_stop = [&interruption] { return interruption.requested(); };
    return out;
  }

  campaign::Job job(std::uint64_t index) const { return study::job(plan_, course_.calendar().at(index)); }

  std::string recording(std::uint64_t index) const {
    return study::recording_file(options_.results, static_cast<std::int64_t>(index) + 1).string();
  }

  std::string again(const campaign::Job& job) const {
    std::vector<std::string> words = campaign::match_arguments(job);
    words.insert(words.begin(), invocation_.arguments.front());
    return shell_line(words);
  }

  std::string resume_line() const {
    std::vector<std::string> words = invocation_.arguments;
    if (!options_.resume) words.push_back("--resume");
    return shell_line(words);
  }

  const TournamentOptions& options_;
  const Invocation& invocation_;
  int workers_;
  std::uint64_t record_every_;
  study::TournamentPlan plan_;
  std::vector<std::string> documents_;  // of the teams
  study::Tournament course_;
  report::TournamentView view_;
  std::vector<std::int64_t> numbers_;  // of the fixtures, in the store
};

int tournament(const TournamentOptions& options, const Invocation& invocation) {
  const plugin::Catalogue catalogue = open_plugins(options.plugins, invocation);
  PlannedTournament planned = planned_tournament(options, catalogue);
  tell_what_is_not_used(catalogue, options.plugins);
  return Played(options, invocation, std::move(planned)).play();
}

}  // namespace

Command add_tournament(CLI::App& parent, const Invocation& invocation) {
  CLI::App& app = *parent.add_subcommand("tournament", "find out which team is better");
  const auto options = std::make_shared<TournamentOptions>();
  app.add_option("--team", options->teams, "a team's file; to be given twice, or more often")
      ->type_name("FILE")
      ->allow_extra_args(false);
  app.add_option("--format", options->format,
                 "of more than two teams: round-robin (default), or gauntlet: the first "
                 "against each of the others")
      ->type_name("FORMAT");
  app.add_option("--pairs", options->pairs, "play so many pairs of matches of each pairing; with a test: at most")
      ->type_name("N");
  app.add_option("--sprt", options->sprt, "stop when the scores tell a strength of ELO0 from one of ELO1")
      ->type_name("ELO0,ELO1");
  app.add_option("--model", options->model, "what --sprt is in: normalized (default) or logistic Elo")
      ->type_name("MODEL");
  app.add_option("--metric", options->metric,
                 "stop when this differs: goals, or a number of a match such as "
                 "striker.overlap_seconds")
      ->type_name("NAME");
  app.add_option("--alpha", options->alpha, "rate of finding a difference in error; default 0.05")->type_name("RATE");
  app.add_option("--beta", options->beta, "of --sprt: rate of missing it; default 0.05")->type_name("RATE");
  app.add_option("--openings", options->openings, "scenes that matches start from: a file, or a folder of them")
      ->type_name("PATH")
      ->allow_extra_args(false);
  app.add_option("--seed", options->seed, "of the first pair; default 1")->type_name("N");
  app.add_option("--workers", options->workers, "matches at the same time; default: one for each processor core")
      ->type_name("N");
  app.add_option("--limit", options->limit, "end each match after so many simulated seconds")->type_name("SECONDS");
  app.add_option("--rules", options->rules, "rules profile; default: spl2023, built in")->type_name("FILE");
  app.add_option("--robot", options->robot, "robot profile of all teams; default: nao, built in")->type_name("FILE");
  app.add_option("--disturbance", options->disturbance, "disturbance profile; default: none")->type_name("FILE");
  app.add_option("--set", options->overrides, "a value laid over a document; may be repeated")
      ->type_name("PATH=VALUE")
      ->allow_extra_args(false);
  add_plugin_folders(app, options->plugins);
  app.add_option("--results", options->results, "file the results are kept in; default: tournament.db")
      ->type_name("FILE");
  app.add_option("--record-every", options->record_every,
                 "record every N-th match, beside the results in NAME.recordings/ROW.mcap; those that fail always are")
      ->type_name("N");
  app.add_flag("--resume", options->resume, "go on with what the file of results was begun with")
      ->disable_flag_override();
  app.add_option("--failures-in-a-row", options->failures_in_a_row,
                 "set a team aside after so many forfeits by the same plugin; default 10; 0: never")
      ->type_name("N");
  app.add_option("--processor-seconds", options->processor_seconds,
                 "processor time of one call of a plugin; default 10")
      ->type_name("SECONDS");
  app.add_option("--memory", options->memory, "address space of a match; default 2048")->type_name("MIB");
  app.add_flag("--no-page", options->no_page, "write no page NAME.html beside the results NAME.db at the end")
      ->disable_flag_override();
  app.add_flag("--json", options->json, "write the report as JSON")->disable_flag_override();
  app.add_flag("--quiet", options->quiet, "no progress on standard error")->disable_flag_override();
  app.footer(examples);
  return {&app, [options, &invocation] { return tournament(*options, invocation); }};
}

}  // namespace regista::cli
