// SPDX-License-Identifier: MIT
#include "results/study_run.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

#include "campaign/match_setup.hpp"
#include "command/terminal.hpp"
#include "output/replaced_file.hpp"
#include "process/child.hpp"
#include "results/replay.hpp"
#include "results/results_file.hpp"
#include "texts/message.hpp"

namespace regista::results {
namespace {

constexpr std::chrono::milliseconds between_drawings{200};
constexpr std::uint64_t between_standings = 200;  // number of matches between two standings if each match has a line

winsize terminal() {
  winsize size{};
  const bool known = ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 && size.ws_row > 0;
  return known ? size : winsize{24, 80, 0, 0};
}

// Cuts lines to the width of the terminal, so that the number of drawn lines is known. Each byte counts as a column, so
// a line with wide characters is cut early. No character is cut in two. Only the last `height` lines stay.
std::string cut(std::string text, std::size_t width, std::size_t height) {
  auto lines = static_cast<std::size_t>(std::ranges::count(text, '\n'));
  for (; lines > height; --lines) text.erase(0, text.find('\n') + 1);
  std::string out;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    std::size_t length = std::min(end - begin, width);
    while (length > 0 && length < end - begin && (static_cast<unsigned char>(text[begin + length]) & 0xC0) == 0x80) {
      --length;
    }
    out += text.substr(begin, length) + '\n';
    begin = end + 1;
  }
  return out;
}

// Shows the progress of a study on standard error: on a terminal a block of lines in place, elsewhere a line per match.
class StudyProgress {
 public:
  // end_of_time: no match begins after this moment; may be missing. wanted: false shows no progress.
  StudyProgress(const report::StudyReport& report, bool wanted, std::optional<campaign::Moment> end_of_time)
      : report_(report), wanted_(wanted), rewrite_(wanted && command::can_rewrite()), end_of_time_(end_of_time) {}
  ~StudyProgress() { clear(); }
  StudyProgress(const StudyProgress&) = delete;
  StudyProgress& operator=(const StudyProgress&) = delete;

  // Shows a first line, which stays until the first match has ended. until: whether --until gave the end of time; only
  // this line says which day `--until 08:00` means, so --quiet does not leave it out.
  void begin(bool until) {
    if (end_of_time_ && (wanted_ || until))
      command::say(fmt::format("no match begins after {}; the study ends then, after a whole pair\n",
                               campaign::in_words(*end_of_time_)));
    if (rewrite_) show(report_.study().so_far(0) + ", the first is being played\n");
  }
  // Shows the next match, which the study has taken. decided: null for a match not needed. fresh: played in this run.
  void match(const study::Round& round, std::uint64_t index, const campaign::MatchResult* decided, bool fresh) {
    ++taken_;
    if (decided == nullptr) return;
    ++(fresh ? played_ : stored_);
    if (!wanted_) return;
    if (rewrite_) {
      if (Clock::now() - drawn_ < between_drawings) return;
      drawn_ = Clock::now();
      return show(block());
    }
    if (!fresh) return;
    const std::uint64_t number = round.first_row + index + 1;
    const study::Study& study = report_.study();
    const std::string of = !study.open_end().empty() ? "" : fmt::format(" of {}", study.most_matches());
    command::say(fmt::format("match {}{}, {}\n", number, of, report_.match(round, index, *decided)));
    if (number % between_standings == 0) command::say(block());
  }
  // Prints a line even if progress is not shown.
  void print(std::string_view line) {
    clear();
    command::complain(line);
  }
  // Prints a line only if progress is shown.
  void note(const std::string& line) {
    if (wanted_) command::say(line + '\n');
  }
  void clear() {
    if (lines_ == 0) return;
    command::say(fmt::format("\x1b[{}F\x1b[J", lines_));
    lines_ = 0;
  }
  void finish() {
    if (!wanted_) return;
    std::string out = fmt::format("{} matches played in {}", played_, texts::duration(seconds()));
    if (played_ > 0) out += fmt::format(", {}", rate_text());
    if (stored_ > 0) out += fmt::format("; {} were played before", stored_);
    command::say(out + '\n');
  }
  void stopped() {
    if (wanted_ && taken_ > 0) command::say(outline_text(report_.outline()));
  }

 private:
  using Clock = std::chrono::steady_clock;
  double seconds() const { return std::chrono::duration<double>(Clock::now() - began_).count(); }
  std::string rate_text() const {
    return fmt::format("{:.2f} matches/s", static_cast<double>(played_) / std::max(seconds(), 1e-3));
  }
  std::string block() const {
    const std::uint64_t matches = report_.study().most_matches();
    std::string text = fmt::format("{}{}, {}", report_.standing(), report_.study().so_far(taken_), rate_text());
    if (played_ > 0 && (end_of_time_ || report_.study().open_end().empty())) {
      double left = static_cast<double>(matches - std::min(taken_, matches)) * seconds() / static_cast<double>(played_);
      if (end_of_time_) {
        const double to_end = std::chrono::duration<double>(*end_of_time_ - std::chrono::system_clock::now()).count();
        left = std::min(left, std::max(to_end, 0.0));
      }
      text += fmt::format(", at most {} left", texts::duration(left));
    }
    return text + '\n';
  }
  void show(const std::string& block) {
    const winsize size = terminal();
    const std::string text = cut(block, size.ws_col - std::size_t{1}, std::max<std::size_t>(size.ws_row, 2) - 1);
    clear();
    lines_ = static_cast<int>(std::ranges::count(text, '\n'));
    command::say(text);
  }

  const report::StudyReport& report_;
  std::uint64_t taken_ = 0, stored_ = 0, played_ = 0;  // taken_ includes matches that the study does not need
  bool wanted_, rewrite_;
  std::optional<campaign::Moment> end_of_time_;
  int lines_ = 0;  // lines of the block on the terminal
  Clock::time_point began_ = Clock::now(), drawn_{};
};

// Rewrites the page of a running study regularly beside the results. The page reloads itself in browsers.
class LivePage {
 public:
  // wanted: false makes all functions do nothing.
  LivePage(const StoredResults& results, bool wanted) : results_(results), wanted_(wanted) {}

  // The caller must call this function at the beginning and after each match.
  void match() {
    const auto began = RefreshSchedule::Clock::now();
    if (!wanted_ || !refresh_.due(began)) return;
    // The next writing is expected to take as long as the previous writing.
    RefreshSchedule expected;
    expected.done(began, began + last_);
    PageOptions page{.reload_seconds = expected.seconds_from(began), .incomplete_is_known = true};
    wanted_ = write_page_beside(results_, false, std::move(page)).has_value();
    const auto ended = RefreshSchedule::Clock::now();
    last_ = ended - began;
    refresh_.done(began, ended);
  }
  // Writes the last page of a stopped study, which does not reload.
  void stop() {
    if (wanted_) write_page_beside(results_, false, {.incomplete_is_known = true});
    wanted_ = false;
  }

 private:
  StoredResults results_;
  bool wanted_;
  RefreshSchedule refresh_;
  RefreshSchedule::Clock::duration last_{};  // duration of the last writing of the page
};

std::string resume_line(const campaign::Options& options, const Invocation& invocation) {
  std::vector<std::string> words = invocation.arguments;
  // `--until 08:00` may mean another day when the line is typed.
  if (const auto until = std::ranges::find(words, "--until"); options.end_of_time && until < words.end() - 1)
    *(until + 1) = campaign::in_words(*options.end_of_time);
  if (!options.resume) words.push_back("--resume");
  return process::shell_line(words);
}

constexpr std::chrono::seconds longest_silence{5};

struct Playing {
  const study::Study& study;
  const campaign::Options& options;
  const Invocation& invocation;
  StudyProgress& progress;
  const command::Interruption& interruption;
};

// Passes matches to the round only in complete pairs, so that a time limit (--until, --minutes) splits no pair.
class WholePairs {
 public:
  explicit WholePairs(const study::Round& round) : round_(round) {}

  // The caller must add matches in the order of the schedule. Returns false if no more matches are needed.
  bool take(std::uint64_t index, const campaign::MatchResult* decided) {
    waiting_.push_back(decided == nullptr ? std::nullopt : std::optional(*decided));
    if ((index + 1) % round_.matches_of_a_pair != 0) return true;
    std::uint64_t next = index + 1 - waiting_.size();
    bool more = true;
    for (const auto& each : waiting_) more = more && round_.take(next++, each ? &*each : nullptr);
    waiting_.clear();
    ++pairs_;
    return more;
  }

  std::uint64_t pairs() const { return pairs_; }

 private:
  const study::Round& round_;
  std::vector<std::optional<campaign::MatchResult>> waiting_;
  std::uint64_t pairs_ = 0;
};

// Returns the schedule with which the engine plays the round. pairs: passes only complete pairs to the round; null if
// no time limit may stop the study. All references must outlive the schedule.
campaign::Schedule schedule_of(const study::Round& round, const Playing& playing, std::vector<std::int64_t> numbers,
                               campaign::Metrics metrics, WholePairs* pairs) {
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
  out.take = [&round, &playing, pairs](std::uint64_t index, const campaign::MatchResult* decided, bool fresh) {
    const bool more = pairs == nullptr ? round.take(index, decided) : pairs->take(index, decided);
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
  if (pairs != nullptr)
    out.out_of_time = [end = *playing.options.end_of_time] { return std::chrono::system_clock::now() >= end; };
  return out;
}

// Returns the number of complete pairs after which a time limit stopped the study, or nothing if the study is complete.
std::optional<std::uint64_t> play(study::Study& study, const campaign::Options& options, const Invocation& invocation,
                                  campaign::Store& store, StudyProgress& progress, const study::AfterMatch& after) {
  std::optional<std::uint64_t> stopped_after;
  const std::string resume = resume_line(options, invocation);
  const auto to_go_on = [&resume](const char* why) { return fmt::format("{}; to go on: {}", why, resume); };
  const command::Interruption interruption(fmt::format("regista: interrupted; to go on: {}\n", resume));
  const Playing playing{study, options, invocation, progress, interruption};
  const study::PlayRound play = [&](const study::Round& round) {
    if (options.plays == campaign::Options::Plays::nothing_more) {
      if (!study::answer_from(store, round, study.metrics())) throw study::StudyError("a match is missing");
      return;
    }
    std::optional<WholePairs> pairs;
    if (options.end_of_time) {
      if (round.matches_of_a_pair == 0)
        throw study::StudyError(
            "it has no pairs of matches to be stopped after, so --until and --minutes are not for it");
      pairs.emplace(round);
    }
    const campaign::Schedule schedule =
        schedule_of(round, playing, store.add(round.fixtures), study.metrics(), pairs ? &*pairs : nullptr);
    const campaign::Finish finish =
        campaign::run(schedule, store, campaign::number_of_workers(options), study.limits());
    if (finish == campaign::Finish::out_of_time) stopped_after = pairs->pairs();
    if (finish != campaign::Finish::interrupted) return;
    progress.clear();
    progress.stopped();
    throw command::Interrupted(fmt::format("interrupted after {}; to go on: {}", study.so_far(study.counted()), resume),
                               interruption.signal_number());
  };
  bool reported = false;
  store.when_locked([&](const campaign::Locked& locked) {
    const char* const what = locked.over
                                 ? "is free again, and all that waited is written"
                                 : "another program keeps it from being written to; what is played waits in memory";
    if (locked.over ? reported : !reported && locked.since > longest_silence)
      progress.print(fmt::format("{}: {}", options.results, what));
    reported = !locked.over && locked.since > longest_silence;
    return !interruption.requested();
  });
  struct AtItsEnd {  // ends all progress output before the report is printed
    ~AtItsEnd() {
      store.when_locked({});
      progress.clear();
    }
    campaign::Store& store;
    StudyProgress& progress;
  };
  try {
    const AtItsEnd at_its_end{store, progress};
    std::uint64_t end = 0;
    study.run(study::where_planned(study::observed(play, after), store, end));
    study::require_no_row_beyond(store, end);
    store.require_whole_file();
    return stopped_after;
  } catch (const study::StudyError& error) {
    throw command::BadInput(fmt::format("{}: {}", study.what(), error.what()));
  } catch (const campaign::CampaignError& error) {
    if (error.kind == campaign::CampaignError::Kind::input)
      throw command::BadInput(fmt::format("while the {} was played: {}", study.what(), error.what()));
    throw output::WriteError(to_go_on(error.what()));
  } catch (const campaign::StoreDamaged& error) {
    throw command::BadInput(error.what());
  } catch (const campaign::StoreGone& error) {
    throw output::WriteError(error.what());
  } catch (const campaign::StoreError& error) {
    throw output::WriteError(to_go_on(error.what()));
  } catch (const std::system_error& error) {
    throw output::WriteError(to_go_on(error.what()));
  }
}

void end_after(std::uint64_t pairs, report::StudyReport& report, campaign::Store& store) {
  report.end_after(pairs);
  try {
    store_plan(store, report.study().plan());
  } catch (const campaign::StoreError& error) {
    throw output::WriteError(error.what());
  }
}

}  // namespace

report::CommandOf play_again(const Invocation& invocation) {
  return [&invocation](const campaign::Job& job) { return campaign::match_command(job, invocation.arguments.front()); };
}

bool play_matches(report::StudyReport& report, const campaign::Options& options, const Invocation& invocation,
                  campaign::Store& store, const study::AfterMatch& after) {
  if (report.study().open_end() == "the clock" && !options.end_of_time) {
    throw command::BadInput(
        fmt::format("{}: no number of pairs was asked for; how long is it to play? Say --until, "
                    "--minutes or, of regista resume, --pairs",
                    texts::one_line(options.results)));
  }
  for (const std::string& each : report.played().changed) command::complain(each);
  StudyProgress progress(report, !options.quiet, options.end_of_time);
  for (const std::string& each : report.notes()) progress.note(each);
  LivePage live({options.results, store, invocation.studies}, options.live);
  live.match();
  if (options.live) progress.note(fmt::format("page: {}", texts::one_line(study::page_file(options.results).string())));
  progress.begin(!options.until.empty());
  const study::AfterMatch with_page = [&](const study::Round& round, std::uint64_t index,
                                          const campaign::MatchResult* decided) {
    if (after) after(round, index, decided);
    live.match();
  };
  std::optional<std::uint64_t> stopped_after;
  try {
    stopped_after = play(report.study(), options, invocation, store, progress, options.live ? with_page : after);
  } catch (...) {
    live.stop();
    throw;
  }
  progress.finish();
  if (stopped_after == 0) {
    live.stop();
    command::complain(
        fmt::format("the time was over before the first pair of matches was played: nothing can be said; "
                    "to go on: {}",
                    resume_line(options, invocation)));
    return false;
  }
  if (stopped_after) end_after(*stopped_after, report, store);
  return true;
}

namespace {

int play_and_report(report::StudyReport& report, const campaign::Options& options, const Invocation& invocation,
                    campaign::Store& store, const StudyHooks& hooks) {
  if (!play_matches(report, options, invocation, store, hooks.after)) return command::exit_no;
  if (hooks.at_end) hooks.at_end();
  output::print(options.json ? outline_json(report.outline()) : outline_text(report.outline()));
  if (options.no_page) return command::exit_done;
  const bool figures = kind_of(options.results, report.study().plan(), invocation.studies).figures;
  const auto page = write_page_beside({options.results, store, invocation.studies}, figures);
  if (page && !options.quiet) command::say(fmt::format("page: {}\n", texts::one_line(page->string())));
  return command::exit_done;
}

// Runs the user's command of --notify in a shell. Its environment says how the study ended.
void notify(const campaign::Options& options, const char* status, const std::string& message) {
  if (options.notify.empty()) return;
  ::setenv("REGISTA_STATUS", status, 1);
  ::setenv("REGISTA_MESSAGE", texts::one_line(message).c_str(), 1);
  ::setenv("REGISTA_RESULTS", std::filesystem::absolute(options.results).c_str(), 1);
  if (std::system(options.notify.c_str()) != 0) command::complain("the command of --notify failed: " + options.notify);
}

}  // namespace

int play_study(report::StudyReport& report, const campaign::Options& options, const Invocation& invocation,
               campaign::Store& store, const StudyHooks& hooks) {
  if (options.plays == campaign::Options::Plays::nothing_yet) return command::exit_done;
  try {
    const int status = play_and_report(report, options, invocation, store, hooks);
    notify(options, status == command::exit_done ? "done" : "stopped", report::plain(report.outline().headline));
    return status;
  } catch (const command::Interrupted& stop) {
    notify(options, "stopped", stop.what());
    throw;
  } catch (const std::exception& error) {
    notify(options, "failed", error.what());
    throw;
  }
}

}  // namespace regista::results
