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
#include <span>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "campaign/decision_trail.hpp"
#include "campaign/isolated_match.hpp"
#include "campaign/job_setup.hpp"
#include "campaign/match_json.hpp"
#include "campaign/worker_process.hpp"
#include "config/bad_input.hpp"
#include "match/names.hpp"
#include "match/teams.hpp"
#include "mcap/error.hpp"
#include "plugin/failure.hpp"
#include "plugin/process_state.hpp"
#include "process/date.hpp"
#include "process/descriptor.hpp"
#include "recording/match_recording.hpp"

namespace regista::campaign {
namespace {

// The recording of a match of a campaign: when it cannot be written, the match is played to its end all the same.
class JobRecording {
 public:
  JobRecording(const Job& job, const MatchSetup& prepared, const std::array<const mind::TeamPlan*, 2>& plans,
               const std::string& program) {
    // Whoever started this process keeps it with the match.
    observer_.log = mind::to_standard_error(REGISTA_LOG_WARNING, mind::most_kept_of_log);
    observer_.outcomes_alone = job.record.empty();
    if (job.record.empty()) return;
    place_ = job.record;
    const std::string opening = prepared.setup.opening ? prepared.setup.opening->name : "";
    try {
      std::filesystem::create_directories(std::filesystem::path(job.record).parent_path());
      file_.emplace(job.record, recording::RecordedSetup{plans, program, plain_command(job), opening, job.seed},
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
  // Ends it; why there is none although there should be, else empty.
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
      // The room it takes is needed for the results.
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

// Only what the loader of shared objects and tools that look into a process read stays as it is.
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

// To another place and time: nothing that a match may depend on is there.
void go_elsewhere() {
  std::error_code none;
  std::filesystem::current_path("/", none);
  change_environment();
  // Whatever is allocated from now on lies elsewhere.
  static const std::vector<char> padding(300'007);
  // Another year, month, day of the week and hour.
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
  if (getpid() != here) _exit(1);  // a plugin has doubled the process: one of the two is enough
  note.call = {};                  // whatever dies from now on dies in no plugin's call
  if (const std::string left = plugin::changes_since(before); !left.empty()) {
    throw std::runtime_error("a plugin " + left);
  }
  return result;
}

match::Result play_isolated(const Job& job, MatchSetup& prepared, const std::array<const mind::TeamPlan*, 2>& plans,
                            std::optional<TrailWriter>& trail, WorkerNote& note, std::string& kept) {
  AfterAnswers after;
  if (trail) {
    after = [&trail](const match::Decision& decision, std::span<const plugin::CallAnswer> answers) {
      trail->add(decision, answers);
    };
  }
  const bool alone = job.separation == Separation::robots;
  return play_isolated(std::move(prepared.setup), plans, job.separation, job.limits,
                       {job.look, job.hides, trail.has_value(), alone}, after, note, kept);
}

Answer failed(const plugin::Failure& failure) {
  Answer answer;
  if (!failure.caller()) {
    answer.message = failure.what();
    return answer;
  }
  answer.kind = Answer::Kind::failed;
  answer.decided.failure = Failure{failure.caller()->noting.side, failure.id(),           failure.call(),
                                   failure.caller()->robot,       failure.caller()->tick, failure.message()};
  return answer;
}

Answer refused(const char* why) {
  Answer answer;
  answer.kind = Answer::Kind::refused;
  answer.message = why;
  return answer;
}

Answer failed(const Fault& fault) {
  Answer answer;
  answer.kind = Answer::Kind::failed;
  answer.decided.failure = fault.failure();
  answer.from_outside = fault.from_outside();
  return answer;
}

}  // namespace

Answer play_job(const Job& job, MatchSetup prepared, const std::string& program, WorkerNote& note) {
  const std::array<const mind::TeamPlan*, 2> plans{prepared.plans[0].get(), prepared.plans[1].get()};
  PlayedMatch played;
  played.seed = job.seed;
  played.packets_share = packets_share_of(prepared.setup);
  for (const match::Side side : match::both_sides) {
    played.teams[match::index(side)] = plans[match::index(side)]->team().name;
    played.role_names[match::index(side)] = match::role_names(match::roles(*plans[match::index(side)]));
  }
  JobRecording recording(job, prepared, plans, program);
  std::optional<TrailWriter> trail;
  if (job.trail) trail.emplace(trail_descriptor);
  if (job.elsewhere) go_elsewhere();
  std::string kept;
  try {
    played.result = job.is_apart() ? play_isolated(job, prepared, plans, trail, note, kept)
                                   : play_here(job, prepared, plans, recording, trail, note);
  } catch (const std::invalid_argument& error) {
    throw config::BadInput(error.what());  // profiles and teams that do not go together
  }
  if (trail) trail->close();
  Answer answer;
  answer.kind = Answer::Kind::played;
  answer.message = recording.close();
  answer.decided.score = played.result.score;
  answer.decided.ended = match::name(played.result.ended);
  answer.decided.hash = match::hash_text(played.result.hash);
  answer.decided.metrics = numbers_of(played);
  answer.decided.kept = kept;
  return answer;
}

Answer answer_of(const std::function<Answer()>& play) {
  try {
    return play();
  } catch (const Fault& fault) {
    return failed(fault);
  } catch (const plugin::Failure& failure) {
    return failed(failure);
  } catch (const config::BadInput& error) {
    return refused(error.what());
  } catch (const config::Error& error) {
    return refused(error.what());
  } catch (const std::bad_alloc&) {
    Answer answer;
    answer.message = "no memory is left";
    return answer;
  } catch (const std::exception& error) {
    Answer answer;
    answer.message = error.what();
    return answer;
  } catch (...) {
    Answer answer;
    answer.message = "something that is no exception was thrown";
    return answer;
  }
}

bool hand_over(const Answer& answer) {
  return process::write_all(answer_descriptor, std::string(answer_mark) + to_json(answer) + '\n');
}

}  // namespace regista::campaign
