// SPDX-License-Identifier: MIT
// `regista tournament`: which of two teams is better, or how several rank, in pairs of matches with the same seed and
// the sides swapped.
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
#include "report/tournament.hpp"
#include "study/tournament.hpp"
#include "study/tournament_setup.hpp"

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
  Played(const study::TournamentRequest& options, const Invocation& invocation, study::PlannedTournament planned)
      : options_(options),
        invocation_(invocation),
        plan_(std::move(planned.plan)),
        documents_(std::move(planned.documents)),
        course_(plan_),
        view_{plan_, course_, [this](std::uint64_t index) { return play_again(job(index), invocation_); }} {}
  Played(const Played&) = delete;
  Played& operator=(const Played&) = delete;

  int play() {
    campaign::Store store = open_results(options_.results, options_.resume, plan_, documents_);
    StudyProgress progress(words(), !options_.quiet);
    tell_of_equal_teams(progress);
    play_study({"tournament", plan_.matches(), [this] { return course_.matches(); }}, options_, invocation_, store,
               progress, [&](const PlayRun& play) { play(run()); });
    print(options_.json ? report::tournament_json(view_) : report::tournament_text(view_));
    if (!options_.no_page) write_page(store);
    return exit_done;
  }

 private:
  void write_page(const campaign::Store& store) const {
    const StudyPlan plan = plan_;
    const auto page = write_page_beside({options_.results, store, plan}, false);
    if (page && !options_.quiet) say(fmt::format("page: {}\n", config::one_line(page->string())));
  }

  StudyRun run() {
    StudyRun out;
    out.matches = course_.calendar().matches();
    out.fixtures = study::fixtures(plan_);
    out.at = [this](std::uint64_t index) -> std::optional<StudyRun::Place> {
      if (!course_.wanted(index)) return std::nullopt;
      const study::Fixture fixture = course_.calendar().at(index);
      return StudyRun::Place{fixture.number, fixture.seed};
    };
    out.job = [this](std::uint64_t index) { return job(index); };
    out.take = [this](std::uint64_t, const campaign::Decided* decided) { return course_.take(decided); };
    out.first_of_pairing = [this](std::uint64_t index) {
      const study::Fixture fixture = course_.calendar().at(index);
      return fixture.pair == 0 && !fixture.swapped;
    };
    out.limits = plan_.limits;
    out.metrics = course_.needs_metrics() ? campaign::Metrics::wanted : campaign::Metrics::left_out;
    return out;
  }

  StudyWords words() const {
    StudyWords out;
    out.matches = course_.calendar().matches();
    out.taken = [this] { return course_.taken(); };
    out.standing = [this] { return fmt::format("{}\n{}", report::title(view_), report::standing_text(view_)); };
    out.whole = [this] { return course_.matches() > 0 ? report::tournament_text(view_) : std::string(); };
    out.match = [this](std::uint64_t index, const campaign::Decided& decided) { return match_text(index, decided); };
    return out;
  }

  std::string match_text(std::uint64_t index, const campaign::Decided& decided) const {
    const study::Fixture fixture = course_.calendar().at(index);
    const std::string scene = plan_.openings.empty()
                                  ? ""
                                  : ", " + std::filesystem::path(plan_.openings[fixture.opening].file).stem().string();
    std::string line = fmt::format("seed {}{}: {} {}:{} {}", fixture.seed, scene, plan_.teams[fixture.home].label,
                                   decided.score[0], decided.score[1], plan_.teams[fixture.away].label);
    if (decided.set_aside()) line += ", could not be played: " + config::one_line(decided.why_set_aside);
    if (decided.failure) {
      const std::size_t loser = decided.failure->side == 0 ? fixture.home : fixture.away;
      line += ", " + report::forfeit_text(plan_.teams[loser].label, *decided.failure);
    }
    return line;
  }

  void tell_of_equal_teams(StudyProgress& progress) const {
    for (const study::Pairing& pairing : course_.calendar().pairings()) {
      if (!study::equal_teams(plan_, pairing)) continue;
      progress.note(fmt::format("A/A: {} and {} are equal, so every pair is a draw by construction",
                                plan_.teams[pairing.first].label, plan_.teams[pairing.second].label));
    }
  }

  campaign::Job job(std::uint64_t index) const { return study::job(plan_, course_.calendar().at(index)); }

  const study::TournamentRequest& options_;
  const Invocation& invocation_;
  study::TournamentPlan plan_;
  std::vector<std::string> documents_;  // of the teams
  study::Tournament course_;
  report::TournamentView view_;
};

int tournament(study::TournamentRequest options, OutputFiles outputs, const Invocation& invocation) {
  campaign::check(options);
  const plugin::Catalogue catalogue = open_plugins(options.plugins, invocation);
  study::PlannedTournament planned = study::planned_tournament(options, catalogue);
  tell_what_is_not_used(catalogue, options.plugins);
  options.plugin_files = catalogue.used_files();
  outputs.read(folders_of(catalogue), Reads::plugins);
  outputs.write_beside(options.results, options.no_page ? OutputFiles::Page::none : OutputFiles::Page::alone);
  outputs.check(false);
  return Played(options, invocation, std::move(planned)).play();
}

}  // namespace

Command add_tournament(CLI::App& parent, const Invocation& invocation) {
  CLI::App& app = *parent.add_subcommand("tournament", "find out which team is better");
  const auto options = std::make_shared<study::TournamentRequest>();
  reads(app.add_option("--team", options->teams, "a team's file; to be given twice, or more often")
            ->type_name("FILE")
            ->allow_extra_args(false),
        Reads::documents);
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
  reads(app.add_option("--openings", options->openings, "scenes that matches start from: a file, or a folder of them")
            ->type_name("PATH")
            ->allow_extra_args(false),
        Reads::documents);
  app.add_option("--seed", options->seed, "of the first pair; default 1")->type_name("N");
  app.add_option("--limit", options->limit, "end each match after so many simulated seconds")->type_name("SECONDS");
  reads(app.add_option("--rules", options->rules, "rules profile; default: spl2023, built in")->type_name("FILE"),
        Reads::documents);
  reads(app.add_option("--robot", options->robot, "robot profile of all teams; default: nao, built in")
            ->type_name("FILE"),
        Reads::documents);
  reads(app.add_option("--disturbance", options->disturbance, "disturbance profile; default: none")->type_name("FILE"),
        Reads::documents);
  app.add_option("--set", options->overrides, "a value laid over a document; may be repeated")
      ->type_name("PATH=VALUE")
      ->allow_extra_args(false);
  app.add_option("--failures-in-a-row", options->failures_in_a_row,
                 "set a team aside after so many forfeits by the same plugin; default 10; 0: never")
      ->type_name("N");
  add_campaign_options(app, *options, options->results);
  app.footer(examples);
  return {&app,
          [options, &app, &invocation] { return tournament(*options, OutputFiles(app, "tournament"), invocation); }};
}

}  // namespace regista::cli
