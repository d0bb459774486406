// SPDX-License-Identifier: MIT
// `regista tournament`: two teams against each other, in pairs of matches with the same seed and the sides swapped.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <charconv>
#include <memory>
#include <optional>
#include <system_error>
#include <thread>

#include "campaign/engine.hpp"
#include "campaign/inputs.hpp"
#include "campaign/mathematics.hpp"
#include "cli/command.hpp"
#include "cli/end_of_program.hpp"
#include "cli/interruption.hpp"
#include "cli/match_setup.hpp"
#include "cli/output.hpp"
#include "cli/plugin_folders.hpp"
#include "cli/shell.hpp"
#include "cli/tournament_files.hpp"
#include "cli/tournament_progress.hpp"
#include "cli/tournament_report.hpp"
#include "config/text.hpp"
#include "study/tournament.hpp"

namespace regista::cli {
namespace {

constexpr auto examples = R"(Examples:
  regista tournament --team configs/teams/paper.yaml --team configs/teams/fixed_rate.yaml --pairs 100
  regista tournament --team a.yaml --team b.yaml --pairs 500 --limit 120 --results night.db
  regista tournament --team a.yaml --team b.yaml --pairs 500 --limit 120 --results night.db --resume
  regista tournament --team a.yaml --team a.yaml --pairs 50 --set b.utility.terms.distance.weight=0.5

A pair is two matches with the same seed and the sides swapped; pair k has the seed of --seed plus k - 1.
A path of --set begins with a (the first team), b, rules, robot or disturbance; without one of these it goes to both
teams. Each match runs in a process of its own: a plugin that crashes, hangs or takes all memory forfeits its match 0:10.
That keeps accidents apart; it is no protection from malice.
Exit codes: 0 played; 1 interrupted, or the results could not be written; 2 bad input; 3 a defect of Regista.)";

constexpr std::array<std::size_t, 2> orders{0, 1};  // A at home, B at home
constexpr std::uint64_t most_pairs = 10'000'000;

struct Options {
  std::vector<std::string> teams, plugins, overrides;
  std::string rules, robot, disturbance, limit;
  std::string pairs, seed = "1", workers, results = "tournament.db";
  std::string processor_seconds = "120", memory = "2048";
  bool resume = false, json = false, quiet = false;
};

std::uint64_t whole_number(const std::string& text, const char* option, std::uint64_t least, std::uint64_t most) {
  std::uint64_t value = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || rest != end || value < least || value > most) {
    throw BadInput(
        fmt::format("{}: {}; a whole number from {} to {} is wanted", option, config::in_quotes(text), least, most));
  }
  return value;
}

int number_of_workers(const Options& options) {
  if (options.workers.empty()) return static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1u, 1024u));
  return static_cast<int>(whole_number(options.workers, "--workers", 1, 1024));
}

campaign::Limits limits_of(const Options& options) {
  campaign::Limits limits;
  limits.processor_seconds =
      static_cast<int>(whole_number(options.processor_seconds, "--processor-seconds", 1, 1'000'000));
  limits.memory = whole_number(options.memory, "--memory", 64, std::uint64_t{1} << 24) << 20;
  // A machine may have much else to do: only a plugin that sleeps comes here.
  limits.wall_seconds = 10.0 * limits.processor_seconds + 100.0;
  return limits;
}

// Values of --set as a match between them understands them; a_side: the side of the first team.
std::vector<std::string> overrides_of_match(const std::vector<std::string>& typed, match::Side a_side) {
  std::vector<std::string> out;
  for (const std::string& each : typed) {
    for (const match::Side side : match::both_sides) {
      if (each.starts_with(std::string(match::name(side)) + '.')) {
        throw BadInput(
            fmt::format("--set {}: in a tournament each team plays on both sides; begin the path with a or b",
                        config::one_line(each)));
      }
    }
    if (each.starts_with("a."))
      out.push_back(match::name(a_side) + each.substr(1));
    else if (each.starts_with("b."))
      out.push_back(match::name(match::opposite(a_side)) + each.substr(1));
    else
      out.push_back(each);
  }
  return out;
}

campaign::Job job_of(const Options& options, bool swapped) {
  campaign::Job job;
  job.teams = {options.teams[swapped ? 1 : 0], options.teams[swapped ? 0 : 1]};
  job.rules = options.rules;
  job.robot = options.robot;
  job.disturbance = options.disturbance;
  job.overrides = overrides_of_match(options.overrides, swapped ? match::Side::away : match::Side::home);
  job.plugins = options.plugins;
  job.limit = options.limit;
  return job;
}

MatchSetup setup_of(const campaign::Job& job, const plugin::Catalogue& catalogue) {
  MatchRequest request;
  request.teams.assign(job.teams.begin(), job.teams.end());
  request.rules = job.rules;
  request.robot = job.robot;
  request.disturbance = job.disturbance;
  request.overrides = job.overrides;
  request.limit = job.limit;
  try {
    return match_setup(request, catalogue);
  } catch (const config::Error& error) {
    // As it was typed.
    std::string text = error.what();
    for (const auto& [side, team] : {std::pair{"--set home.", "--set a."}, {"--set away.", "--set b."}}) {
      if (text.starts_with(side)) text.replace(0, std::string_view(side).size(), team);
    }
    throw BadInput(text);
  }
}

// What teams are called: their names, or their files where these are the same.
std::array<std::string, 2> labels_of(const MatchSetup& prepared, const Options& options) {
  const std::string &a = prepared.plans[0]->team().name, &b = prepared.plans[1]->team().name;
  if (a != b) return {a, b};
  if (options.teams[0] != options.teams[1]) {
    return {fmt::format("{} ({})", a, options.teams[0]), fmt::format("{} ({})", b, options.teams[1])};
  }
  return {a + " (a)", b + " (b)"};
}

class Tournament {
 public:
  Tournament(const Options& options, const Invocation& invocation)
      : options_(options),
        invocation_(invocation),
        jobs_{job_of(options, false), job_of(options, true)},
        workers_(number_of_workers(options)),
        limits_(limits_of(options)) {
    plan_.files = {options.teams[0], options.teams[1]};
    plan_.pairs = whole_number(options.pairs, "--pairs", 1, most_pairs);
    plan_.first_seed = parse_seed(options.seed, "--seed");
    if (plan_.first_seed > UINT64_MAX - (plan_.pairs - 1)) {
      throw BadInput(fmt::format("--seed {}: {} pairs from there would need seeds beyond {}", options.seed, plan_.pairs,
                                 UINT64_MAX));
    }
    prepare();
  }

  int play() {
    campaign::Store store = open_results(options_.results, options_.resume, plan_);
    const Interruption interruption(fmt::format("regista: interrupted; to go on: {}\n", resume_line()));
    TournamentProgress progress(played_.labels, 2 * plan_.pairs, !options_.quiet);
    study::Tally tally;
    std::uint64_t stored = 0;

    campaign::Schedule schedule;
    schedule.matches = 2 * plan_.pairs;
    schedule.at = [&](std::uint64_t index) { return at(index); };
    schedule.take = [&](std::uint64_t index, const campaign::Decided& decided, bool fresh) {
      tally.add(decided);
      stored += fresh ? 0 : 1;
      progress.match(index, study::fixture(index, plan_.first_seed), decided, fresh, tally.standing());
      return true;
    };
    schedule.accident = [&](const campaign::Job& job, const campaign::End& death) {
      progress.tell(
          fmt::format("a worker died ({}), but not when its match was played again: {}", death.text, again(job)));
    };
    schedule.asked_to_stop = [&] { return interruption.requested(); };
    try {
      add_fixtures(store);
      const campaign::Finish finish = campaign::run(schedule, store, workers_, limits_);
      progress.clear();
      if (finish == campaign::Finish::interrupted) {
        throw Interrupted(fmt::format("interrupted after {} of {} matches; to go on: {}", tally.standing().games(),
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
    } catch (const std::system_error& error) {
      progress.clear();
      throw WriteError(fmt::format("{}; to go on: {}", error.what(), resume_line()));
    }
    if (stored > 0 && !options_.quiet) {
      fmt::print(stderr, "{} of {} matches were played before\n", stored, schedule.matches);
    }
    played_.standing = tally.standing();
    print(options_.json ? tournament_json(played_) : tournament_text(played_));
    return exit_done;
  }

 private:
  void prepare() {
    const plugin::Catalogue catalogue = open_plugins(options_.plugins, invocation_);
    const MatchSetup prepared = setup_of(jobs_[0], catalogue);
    tell_what_is_not_used(catalogue, options_.plugins);
    for (const std::size_t team : orders) {
      plan_.teams[team] = campaign::team_inputs(*prepared.plans[team], prepared.documents[team], catalogue);
    }
    plan_.common =
        campaign::common_inputs(prepared.setup, campaign::program_hash(), campaign::mathematics_fingerprint());
    for (const std::size_t order : orders) {
      jobs_[order].home_inputs = plan_.teams[order];
      jobs_[order].away_inputs = plan_.teams[1 - order];
      jobs_[order].common_inputs = plan_.common;
    }
    played_.labels = labels_of(prepared, options_);
    played_.equal_teams = campaign::fixture_key(plan_.teams[0], plan_.teams[1], {}) ==
                          campaign::fixture_key(plan_.teams[1], plan_.teams[0], {});
    played_.pairs = plan_.pairs;
    played_.first_seed = plan_.first_seed;
    played_.again = [this](std::uint64_t index) { return again(at(index).job); };
  }

  void add_fixtures(campaign::Store& store) {
    for (const std::size_t order : orders) {
      fixtures_[order] = store.fixture(campaign::fixture_key(plan_.teams[order], plan_.teams[1 - order], plan_.common),
                                       shell_line(campaign::match_arguments(jobs_[order])));
    }
  }

  campaign::Scheduled at(std::uint64_t index) const {
    const study::Fixture fixture = study::fixture(index, plan_.first_seed);
    const std::size_t order = fixture.swapped ? 1 : 0;
    campaign::Scheduled out{jobs_[order], fixtures_[order]};
    out.job.seed = fixture.seed;
    return out;
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

  const Options& options_;
  const Invocation& invocation_;
  std::array<campaign::Job, 2> jobs_;  // A at home, B at home
  std::array<std::int64_t, 2> fixtures_{};
  int workers_;
  campaign::Limits limits_;
  TournamentPlan plan_;
  PlayedTournament played_;
};

int tournament(const Options& options, const Invocation& invocation) {
  if (options.teams.size() != 2) {
    throw BadInput(
        fmt::format("tournament: two teams are wanted, each by --team FILE; {} given", options.teams.size()));
  }
  if (options.pairs.empty()) throw BadInput("tournament: how many pairs of matches? Say --pairs N");
  return Tournament(options, invocation).play();
}

}  // namespace

Command add_tournament(CLI::App& parent, const Invocation& invocation) {
  CLI::App& app = *parent.add_subcommand("tournament", "find out which of two teams is better");
  const auto options = std::make_shared<Options>();
  app.add_option("--team", options->teams, "a team's file; to be given twice")
      ->type_name("FILE")
      ->allow_extra_args(false);
  app.add_option("--pairs", options->pairs, "play so many pairs of matches")->type_name("N");
  app.add_option("--seed", options->seed, "of the first pair; default 1")->type_name("N");
  app.add_option("--workers", options->workers, "matches at the same time; default: one for each processor core")
      ->type_name("N");
  app.add_option("--limit", options->limit, "end each match after so many simulated seconds")->type_name("SECONDS");
  app.add_option("--rules", options->rules, "rules profile; default: spl2023, built in")->type_name("FILE");
  app.add_option("--robot", options->robot, "robot profile of both teams; default: nao, built in")->type_name("FILE");
  app.add_option("--disturbance", options->disturbance, "disturbance profile; default: none")->type_name("FILE");
  app.add_option("--set", options->overrides, "a value laid over a document; may be repeated")
      ->type_name("PATH=VALUE")
      ->allow_extra_args(false);
  add_plugin_folders(app, options->plugins);
  app.add_option("--results", options->results, "file the results are kept in; default: tournament.db")
      ->type_name("FILE");
  app.add_flag("--resume", options->resume, "go on with what the file of results was begun with")
      ->disable_flag_override();
  app.add_option("--processor-seconds", options->processor_seconds, "processor time of a match; default 120")
      ->type_name("SECONDS");
  app.add_option("--memory", options->memory, "address space of a match; default 2048")->type_name("MIB");
  app.add_flag("--json", options->json, "write the report as JSON")->disable_flag_override();
  app.add_flag("--quiet", options->quiet, "no progress on standard error")->disable_flag_override();
  app.footer(examples);
  return {&app, [options, &invocation] { return tournament(*options, invocation); }};
}

}  // namespace regista::cli
