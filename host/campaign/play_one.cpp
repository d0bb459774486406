// SPDX-License-Identifier: MIT
#include "campaign/play_one.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>
#include <optional>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "campaign/inputs.hpp"
#include "campaign/job_setup.hpp"
#include "campaign/match_setup.hpp"
#include "campaign/play_job.hpp"
#include "campaign/worker_process.hpp"
#include "config/bad_input.hpp"
#include "plugin/fatal_signal.hpp"
#include "process/descriptor.hpp"

namespace regista::campaign {
namespace {

// The plugins of the job's teams. Where each team thinks in a process of its own it is asked whose fault something is,
// so the process that plays loads none. Else nothing is lost when they are loaded at once.
plugin::Catalogue plugins_of(const Job& job, const Surroundings& surroundings) {
  if (job.plugin_files.empty()) return surroundings.open_plugins(job.plugins);
  const std::vector<std::filesystem::path> files(job.plugin_files.begin(), job.plugin_files.end());
  using Looking = plugin::Catalogue::Looking;
  plugin::Catalogue out =
      plugin::Catalogue::of_files(files, job.separation == Separation::teams ? Looking::in_a_child : Looking::here);
  // All of them could be used when the job was made.
  if (!out.refused().empty()) {
    throw config::BadInput(fmt::format("{}; that was not so at the beginning", to_string(out.refused().front())));
  }
  return out;
}

Answer play(const Surroundings& surroundings, WorkerNote& note) {
  const Job job = job_from_json(process::everything_in(STDIN_FILENO));
  if (!job.is_apart()) plugin::note_fatal_signals(note.fatal);
  const plugin::Catalogue catalogue = plugins_of(job, surroundings);
  MatchSetup prepared = match_setup(request_of(job), catalogue);
  Answer answer;
  answer.kind = Answer::Kind::changed;
  // Program and mathematics are the coordinator's own.
  answer.message =
      what_changed(job, prepared, catalogue, input_of(job, program_input), input_of(job, mathematics_input), job.root);
  if (!answer.message.empty()) return answer;
  return play_job(job, std::move(prepared), surroundings.program, note);
}

}  // namespace

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
