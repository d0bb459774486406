// SPDX-License-Identifier: MIT
// `regista play-one`, hidden: a worker of a campaign. See campaign/worker.hpp.
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cerrno>
#include <filesystem>
#include <new>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "campaign/inputs.hpp"
#include "campaign/worker.hpp"
#include "cli/command.hpp"
#include "cli/end_of_program.hpp"
#include "cli/job_setup.hpp"
#include "cli/match_report.hpp"
#include "cli/match_setup.hpp"
#include "cli/plugin_folders.hpp"
#include "config/text.hpp"
#include "match/names.hpp"
#include "match/teams.hpp"
#include "mcap/error.hpp"
#include "plugin/failure.hpp"
#include "report/match_recording.hpp"

namespace regista::cli {
namespace {

using campaign::Answer;

std::string everything_from(int descriptor) {
  std::string out;
  std::array<char, 4096> buffer;
  for (;;) {
    const ssize_t count = read(descriptor, buffer.data(), buffer.size());
    if (count == -1 && errno == EINTR) continue;
    if (count <= 0) return out;
    out.append(buffer.data(), static_cast<std::size_t>(count));
  }
}

bool write_all(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t count = write(descriptor, text.data(), text.size());
    if (count == -1 && errno == EINTR) continue;
    if (count == -1) return false;
    text.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

// What a row keeps beside the score: the summary of the match without what changes from run to run.
std::string metrics_of(const PlayedMatch& played) {
  auto json = nlohmann::ordered_json::parse(summary_json(played));
  json.erase("wall_seconds");
  json.erase("failures");
  return json.dump();
}

// The recording of a match of a campaign: when it cannot be written, the match is played to its end all the same.
class Recording {
 public:
  Recording(const campaign::Job& job, const MatchSetup& prepared, const std::array<const mind::TeamPlan*, 2>& plans) {
    if (job.record.empty()) return;
    place_ = job.record;
    const std::string opening = prepared.setup.opening ? prepared.setup.opening->name : "";
    try {
      std::filesystem::create_directories(std::filesystem::path(job.record).parent_path());
      file_.emplace(job.record,
                    report::RecordedSetup{plans, "regista " REGISTA_VERSION, plain_command(job), opening, job.seed},
                    report::MatchRecording::Options{.replace = true, .at_stake = job.expects_failure ? 0.1 : 2.0});
    } catch (const std::filesystem::filesystem_error& error) {
      why_not_ = fmt::format("{}: {}", job.record, error.code().message());
      return;
    } catch (const mcap::Error& error) {
      why_not_ = error.what();
      return;
    }
    observer_.step = [this](const match::Snapshot& snapshot) { write([&] { file_->stepped(snapshot); }); };
    observer_.event = [this](double time, const match::Event& event, const match::GameState& state) {
      write([&] { file_->event(time, event, state); });
    };
    after_ = [this](const mind::Mind& mind, const match::Decision& decision) {
      write([&] { file_->decided(mind, decision); });
    };
  }
  Recording(const Recording&) = delete;
  Recording& operator=(const Recording&) = delete;

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
  std::optional<report::MatchRecording> file_;
  std::string why_not_;
  match::Observer observer_;
  match::AfterDecision after_;
};

Answer play(const campaign::Job& job, const Invocation& invocation, plugin::CallNote& note) {
  const plugin::Catalogue catalogue = open_plugins(job.plugins, invocation);
  MatchSetup prepared = match_setup(request_of(job), catalogue);
  const std::array<const mind::TeamPlan*, 2> plans{prepared.plans[0].get(), prepared.plans[1].get()};
  Answer answer;
  answer.kind = Answer::Kind::changed;
  // Program and mathematics are the coordinator's own.
  answer.message = what_changed(job, prepared, catalogue, input_of(job, campaign::program_input),
                                input_of(job, campaign::mathematics_input));
  if (!answer.message.empty()) return answer;
  PlayedMatch played;
  played.seed = job.seed;
  played.packets_share = packets_share_of(prepared.setup);
  for (const match::Side side : match::both_sides) {
    played.teams[match::index(side)] = plans[match::index(side)]->team().name;
    played.role_names[match::index(side)] = match::role_names(match::roles(*plans[match::index(side)]));
  }
  Recording recording(job, prepared, plans);
  try {
    played.result = match::play(std::move(prepared.setup), plans, recording.observer(), recording.after(), &note);
  } catch (const std::invalid_argument& error) {
    throw BadInput(error.what());  // profiles and teams that do not go together
  }
  answer.kind = Answer::Kind::played;
  answer.message = recording.close();
  answer.decided.score = played.result.score;
  answer.decided.ended = match::name(played.result.ended);
  answer.decided.hash = match::hash_text(played.result.hash);
  answer.decided.metrics = metrics_of(played);
  return answer;
}

Answer failed(const plugin::Failure& failure) {
  Answer answer;
  if (!failure.caller()) {
    answer.message = failure.what();
    return answer;
  }
  answer.kind = Answer::Kind::failed;
  answer.decided.failure = campaign::Failure{failure.caller()->noting.side, failure.id(),           failure.call(),
                                             failure.caller()->robot,       failure.caller()->tick, failure.message()};
  return answer;
}

Answer refused(const char* why) {
  Answer answer;
  answer.kind = Answer::Kind::refused;
  answer.message = why;
  return answer;
}

Answer work(const Invocation& invocation, plugin::CallNote& note) {
  try {
    return play(campaign::job_from_json(everything_from(STDIN_FILENO)), invocation, note);
  } catch (const plugin::Failure& failure) {
    return failed(failure);
  } catch (const BadInput& error) {
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

int serve(const Invocation& invocation) {
  std::optional<campaign::SharedNote> note;
  try {
    note.emplace(campaign::note_descriptor);
  } catch (const std::system_error&) {
    throw BadInput(fmt::format("{}: is for the program itself, which starts it for each match of a tournament",
                               campaign::worker_command));
  }
  const bool written = write_all(campaign::answer_descriptor,
                                 std::string(campaign::answer_mark) + to_json(work(invocation, note->note())) + '\n');
  // At once: what a plugin has left to be done at the end of the program is not to be waited for.
  _exit(written ? exit_done : exit_no);
}

}  // namespace

Command add_play_one(CLI::App& parent, const Invocation& invocation) {
  CLI::App& app = *parent.add_subcommand(campaign::worker_command, "one match of a campaign");
  app.group("");
  return {&app, [&invocation] { return serve(invocation); }};
}

}  // namespace regista::cli
