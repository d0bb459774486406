// SPDX-License-Identifier: MIT
#include "cli/study_run.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <system_error>

#include "campaign/shell.hpp"
#include "cli/end_of_program.hpp"
#include "cli/interruption.hpp"
#include "cli/output.hpp"
#include "cli/results_file.hpp"
#include "study/recording_place.hpp"

namespace regista::cli {
namespace {

std::string resume_line(const campaign::Options& options, const Invocation& invocation) {
  std::vector<std::string> words = invocation.arguments;
  if (!options.resume) words.push_back("--resume");
  return campaign::shell_line(words);
}

campaign::Schedule schedule_of(const StudyRun& run, const campaign::Options& options, const Invocation& invocation,
                               StudyProgress& progress, const Interruption& interruption,
                               std::vector<std::int64_t> numbers) {
  const std::uint64_t first = run.first_row;
  const auto recording = [&options, first](std::uint64_t index) {
    return study::recording_file(options.results, static_cast<std::int64_t>(first + index) + 1).string();
  };
  const std::uint64_t every = campaign::record_every(options);
  campaign::Schedule out;
  out.matches = run.matches;
  out.first_row = first;
  out.at = [&run, numbers = std::move(numbers)](std::uint64_t index) -> std::optional<campaign::MatchKey> {
    const std::optional<StudyRun::Place> place = run.at(index);
    if (!place) return std::nullopt;
    return campaign::MatchKey{numbers[place->fixture], place->seed};
  };
  out.job = [&run, &options, every, first, recording](std::uint64_t index) {
    campaign::Job match = run.job(index);
    match.plugin_files = options.plugin_files;
    if (every > 0 && (first + index) % every == 0) match.record = recording(index);
    return match;
  };
  out.twice = run.first_of_pairing;
  out.record_failure = recording;
  out.not_recorded = [&progress, &invocation](const campaign::Job& job, const std::string& why) {
    progress.tell(fmt::format("a match was not recorded: {}; it can be played again with --record: {}", why,
                              play_again(job, invocation)));
  };
  out.take = [&run, &progress](std::uint64_t index, const campaign::Decided* decided, bool fresh) {
    const bool more = run.take(index, decided);
    progress.match(run.first_row + index, decided, fresh);
    return more;
  };
  out.metrics = run.metrics;
  out.accident = [&progress, &invocation](const campaign::Job& job, const std::string& what) {
    progress.tell(fmt::format("a worker died ({}), but not when its match was played again: {}", what,
                              play_again(job, invocation)));
  };
  out.asked_to_stop = [&interruption] { return interruption.requested(); };
  return out;
}

}  // namespace

std::string play_again(const campaign::Job& job, const Invocation& invocation) {
  std::vector<std::string> words = campaign::match_arguments(job);
  words.insert(words.begin(), invocation.arguments.front());
  return campaign::shell_line(words);
}

void play_study(const StudyNature& nature, const campaign::Options& options, const Invocation& invocation,
                campaign::Store& store, StudyProgress& progress,
                const std::function<void(const PlayRun& play)>& course) {
  const std::string resume = resume_line(options, invocation);
  const auto to_go_on = [&resume](const char* why) { return fmt::format("{}; to go on: {}", why, resume); };
  const Interruption interruption(fmt::format("regista: interrupted; to go on: {}\n", resume));
  const PlayRun play = [&](const StudyRun& run) {
    const campaign::Schedule schedule =
        schedule_of(run, options, invocation, progress, interruption, store.add(run.fixtures));
    const campaign::Finish finish = campaign::run(schedule, store, campaign::number_of_workers(options), run.limits);
    if (finish != campaign::Finish::interrupted) return;
    progress.clear();
    progress.stopped();
    throw Interrupted(
        fmt::format("interrupted after {} of {} matches; to go on: {}", nature.counted(), nature.matches, resume));
  };
  try {
    course(play);
    store.require_file();
    progress.clear();
  } catch (const campaign::CampaignError& error) {
    progress.clear();
    if (error.kind() == campaign::CampaignError::Kind::input) {
      throw BadInput(fmt::format("while the {} was played: {}", nature.what, error.what()));
    }
    throw WriteError(to_go_on(error.what()));
  } catch (const campaign::StoreGone& error) {
    progress.clear();
    throw WriteError(error.what());
  } catch (const campaign::StoreError& error) {
    progress.clear();
    throw WriteError(to_go_on(error.what()));
  } catch (const std::invalid_argument& error) {
    progress.clear();
    throw BadInput(damaged_metrics(options.results, error));
  } catch (const std::system_error& error) {
    progress.clear();
    throw WriteError(to_go_on(error.what()));
  }
  progress.finish();
}

}  // namespace regista::cli
