// SPDX-License-Identifier: MIT
#include "cli/prepared_match.hpp"

#include <fmt/format.h>

#include <unistd.h>

#include <array>
#include <chrono>
#include <memory>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "campaign/job_setup.hpp"
#include "campaign/match_json.hpp"
#include "campaign/mathematics.hpp"
#include "cli/common_names.hpp"
#include "cli/live_line.hpp"
#include "cli/replayed_match.hpp"
#include "command/interruption.hpp"
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

namespace regista::cli {
namespace {

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

int play_prepared(const MatchOptions& options, std::vector<std::string> words,
                  const std::optional<results::StoredMatch>& stored, const report::WhatWasPlayed& what,
                  campaign::MatchSetup prepared, campaign::WorkerNote& note) {
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

}  // namespace regista::cli
