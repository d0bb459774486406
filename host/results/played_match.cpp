// SPDX-License-Identifier: MIT
#include "results/played_match.hpp"

#include <fmt/format.h>

#include <unistd.h>

#include <array>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "campaign/engine.hpp"
#include "campaign/inputs.hpp"
#include "campaign/job_setup.hpp"
#include "campaign/match_json.hpp"
#include "campaign/mathematics.hpp"
#include "command/end_of_program.hpp"
#include "command/interruption.hpp"
#include "command/terminal.hpp"
#include "config/packet_share.hpp"
#include "match/names.hpp"
#include "match/teams.hpp"
#include "mcap/error.hpp"
#include "output/output.hpp"
#include "output/replaced_file.hpp"
#include "plugin/process_state.hpp"
#include "process/program.hpp"
#include "recording/decision_log.hpp"
#include "recording/match_recording.hpp"
#include "report/match_summary.hpp"
#include "texts/message.hpp"

namespace regista::results {

std::string clock_text(double seconds) {
  const auto whole = static_cast<long>(std::floor(seconds));
  return fmt::format("{:02}:{:02}", whole / 60, whole % 60);
}

namespace {

using command::BadInput;
using command::complain;
using command::exit_done;
using command::exit_internal;
using command::exit_no;
using command::Interrupted;

// The course of a match on standard error. On a terminal one line that is rewritten in place: half, clock, score,
// simulated seconds per second, packets left. Elsewhere nothing. Goals as lines of their own when asked for.
class LiveLine {
 public:
  // names: of the teams. live: show the line if standard error is a terminal. goals: a line for each goal.
  LiveLine(std::array<std::string, 2> names, bool live, bool goals);

  void second(double time, const match::GameState& state);
  void event(const match::Event& event, const match::GameState& state);
  void clear() { line_.clear(); }

 private:
  using Clock = std::chrono::steady_clock;
  std::array<std::string, 2> names_;
  bool goals_;
  command::RewrittenLine line_;
  Clock::time_point began_ = Clock::now();
};

LiveLine::LiveLine(std::array<std::string, 2> names, bool live, bool goals)
    : names_(std::move(names)), goals_(goals), line_(live) {}

void LiveLine::second(double time, const match::GameState& state) {
  if (!line_.due()) return;
  const double rate = time / std::chrono::duration<double>(Clock::now() - began_).count();
  line_.show(fmt::format("half {}  {}  {}:{}  {:.0f} s/s  packets left {}, {}", state.half, clock_text(state.clock),
                         state.goals[0], state.goals[1], rate, state.packets_left[0], state.packets_left[1]));
}

void LiveLine::event(const match::Event& event, const match::GameState& state) {
  if (!goals_ || event.kind != match::EventKind::goal) return;
  clear();
  command::say(fmt::format("{}:{}  goal for {} ({}), half {}, {}\n", state.goals[0], state.goals[1],
                           names_[match::index(event.side)], match::name(event.side), state.half,
                           clock_text(state.clock)));
}

std::string interrupted_text(const std::string& again, const match::GameState& state, double time) {
  return fmt::format("interrupted in half {} at {}, {:.0f} s simulated, score {}:{}; the same match again: {}",
                     state.half, clock_text(state.clock), time, state.goals[0], state.goals[1], again);
}

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

report::WhatWasPlayed what_is_played(const campaign::Job& job, const campaign::MatchSetup& prepared,
                                     const plugin::Catalogue& catalogue) {
  const campaign::FoundInputs inputs =
      campaign::inputs_of(prepared, catalogue, campaign::program_hash(), campaign::mathematics_fingerprint());
  config::MatchSettings settings;
  // A name without a file means the built-in profile.
  const auto file_of = [](const std::string& name) { return std::filesystem::exists(name) ? name : std::string(); };
  settings.rules = file_of(job.rules);
  settings.robot = file_of(job.robot);
  settings.limit = prepared.setup.limit;
  // The opening is among the inputs that both teams have.
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

std::string end_in_words(const campaign::Decided& decided) {
  if (decided.set_aside()) return "could not be played: " + decided.why_set_aside;
  if (!decided.failure) return "was played to its end";
  const campaign::Failure& failure = *decided.failure;
  return fmt::format("was forfeited: {}, plugin {}, {}: {}", failure.side == 0 ? "home" : "away", failure.plugin,
                     failure.call, failure.what);
}

int play_failed(const MatchOptions& options, const StoredMatch& stored, campaign::Job job) {
  campaign::Decided now;
  try {
    job.record = options.record;
    job.expects_failure = stored.decided.failure.has_value();
    now = campaign::play_alone(job, stored.limits);
  } catch (const campaign::CampaignError& error) {
    if (error.kind() == campaign::CampaignError::Kind::input) throw BadInput(error.what());
    throw output::WriteError(error.what());
  }
  const bool same_side = now.failure && stored.decided.failure && now.failure->side == stored.decided.failure->side;
  if (same_side || (now.set_aside() && stored.decided.set_aside())) {
    output::print(texts::one_line(fmt::format("row {}, again: {}", options.row, end_in_words(now))) + '\n');
    return exit_done;
  }
  complain(texts::one_line(
      fmt::format("row {} {}; this time it {}", options.row, end_in_words(stored.decided), end_in_words(now))));
  return exit_no;
}

int compare(const MatchOptions& options, const campaign::Decided& stored, const match::Result& played) {
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
  if (!options.record.empty() && !options.force) words.push_back("--force");  // for there is a recording now
  const std::string again = process::shell_line(words);

  campaign::PlayedMatch played;
  played.seed = prepared.setup.seed;
  if (prepared.setup.opening) played.opening = prepared.setup.opening->name;
  played.budget = config::packets(prepared.setup.rules.messages);
  played.packets_share = campaign::packets_share_of(prepared.setup);
  for (const match::Side side : match::both_sides) {
    played.teams[match::index(side)] = plans[match::index(side)]->team().name;
    played.role_names[match::index(side)] = match::role_names(match::roles(*plans[match::index(side)]));
  }

  std::optional<output::OutputFile> decisions;
  std::optional<recording::DecisionLog> log;
  if (!options.decisions.empty()) {
    decisions.emplace(options.decisions);
    log.emplace([&decisions](std::string_view line) { decisions->write(line); }, plans, played.seed);
  }
  std::unique_ptr<recording::MatchRecording> recording;
  if (!options.record.empty()) {
    const std::string command =
        campaign::plain_command(stored ? stored->job : campaign::job_of(options, options.plugins));
    recording = begin_recording(options, {plans, "regista " REGISTA_VERSION, command, played.opening, played.seed});
  }
  LiveLine live(played.teams, !options.quiet, options.verbose);
  const command::Interruption interruption(
      fmt::format("regista: interrupted while a plugin did not return; the same match again: {}\n", again));

  match::Observer observer;
  observer.second = [&](double time, const match::GameState& state) {
    if (interruption.requested()) throw Interrupted(interrupted_text(again, state, time), interruption.signal_number());
    live.second(time, state);
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
  std::optional<campaign::StandardOutputKept> kept(std::in_place);
  plugin::keep_orphans();
  const plugin::ProcessState before = plugin::ProcessState::now();
  std::string left;
  try {
    played.result = match::play(std::move(prepared.setup), plans, &observer, after, {&note.call});
    note.call = {};                              // whatever dies from now on dies in no plugin's call
    if (getpid() != here) _exit(exit_internal);  // a plugin has doubled the process: one of the two is enough
    left = plugin::changes_since(before);
    if (recording) recording->close();
  } catch (const mcap::Error& error) {
    throw output::WriteError(error.what());
  } catch (const std::invalid_argument& error) {
    throw BadInput(error.what());  // profiles and teams that do not go together
  }
  played.wall_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  kept.reset();
  live.clear();
  if (!left.empty()) {
    throw campaign::Disorder("a plugin " + left);
  }
  if (log) decisions->close();
  if (!options.metrics.empty())
    output::write_whole(options.metrics, report::metrics_csv(played), output::Existing::replaced);
  output::print(options.json ? report::summary_json(played, what) : report::summary_text(played, what));
  return stored ? compare(options, stored->decided, played.result) : exit_done;
}

}  // namespace regista::results
