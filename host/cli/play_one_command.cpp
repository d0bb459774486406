// SPDX-License-Identifier: MIT
// `regista play-one`, hidden: a worker of a campaign. See campaign/worker.hpp.
#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cerrno>
#include <new>
#include <nlohmann/json.hpp>
#include <optional>
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
#include "plugin/failure.hpp"

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
  for (const match::Side side : match::both_sides) {
    played.teams[match::index(side)] = plans[match::index(side)]->team().name;
    played.role_names[match::index(side)] = match::role_names(match::roles(*plans[match::index(side)]));
  }
  try {
    played.result = match::play(std::move(prepared.setup), plans, nullptr, {}, &note);
  } catch (const std::invalid_argument& error) {
    throw BadInput(error.what());  // profiles and teams that do not go together
  }
  answer.kind = Answer::Kind::played;
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
