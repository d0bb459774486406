// SPDX-License-Identifier: MIT
#include "results/played_match.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <utility>

#include "campaign/engine.hpp"
#include "campaign/match_encoding.hpp"
#include "command/terminal.hpp"
#include "config/overlay.hpp"
#include "config/scalar.hpp"
#include "match/game_state.hpp"
#include "match/teams.hpp"
#include "mcap/file_io.hpp"
#include "output/replaced_file.hpp"
#include "plugin/process_state.hpp"
#include "process/child.hpp"
#include "process/file_descriptor.hpp"
#include "recording/decision_log.hpp"
#include "recording/match_recording.hpp"
#include "report/match_summary.hpp"
#include "results/results_file.hpp"
#include "texts/message.hpp"

namespace regista::results {
namespace {

using command::BadInput;
using command::complain;
using command::exit_done;
using command::exit_internal;
using command::exit_no;
using command::Interrupted;

// Shows the progress of a match on standard error. On a terminal, the class rewrites one line in place: half, clock,
// score, simulated seconds per second, and packets left. If requested, each goal has a line of its own.
class LiveLine {
 public:
  // names: of the teams. live: show the line if standard error is a terminal. goals: print a line for each goal.
  LiveLine(std::array<std::string, 2> names, bool live, bool goals)
      : names_(std::move(names)), goals_(goals), line_(live) {}

  void second(double time, const match::GameState& state) {
    if (!line_.due()) return;
    const double rate = time / std::chrono::duration<double>(Clock::now() - began_).count();
    line_.show(fmt::format("half {}  {}  {}:{}  {:.0f} s/s  packets left {}, {}", state.half, clock_text(state.clock),
                           state.goals[0], state.goals[1], rate, state.packets_left[0], state.packets_left[1]));
  }
  void event(const match::Event& event, const match::GameState& state) {
    if (!goals_ || event.kind != match::EventKind::goal) return;
    clear();
    command::say(fmt::format("{}:{}  goal for {} ({}), half {}, {}\n", state.goals[0], state.goals[1],
                             names_[match::index(event.side)], match::name(event.side), state.half,
                             clock_text(state.clock)));
  }
  void clear() { line_.clear(); }

 private:
  using Clock = std::chrono::steady_clock;
  std::array<std::string, 2> names_;
  bool goals_;
  command::RewrittenLine line_;
  Clock::time_point began_ = Clock::now();
};

std::unique_ptr<recording::MatchRecording> begin_recording(const MatchOptions& options,
                                                           const recording::RecordedSetup& setup) {
  try {
    return std::make_unique<recording::MatchRecording>(
        options.record, setup, recording::MatchRecording::Options{.replace = options.force, .background = true});
  } catch (const mcap::Error& error) {
    throw BadInput(fmt::format("--record: {}", error.what()));
  }
}

}  // namespace

StoredMatch read_stored_match(const std::string& results, const std::string& row,
                              std::span<const StudyKind> kinds) try {
  const campaign::Store store = read_results(results);
  const auto report = stored_study(results, store, {}, kinds);
  study::Study& study = report->study();
  const std::uint64_t number = config::parse_whole("--row", row, 1, study.most_matches());
  auto played = stored_match(store, study, number);
  if (!played) throw BadInput(fmt::format("--row {}: this match of {} has not been played", number, results));
  const std::string file = std::filesystem::absolute(results).string();
  enter_folder("--from " + results, study.folder());
  return {file, row, std::move(played->job), std::move(played->decided), study.limits()};
} catch (const campaign::StoreError& error) {
  throw BadInput(error.what());
}

std::unique_ptr<campaign::StoredSetup> set_up(const StoredMatch& stored, const plugin::Catalogue& catalogue,
                                              const std::string& program, Changed changed) try {
  auto out = std::make_unique<campaign::StoredSetup>(stored.job, catalogue,
                                                     [&] { return read_results(stored.results).documents(); });
  if (out->missing().empty() || (changed == Changed::played && out->playable())) return out;
  throw BadInput(fmt::format("--row {}: was played with something else: {}; as things are now it would be: {}",
                             stored.row, out->missing(), campaign::match_command(stored.job, program)));
} catch (const std::system_error& error) {
  throw output::WriteError(fmt::format("the files of the match cannot be laid out again: {}", error.what()));
} catch (const std::invalid_argument& error) {
  throw BadInput(fmt::format("results in {} are damaged: {}", stored.results, error.what()));
} catch (const campaign::StoreError& error) {
  throw BadInput(error.what());
}

campaign::MatchResult play_by_workers(const StoredMatch& stored, campaign::Job job) try {
  job.expects_failure = stored.decided.failure.has_value();
  return campaign::play_alone(job, stored.limits);
} catch (const campaign::CampaignError& error) {
  if (error.kind == campaign::CampaignError::Kind::input) throw BadInput(error.what());
  throw output::WriteError(error.what());
} catch (const std::system_error& error) {
  throw output::WriteError(error.what());
}

bool came_out_alike(const campaign::MatchResult& stored, const campaign::MatchResult& now) {
  if (stored.failure || now.failure) return stored.failure && now.failure && stored.failure->side == now.failure->side;
  if (stored.set_aside() || now.set_aside()) return stored.set_aside() && now.set_aside();
  return stored.hash == now.hash;
}

std::string clock_text(double seconds) {
  const auto whole = static_cast<long>(std::floor(seconds));
  return fmt::format("{:02}:{:02}", whole / 60, whole % 60);
}

campaign::Job job_of(const MatchOptions& options) {
  campaign::Job job;
  static_cast<campaign::MatchConditions&>(job) = options;
  job.teams = {options.teams.at(0), options.teams.at(1)};
  for (const config::Override& each : config::typed_overrides(options.set)) job.overrides.push_back(to_string(each));
  job.plugins = options.plugins;
  job.seed = config::parse_whole("--seed", options.seed, 0, UINT64_MAX);
  return job;
}

report::WhatWasPlayed what_is_played(const campaign::Job& job, const campaign::MatchSetup& prepared,
                                     const plugin::Catalogue& catalogue) {
  const campaign::FoundInputs inputs =
      campaign::inputs_of(prepared, catalogue, campaign::program_hash(), campaign::mathematics_fingerprint());
  config::MatchSettings settings;
  // If no file has the name of a profile, the profile is built in.
  const auto file_of = [](const std::string& name) { return std::filesystem::exists(name) ? name : std::string(); };
  settings.rules = file_of(job.rules);
  settings.robot = file_of(job.robot);
  settings.limit = prepared.setup.limit;
  // Both teams have the opening as an input.
  std::vector<campaign::Input> openings;
  if (prepared.setup.opening) openings.push_back(campaign::opening_input(*prepared.setup.opening));
  report::WhatWasPlayed out = report::what_was_played(settings, inputs.common, openings);
  out.inputs = inputs.common;
  for (const std::size_t side : {0u, 1u}) {
    const std::string& own = side == 0 ? job.home_disturbance : job.away_disturbance;
    out.teams.push_back(
        report::played_team(prepared.plans[side]->team().name, job.teams[side], side == 0 ? inputs.home : inputs.away,
                            report::profile_of(inputs.common, side == 0 ? "home disturbance" : "away disturbance",
                                               file_of(own.empty() ? job.disturbance : own))));
  }
  out.set = job.overrides;
  out.amount = fmt::format("seed {}", job.seed);
  out.limits.clear();
  out.program = REGISTA_VERSION;
  out.folder = std::filesystem::current_path().string();
  out.plugins = job.plugins;
  return out;
}

std::string end_in_words(const campaign::MatchResult& decided) {
  if (decided.set_aside()) return "could not be played: " + decided.why_set_aside;
  if (!decided.failure) return "was played to its end";
  const campaign::Failure& failure = *decided.failure;
  return fmt::format("was forfeited: {}, plugin {}, {}: {}", failure.side == 0 ? "home" : "away", failure.plugin,
                     failure.call, failure.what);
}

int play_failed(const MatchOptions& options, const StoredMatch& stored, campaign::Job job) {
  job.record = options.record;
  const campaign::MatchResult now = play_by_workers(stored, std::move(job));
  if ((now.failure || now.set_aside()) && came_out_alike(stored.decided, now)) {
    output::print(texts::one_line(fmt::format("row {}, again: {}", options.row, end_in_words(now))) + '\n');
    return exit_done;
  }
  complain(texts::one_line(
      fmt::format("row {} {}; this time it {}", options.row, end_in_words(stored.decided), end_in_words(now))));
  return exit_no;
}

int compare(const MatchOptions& options, const campaign::MatchResult& stored, const match::Result& played) {
  const std::string hash = match::hash_text(played.hash);
  if (hash != stored.hash) {
    complain(
        fmt::format("row {} has the hash {}, this match {}: they are not the same", options.row, stored.hash, hash));
    return exit_no;
  }
  if (!options.quiet) complain(fmt::format("the same match as row {}: hash {}", options.row, hash));
  return exit_done;
}

int play_prepared(const MatchOptions& options, std::vector<std::string> words, const std::optional<StoredMatch>& stored,
                  const report::WhatWasPlayed& what, campaign::MatchSetup prepared, campaign::WorkerNote& note) {
  const std::array<const mind::TeamPlan*, 2> plans{prepared.plans[0].get(), prepared.plans[1].get()};
  if (!options.record.empty() && !options.force) words.push_back("--force");  // a replay must replace the new recording
  const std::string again = process::shell_line(words);

  campaign::PlayedMatch played = campaign::match_to_play(prepared);
  std::optional<output::OutputFile> decisions;
  std::optional<recording::DecisionLog> log;
  if (!options.decisions.empty()) {
    decisions.emplace(options.decisions);
    log.emplace([&decisions](std::string_view line) { decisions->write(line); }, plans, played.seed);
  }
  std::unique_ptr<recording::MatchRecording> recording;
  if (!options.record.empty()) {
    const std::string command = campaign::match_command(stored ? stored->job : job_of(options));
    recording = begin_recording(options, {plans, "regista " REGISTA_VERSION, command, played.opening, played.seed});
  }
  LiveLine live(played.teams, !options.quiet, options.verbose);
  const command::Interruption interruption(
      fmt::format("regista: interrupted while a plugin did not return; the same match again: {}\n", again));

  match::Observer observer;
  observer.second = [&](double time, const match::GameState& state) {
    if (!interruption.requested()) return live.second(time, state);
    throw Interrupted(
        fmt::format("interrupted in half {} at {}, {:.0f} s simulated, score {}:{}; the same match again: {}",
                    state.half, clock_text(state.clock), time, state.goals[0], state.goals[1], again),
        interruption.signal_number());
  };
  observer.event = [&](double time, const match::Event& event, const match::GameState& state) {
    live.event(event, state);
    if (log) log->event(time, event, state);
    if (recording) recording->event(time, event, state);
  };
  if (const std::optional<std::int32_t> least = mind::level_of(options.log)) {
    observer.log = {*least, [&live, show = mind::to_standard_error(*least)](const mind::LogLine& line) {
                      live.clear();
                      show.tell(line);
                    }};
  }
  match::AfterDecision after;
  if (log || recording) {
    observer.segments = true;
    observer.drawings = recording != nullptr;
    observer.step = [&](const match::Snapshot& snapshot) {
      if (log) log->stepped(snapshot);
      if (recording) recording->stepped(snapshot);
    };
    if (recording) {
      observer.play = [&](double time, const match::PlayEvent& event) { recording->play(time, event); };
    }
    after = [&](const mind::Mind& mind, const match::Decision& decision) {
      if (log) log->decided(mind, decision);
      if (recording) recording->decided(mind, decision);
    };
  }

  const auto began = std::chrono::steady_clock::now();
  const pid_t here = getpid();
  std::optional<process::RedirectedStream> kept(std::in_place, STDOUT_FILENO, STDERR_FILENO);
  plugin::keep_orphans();
  const plugin::ProcessState before = plugin::ProcessState::now();
  std::string left;
  try {
    played.result = match::play(std::move(prepared.setup), plans, &observer, after, {&note.call});
    note.call = {};                              // from here on, a crash belongs to no plugin call
    if (getpid() != here) _exit(exit_internal);  // a plugin has forked the process: the child must not continue
    left = plugin::changes_since(before);
    if (recording) recording->close();
  } catch (const mcap::Error& error) {
    throw output::WriteError(error.what());
  } catch (const std::invalid_argument& error) {
    throw BadInput(error.what());  // profiles and teams do not fit together
  }
  played.wall_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  kept.reset();
  live.clear();
  if (!left.empty()) {
    throw campaign::LeftoverState("a plugin " + left);
  }
  if (log) decisions->close();
  if (!options.metrics.empty())
    output::write_whole(options.metrics, report::metrics_csv(played), output::Existing::replaced);
  output::print(options.json ? report::summary_json(played, what) : report::summary_text(played, what));
  return stored ? compare(options, stored->decided, played.result) : exit_done;
}

}  // namespace regista::results
