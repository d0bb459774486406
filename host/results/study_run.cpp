// SPDX-License-Identifier: MIT
#include "results/study_run.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cstdint>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

#include "campaign/engine.hpp"
#include "command/end_of_program.hpp"
#include "command/interruption.hpp"
#include "command/terminal.hpp"
#include "output/output.hpp"
#include "process/program.hpp"
#include "results/results_page.hpp"
#include "results/study_progress.hpp"
#include "study/recording_place.hpp"
#include "texts/message.hpp"

namespace regista::results {
namespace {

std::string resume_line(const campaign::Options& options, const Invocation& invocation) {
  std::vector<std::string> words = invocation.arguments;
  if (!options.resume) words.push_back("--resume");
  return process::shell_line(words);
}

constexpr std::chrono::seconds longest_silence{5};

std::string locked_line(const std::string& results, const campaign::Locked& locked) {
  if (locked.over) return fmt::format("{}: is free again, and all that waited is written", results);
  return fmt::format("{}: another program keeps it from being written to; what is played waits in memory", results);
}

// What is done while another program holds the lock, for as long as this lives.
struct WhileLocked {
  WhileLocked(campaign::Store& in, std::function<bool(const campaign::Locked&)> go_on) : store(in) {
    store.when_locked(std::move(go_on));
  }
  ~WhileLocked() { store.when_locked({}); }
  WhileLocked(const WhileLocked&) = delete;
  WhileLocked& operator=(const WhileLocked&) = delete;
  campaign::Store& store;
};

struct Playing {
  const study::Study& study;
  const campaign::Options& options;
  const Invocation& invocation;
  StudyProgress& progress;
  const command::Interruption& interruption;
};

campaign::Schedule schedule_of(const study::Round& round, const Playing& playing, std::vector<std::int64_t> numbers,
                               campaign::Metrics metrics) {
  const auto recording = [&playing, &round](std::uint64_t index) {
    const auto row = static_cast<std::int64_t>(round.first_row + index) + 1;
    return study::recording_file(playing.options.results, row).string();
  };
  campaign::Schedule out;
  out.matches = round.matches;
  out.first_row = round.first_row;
  out.at = [&round, numbers = std::move(numbers)](std::uint64_t index) -> std::optional<campaign::MatchKey> {
    const std::optional<study::Round::Place> place = round.at(index);
    if (!place) return std::nullopt;
    return campaign::MatchKey{numbers[place->fixture], place->seed};
  };
  out.job = [&round, &playing, recording](std::uint64_t index) {
    const std::uint64_t every = campaign::record_every(playing.options);
    campaign::Job match = round.job(index);
    match.plugin_files = playing.options.plugin_files;
    if (every > 0 && (round.first_row + index) % every == 0) match.record = recording(index);
    return match;
  };
  out.twice = round.first_of_pairing;
  out.record_failure = recording;
  out.not_recorded = [&playing](const campaign::Job& job, const std::string& why) {
    playing.progress.print(fmt::format("a match was not recorded: {}; it can be played again with --record: {}", why,
                                       play_again(playing.invocation)(job)));
  };
  out.take = [&round, &playing](std::uint64_t index, const campaign::Decided* decided, bool fresh) {
    const bool more = round.take(index, decided);
    playing.progress.match(round, index, decided, fresh);
    if (const std::string why = playing.study.unplayable(); fresh && !why.empty()) throw study::StudyError(why);
    return more;
  };
  out.metrics = metrics;
  out.accident = [&playing](const campaign::Job& job, const std::string& what) {
    playing.progress.print(fmt::format("a worker died ({}), but not when its match was played again: {}", what,
                                       play_again(playing.invocation)(job)));
  };
  out.asked_to_stop = [&playing] { return playing.interruption.requested(); };
  return out;
}

void play(study::Study& study, const campaign::Options& options, const Invocation& invocation, campaign::Store& store,
          StudyProgress& progress, const study::AfterMatch& after) {
  const std::string resume = resume_line(options, invocation);
  const auto to_go_on = [&resume](const char* why) { return fmt::format("{}; to go on: {}", why, resume); };
  const command::Interruption interruption(fmt::format("regista: interrupted; to go on: {}\n", resume));
  const Playing playing{study, options, invocation, progress, interruption};
  const study::PlayRound play = [&](const study::Round& round) {
    if (options.plays == campaign::Options::Plays::nothing_more) {
      if (!study::answer_from(store, round, study.metrics())) throw study::StudyError("a match is missing");
      return;
    }
    const campaign::Schedule schedule = schedule_of(round, playing, store.add(round.fixtures), study.metrics());
    const campaign::Finish finish =
        campaign::run(schedule, store, campaign::number_of_workers(options), study.limits());
    if (finish != campaign::Finish::interrupted) return;
    progress.clear();
    progress.stopped();
    throw command::Interrupted(
        fmt::format("interrupted after {} of {} matches; to go on: {}", study.counted(), study.most_matches(), resume),
        interruption.signal_number());
  };
  bool reported = false;
  const WhileLocked while_locked(store, [&](const campaign::Locked& locked) {
    const std::string line = locked_line(options.results, locked);
    if (locked.over ? reported : !reported && locked.since > longest_silence) progress.print(line);
    reported = !locked.over && locked.since > longest_silence;
    return !interruption.requested();
  });
  std::uint64_t end = 0;
  try {
    study.run(study::where_planned(study::observed(play, after), store, end));
    study::require_no_row_beyond(store, end);
    store.require_whole_file();
    progress.clear();
  } catch (const study::StudyError& error) {
    progress.clear();
    throw command::BadInput(fmt::format("{}: {}", study.what(), error.what()));
  } catch (const campaign::CampaignError& error) {
    progress.clear();
    if (error.kind() == campaign::CampaignError::Kind::input) {
      throw command::BadInput(fmt::format("while the {} was played: {}", study.what(), error.what()));
    }
    throw output::WriteError(to_go_on(error.what()));
  } catch (const campaign::StoreDamaged& error) {
    progress.clear();
    throw command::BadInput(error.what());
  } catch (const campaign::StoreGone& error) {
    progress.clear();
    throw output::WriteError(error.what());
  } catch (const campaign::StoreError& error) {
    progress.clear();
    throw output::WriteError(to_go_on(error.what()));
  } catch (const std::system_error& error) {
    progress.clear();
    throw output::WriteError(to_go_on(error.what()));
  }
  progress.finish();
}

}  // namespace

report::CommandOf play_again(const Invocation& invocation) {
  return [&invocation](const campaign::Job& job) {
    std::vector<std::string> words = campaign::match_arguments(job);
    words.insert(words.begin(), invocation.arguments.front());
    return process::shell_line(words);
  };
}

int play_study(report::StudyReport& report, const campaign::Options& options, const Invocation& invocation,
               campaign::Store& store, const StudyWishes& wishes) {
  if (options.plays == campaign::Options::Plays::nothing_yet) return command::exit_done;
  {
    for (const std::string& each : report.played().changed) command::complain(each);
    StudyProgress progress(report, !options.quiet);
    for (const std::string& each : report.notes()) progress.note(each);
    progress.begin();
    play(report.study(), options, invocation, store, progress, wishes.after);
  }
  if (wishes.at_end) wishes.at_end();
  output::print(options.json ? outline_json(report.outline()) : outline_text(report.outline()));
  if (options.no_page) return command::exit_done;
  const auto page = write_page_beside({options.results, store, invocation.studies}, wishes.figures);
  if (page && !options.quiet) command::say(fmt::format("page: {}\n", texts::one_line(page->string())));
  return command::exit_done;
}

}  // namespace regista::results
