// SPDX-License-Identifier: MIT
#include "campaign/play_job.hpp"

#include <fmt/format.h>
#include <regista/extensions/log.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <new>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <utility>

#include "campaign/decision_trail.hpp"
#include "campaign/isolated_match.hpp"
#include "campaign/match_encoding.hpp"
#include "config/errors.hpp"
#include "match/game_state.hpp"
#include "match/teams.hpp"
#include "mcap/file_io.hpp"
#include "plugin/fatal_signal.hpp"
#include "plugin/process_state.hpp"
#include "process/confinement.hpp"
#include "process/file_descriptor.hpp"
#include "recording/match_recording.hpp"

namespace regista::campaign {
namespace {

// The recording of a match of a campaign. An error of the recording does not stop the match.
class JobRecording {
 public:
  JobRecording(const Job& job, const MatchSetup& prepared, const std::array<const mind::TeamPlan*, 2>& plans,
               const std::string& program) {
    // Plugins log to standard error, because the coordinator stores this output with the result of the match.
    observer_.log = mind::to_standard_error(REGISTA_LOG_WARNING, mind::most_kept_of_log);
    observer_.outcomes_alone = job.record.empty();
    if (job.record.empty()) return;
    place_ = job.record;
    const std::string opening = prepared.setup.opening ? prepared.setup.opening->name : "";
    try {
      std::filesystem::create_directories(std::filesystem::path(job.record).parent_path());
      file_.emplace(job.record, recording::RecordedSetup{plans, program, match_command(job), opening, job.seed},
                    recording::MatchRecording::Options{.replace = true, .at_stake = job.expects_failure ? 0.1 : 2.0});
    } catch (const std::filesystem::filesystem_error& error) {
      why_not_ = fmt::format("{}: {}", job.record, error.code().message());
      return;
    } catch (const mcap::Error& error) {
      why_not_ = error.what();
      return;
    }
    observer_.segments = observer_.drawings = true;
    observer_.step = [this](const match::Snapshot& snapshot) { write([&] { file_->stepped(snapshot); }); };
    observer_.event = [this](double time, const match::Event& event, const match::GameState& state) {
      write([&] { file_->event(time, event, state); });
    };
    observer_.play = [this](double time, const match::PlayEvent& event) { write([&] { file_->play(time, event); }); };
    after_ = [this](const mind::Mind& mind, const match::Decision& decision) {
      write([&] { file_->decided(mind, decision); });
    };
  }
  JobRecording(const JobRecording&) = delete;
  JobRecording& operator=(const JobRecording&) = delete;

  const match::Observer* observer() const { return &observer_; }
  const match::AfterDecision& after() const { return after_; }
  // Ends the recording. Returns why a wanted recording is missing; otherwise empty.
  std::string close() {
    write([&] { file_->close(); });
    return why_not_;
  }

 private:
  template <class Write>
  void write(Write write) {
    if (!file_) return;
    try {
      write();
    } catch (const mcap::Error& error) {
      why_not_ = error.what();
      file_.reset();
      // Deletes the unfinished file, because the results need its disk space.
      std::error_code none;
      std::filesystem::remove(place_, none);
    }
  }

  std::filesystem::path place_;
  std::optional<recording::MatchRecording> file_;
  std::string why_not_;
  match::Observer observer_;
  match::AfterDecision after_;
};

// Keeps only variables for the loader and for tools that inspect a process. Sets other values of HOME, LANG and TZ.
void change_environment() {
  constexpr std::array<std::string_view, 4> kept{"PATH=", "LD_", "GCOV", "LLVM_PROFILE"};
  std::vector<std::string> names;
  for (char** each = environ; each != nullptr && *each != nullptr; ++each) {
    const std::string_view variable = *each, name = variable.substr(0, variable.find('='));
    const auto begins = [variable](std::string_view with) { return variable.starts_with(with); };
    if (std::ranges::none_of(kept, begins) && !name.ends_with("SAN_OPTIONS")) names.emplace_back(name);
  }
  for (const std::string& each : names) ::unsetenv(each.c_str());
  ::setenv("HOME", "/", 1);
  ::setenv("LANG", "C", 1);
  ::setenv("TZ", "<+0723>-7:23", 1);
}

// Changes the folder, environment, memory addresses and date of this process. A match must not depend on these.
void perturb_surroundings() {
  std::error_code none;
  std::filesystem::current_path("/", none);
  change_environment();
  // Changes the addresses of later allocations.
  static const std::vector<char> padding(300'007);
  // An offset that changes the year, month, day of the week and hour of the date.
  constexpr std::int64_t earlier = (((417 * 24) + 7) * 60 + 23) * 60 + 19;  // s
  process::set_date_back(earlier);
}

match::Result play_here(const Job& job, MatchSetup& prepared, const std::array<const mind::TeamPlan*, 2>& plans,
                        JobRecording& recording, std::optional<TrailWriter>& trail, WorkerNote& note) {
  match::AfterDecision after = recording.after();
  plugin::CallTrail answers;
  if (trail) {
    after = [&trail, &answers, recorded = recording.after()](const mind::Mind& mind, const match::Decision& decision) {
      if (recorded) recorded(mind, decision);
      trail->add(decision, answers);
      answers.clear();
    };
  }
  plugin::keep_orphans();
  const plugin::ProcessState before = plugin::ProcessState::now();
  const pid_t here = getpid();
  const match::Result result = match::play(std::move(prepared.setup), plans, recording.observer(), after,
                                           {&note.call, 0, job.look, trail ? &answers : nullptr, job.hides});
  if (getpid() != here) _exit(1);  // this is the child of a fork() by a plugin
  note.call = {};                  // so that a later death is not blamed on this call of a plugin
  if (const std::string left = plugin::changes_since(before); !left.empty()) {
    throw std::runtime_error("a plugin " + left);
  }
  return result;
}

Answer failed(const Failure& failure, bool from_outside) {
  return {.kind = Answer::Kind::failed, .decided = {.failure = failure}, .from_outside = from_outside};
}

// Returns the plugins of the job's teams. If each team has a process, this process loads no plugin: a plugin that fails
// must fail in its team's process. If the teams share a process, this process loads the plugins now.
plugin::Catalogue plugins_of(const Job& job, const Surroundings& surroundings) {
  if (job.plugin_files.empty()) return surroundings.open_plugins(job.plugins);
  const std::vector<std::filesystem::path> files(job.plugin_files.begin(), job.plugin_files.end());
  using Looking = plugin::Catalogue::Looking;
  plugin::Catalogue out =
      plugin::Catalogue::of_files(files, job.separation == Separation::teams ? Looking::in_a_child : Looking::here);
  // All plugins were usable when the job was made, so a file has changed since.
  if (!out.refused().empty()) {
    throw config::BadInput(fmt::format("{}; that was not so at the beginning", to_string(out.refused().front())));
  }
  return out;
}

Answer play(const Surroundings& surroundings, WorkerNote& note) {
  const Job job = job_from_json(process::everything_in(STDIN_FILENO));
  if (!job.is_apart()) plugin::note_fatal_signals(note.fatal);
  const plugin::Catalogue catalogue = plugins_of(job, surroundings);
  MatchSetup prepared = match_setup(job, catalogue, KeyNames::former_too);
  // The coordinator uses the same program and mathematics library, so their hashes are taken from the job.
  const std::string changed =
      what_changed(job, prepared, catalogue, input_of(job, program_input), input_of(job, mathematics_input), job.root);
  if (!changed.empty()) return {.kind = Answer::Kind::changed, .message = changed};
  return play_job(job, std::move(prepared), surroundings.program, note);
}

}  // namespace

Answer play_job(const Job& job, MatchSetup prepared, const std::string& program, WorkerNote& note) {
  const std::array<const mind::TeamPlan*, 2> plans{prepared.plans[0].get(), prepared.plans[1].get()};
  PlayedMatch played = match_to_play(prepared);
  JobRecording recording(job, prepared, plans, program);
  std::optional<TrailWriter> trail;
  if (job.trail) trail.emplace(trail_descriptor);
  if (job.perturbed) perturb_surroundings();
  std::string kept;
  try {
    played.result = job.is_apart() ? play_isolated(std::move(prepared.setup), plans, job, trail, note, kept)
                                   : play_here(job, prepared, plans, recording, trail, note);
  } catch (const std::invalid_argument& error) {
    throw config::BadInput(error.what());  // rules, robot and teams do not fit together
  }
  if (trail) trail->flush();
  const std::string not_recorded = recording.close();
  const match::Result& result = played.result;
  return {.kind = Answer::Kind::played,
          .decided = {.score = result.score,
                      .ended = match::name(result.ended),
                      .hash = match::hash_text(result.hash),
                      .metrics = numbers_of(played),
                      .kept = kept},
          .message = not_recorded};
}

Answer answer_of(const std::function<Answer()>& play) {
  try {
    return play();
  } catch (const Fault& fault) {
    return failed(fault.failure, fault.from_outside);
  } catch (const plugin::Failure& failure) {
    const auto& caller = failure.caller();
    if (!caller) return {.message = failure.what()};
    return failed({caller->tracing.side, failure.id(), failure.call(), caller->robot, caller->tick, failure.message()},
                  false);
  } catch (const config::BadInput& error) {
    return {.kind = Answer::Kind::refused, .message = error.what()};
  } catch (const config::Error& error) {
    return {.kind = Answer::Kind::refused, .message = error.what()};
  } catch (const std::bad_alloc&) {
    return {.message = "no memory is left"};
  } catch (const std::exception& error) {
    return {.message = error.what()};
  } catch (...) {
    return {.message = "something that is no exception was thrown"};
  }
}

bool hand_over(const Answer& answer) {
  return process::write_all(answer_descriptor, std::string(answer_mark) + to_json(answer) + '\n');
}

bool play_one(const Surroundings& surroundings) {
  std::optional<SharedNote> note;
  try {
    note.emplace(process::FileDescriptor(note_descriptor));
  } catch (const std::system_error&) {
    throw config::BadInput(
        fmt::format("{}: is for the program itself, which starts it for each match of a tournament", worker_command));
  }
  return hand_over(answer_of([&] { return play(surroundings, **note); }));
}

}  // namespace regista::campaign
