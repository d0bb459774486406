// SPDX-License-Identifier: MIT
#include "campaign/engine.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>
#include <poll.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <ctime>
#include <map>
#include <memory>
#include <thread>
#include <utility>

#include "campaign/fork_server.hpp"
#include "campaign/match_run.hpp"
#include "config/errors.hpp"
#include "config/scalar.hpp"
#include "process/child.hpp"
#include "texts/message.hpp"

namespace regista::campaign {
namespace {

using config::BadInput;

constexpr double most_minutes = 525'600;  // a year

std::tm on_the_clock(Moment moment) {
  const std::time_t time = std::chrono::system_clock::to_time_t(moment);
  std::tm out{};
  localtime_r(&time, &out);
  return out;
}

// Returns the numbers of a text with the form of `pattern`, where 0 is any digit; nothing for a text of another form.
template <std::size_t Numbers>
std::optional<std::array<int, Numbers>> numbers_like(const std::string& text, const std::string& pattern) {
  if (text.size() != pattern.size()) return std::nullopt;
  std::array<int, Numbers> out{};
  std::size_t number = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (pattern[i] != '0') {
      if (text[i] != pattern[i]) return std::nullopt;
      ++number;
    } else if (text[i] >= '0' && text[i] <= '9') {
      out[number] = 10 * out[number] + (text[i] - '0');
    } else {
      return std::nullopt;
    }
  }
  return out;
}

// Returns the moment of this local time; nothing if the calendar or the clock never shows this time.
std::optional<Moment> moment_of(const std::tm& wanted) {
  std::tm shown = wanted;
  shown.tm_isdst = -1;
  const std::time_t time = std::mktime(&shown);
  const bool same = shown.tm_year == wanted.tm_year && shown.tm_mon == wanted.tm_mon &&
                    shown.tm_mday == wanted.tm_mday && shown.tm_hour == wanted.tm_hour && shown.tm_min == wanted.tm_min;
  if (time == std::time_t{-1} || !same) return std::nullopt;
  return std::chrono::system_clock::from_time_t(time);
}

Moment until_time(const std::string& text, Moment now) {
  if (const auto time = numbers_like<2>(text, "00:00"); time && (*time)[0] < 24 && (*time)[1] < 60) {
    std::tm wanted = on_the_clock(now);
    wanted.tm_hour = (*time)[0];
    wanted.tm_min = (*time)[1];
    wanted.tm_sec = 0;
    wanted.tm_isdst = -1;
    for (;; ++wanted.tm_mday) {  // mktime() takes the day after the last day of a month for day 1 of the next month
      std::tm shown = wanted;
      const Moment out = std::chrono::system_clock::from_time_t(std::mktime(&shown));
      if (out > now) return out;
    }
  }
  auto day = numbers_like<5>(text, "0000-00-00T00:00");
  if (!day) day = numbers_like<5>(text, "0000-00-00 00:00");
  if (day) {
    std::tm wanted{};
    wanted.tm_year = (*day)[0] - 1900;
    wanted.tm_mon = (*day)[1] - 1;
    wanted.tm_mday = (*day)[2];
    wanted.tm_hour = (*day)[3];
    wanted.tm_min = (*day)[4];
    if (const auto out = moment_of(wanted)) {
      if (*out > now) return *out;
      throw BadInput(fmt::format("--until {}: this time is past, it is {} now", text, in_words(now)));
    }
  }
  throw BadInput(
      fmt::format("--until: {} is no time; expected one such as 08:00 or 2026-11-28T08:00", texts::in_quotes(text)));
}

}  // namespace

std::optional<Moment> end_of_time(const std::string& until, const std::string& minutes, Moment now) {
  if (!until.empty() && !minutes.empty()) throw BadInput("--until and --minutes: one of them");
  if (!until.empty()) return until_time(until, now);
  if (minutes.empty()) return std::nullopt;
  const std::optional<double> number = config::typed_number(minutes);
  if (!number || !(*number > 0.0) || *number > most_minutes) {
    throw BadInput(
        fmt::format("--minutes: {}; expected a number above 0 and up to {}", texts::in_quotes(minutes), most_minutes));
  }
  return now + std::chrono::duration_cast<Moment::duration>(std::chrono::duration<double>(60.0 * *number));
}

std::string in_words(Moment moment) { return fmt::format("{:%Y-%m-%d %H:%M}", on_the_clock(moment)); }

void check(Options& options) {
  number_of_workers(options);
  record_every(options);
  if (options.live && options.no_page) throw config::BadInput("--live and --no-page: one of them");
  options.end_of_time = end_of_time(options.until, options.minutes, std::chrono::system_clock::now());
}

int number_of_workers(const Options& options) {
  if (options.workers.empty()) return static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1u, 1024u));
  return static_cast<int>(config::parse_whole("--workers", options.workers, 1, 1024));
}

std::uint64_t record_every(const Options& options) {
  return options.record_every.empty() ? 0 : config::parse_whole("--record-every", options.record_every, 1, UINT64_MAX);
}

Limits limits_of(const config::MatchSettings& settings) {
  Limits limits;
  limits.processor_seconds = settings.limits.processor_seconds;
  limits.memory = static_cast<std::uint64_t>(settings.limits.memory) << 20;
  // The default is long, because the machine may be busy: only a plugin that sleeps exceeds this limit.
  limits.wall_seconds = settings.limits.wall_seconds.value_or(10 * limits.processor_seconds + 100);
  limits.match_wall_seconds = settings.limits.match_seconds;
  limits.play_twice = settings.play_twice;
  limits.allow_shared_memory = settings.allow_shared_memory;
  limits.isolation = settings.isolation == config::Isolation::always ? Isolation::always : Isolation::after_a_death;
  return limits;
}

namespace {

constexpr std::uint64_t ahead = 16;  // per worker: places that a new match may be ahead of the first undecided match

constexpr int patience = 100;      // ms between two checks of all workers
constexpr int short_patience = 1;  // ms between two checks, if a worker has closed its pipe and so will end soon

struct Run {
  MatchKey key;
  std::vector<std::uint64_t> indices;  // places in the schedule; equal matches share a Run
  MatchRun match;
};

// Waits until a worker has written something, but at most `patience`.
void wait_for(const std::vector<const Worker*>& workers) {
  std::vector<pollfd> watched;
  int patient = patience;
  for (const Worker* const each : workers) {
    watched.push_back({each->descriptor(), POLLIN, 0});  // poll() ignores a negative descriptor
    watched.push_back({each->output_descriptor(), POLLIN, 0});
    if (each->descriptor() == -1) patient = short_patience;
  }
  poll(watched.data(), watched.size(), patient);  // a signal ends poll() early
}

class Engine {
 public:
  Engine(const Schedule& schedule, Store& store, int workers, const Limits& limits)
      : schedule_(schedule),
        store_(store),
        workers_(static_cast<std::size_t>(workers)),
        limits_(limits),
        server_(limits, [this] { end_strays(); }) {}

  Finish run() {
    try {
      const Finish out = play();
      store_.settle();
      return out;
    } catch (...) {
      // Writes the waiting matches unless the file is locked. A new error here must not hide the first error.
      try {
        store_.write_waiting();
      } catch (const StoreError&) {
      }
      throw;
    }
  }

 private:
  Finish play() {
    while (due_ < schedule_.matches) {
      if (schedule_.asked_to_stop && schedule_.asked_to_stop()) return Finish::interrupted;
      fill();
      if (!hand_on()) return Finish::enough;
      if (runs_.empty()) {
        if (stopped_ && due_ == next_) return Finish::out_of_time;
        if (store_.waiting_is_full()) store_.settle();
        continue;
      }
      std::vector<const Worker*> workers;
      for (const auto& run : runs_) workers.push_back(&run->match.worker());
      wait_for(workers);
      store_.write_waiting();
      for (std::size_t i = 0; i < runs_.size();) {
        if (!runs_[i]->match.advance()) {
          ++i;
          continue;
        }
        decide(*runs_[i]);
        runs_.erase(runs_.begin() + static_cast<std::ptrdiff_t>(i));
        end_strays();
      }
    }
    return Finish::complete;
  }

  struct Ready {
    std::optional<MatchResult> decided;
    bool fresh;
  };

  // Ends processes that plugins have started, and workers of a server that died before it replied.
  void end_strays() const {
    std::vector<pid_t> ours{server_.process()};
    for (const auto& run : runs_) ours.push_back(run->match.worker().process());
    descendants_.end_all_but(ours);
  }

  void fill() {
    if (store_.waiting_is_full()) return;
    while (runs_.size() < workers_ && next_ < schedule_.matches && next_ < due_ + ahead * workers_) {
      const std::uint64_t index = next_;
      const std::optional<MatchKey> key = schedule_.at(index);
      std::optional<MatchResult> stored;
      if (key) stored = store_.find(row(index), *key, schedule_.metrics);
      if (!key || stored) {
        decided_.emplace(index, Ready{std::move(stored), false});
        ++next_;
        continue;
      }
      const auto same = std::ranges::find_if(runs_, [&](const std::unique_ptr<Run>& run) { return run->key == *key; });
      if (same != runs_.end()) {
        (*same)->indices.push_back(index);
        ++next_;
        continue;
      }
      // Checks the time only for a match that must be played, because stored results take no time.
      stopped_ = stopped_ || (schedule_.out_of_time && schedule_.out_of_time());
      if (stopped_) return;
      ++next_;
      const bool twice = limits_.play_twice && schedule_.twice && schedule_.twice(index);
      std::string failure_record = schedule_.record_failure ? schedule_.record_failure(index) : std::string();
      runs_.emplace_back(
          new Run{*key, {index}, MatchRun(schedule_.job(index), limits_, twice, std::move(failure_record), &server_)});
    }
  }

  std::int64_t row(std::uint64_t index) const { return static_cast<std::int64_t>(schedule_.first_row + index) + 1; }

  bool hand_on() {
    for (auto first = decided_.begin(); first != decided_.end() && first->first == due_; first = decided_.begin()) {
      const std::optional<MatchResult>& decided = first->second.decided;
      const bool more = schedule_.take(due_, decided ? &*decided : nullptr, first->second.fresh);
      decided_.erase(first);
      ++due_;
      if (!more) return false;
    }
    return true;
  }

  void decide(const Run& run) {
    const MatchRun& match = run.match;
    if (!match.accident().empty() && schedule_.accident) schedule_.accident(match.job(), match.accident());
    if (!match.not_recorded().empty() && schedule_.not_recorded) {
      schedule_.not_recorded(match.job(), match.not_recorded());
    }
    store_.insert(row(run.indices.front()), run.key, match.decided(), match.plays());
    for (const std::uint64_t index : run.indices) decided_.emplace(index, Ready{match.decided(), true});
  }

  const Schedule& schedule_;
  Store& store_;
  std::size_t workers_;
  Limits limits_;
  process::Descendants descendants_;
  std::vector<std::unique_ptr<Run>> runs_;
  std::map<std::uint64_t, Ready> decided_;  // results by index that Schedule::take has not received yet
  std::uint64_t next_ = 0, due_ = 0;
  bool stopped_ = false;  // true: the time is over, so the engine begins no more matches
  ForkServer server_;     // declared after runs_, because its destructor calls end_strays(), which reads runs_
};

}  // namespace

Finish run(const Schedule& schedule, Store& store, int workers, const Limits& limits) {
  return Engine(schedule, store, workers, limits).run();
}

MatchResult play_alone(const Job& job, const Limits& limits) {
  const process::Descendants descendants;
  MatchRun match(job, limits, false, {});
  while (!match.advance()) wait_for({&match.worker()});
  descendants.end_all();
  return match.decided();
}

}  // namespace regista::campaign
