// SPDX-License-Identifier: MIT
#include "campaign/engine.hpp"

#include <poll.h>

#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "campaign/match_run.hpp"
#include "process/descendants.hpp"

namespace regista::campaign {
namespace {

// So many matches per worker may be decided before the one that is due.
constexpr std::uint64_t ahead = 16;

constexpr int patience = 100;      // ms between two looks at everything
constexpr int short_patience = 1;  // ms, while a worker that has said all it had to say ends

// A match under way, and what waits for it.
struct Run {
  MatchKey key;
  std::vector<std::uint64_t> indices;  // places in the schedule: equal teams play the same match twice
  MatchRun match;
};

void watch(const Worker& worker, std::vector<pollfd>& watched, int& patient) {
  watched.push_back({worker.descriptor(), POLLIN, 0});  // a negative one is passed over
  watched.push_back({worker.output_descriptor(), POLLIN, 0});
  if (worker.descriptor() == -1) patient = short_patience;
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
      keep_what_waits();
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
        if (store_.waiting_is_full()) store_.settle();
        continue;
      }
      wait();
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

  // As far as that is possible at once: why the engine ends is what is to be said.
  void keep_what_waits() {
    try {
      store_.write_waiting();
    } catch (const StoreError&) {
    }
  }

  struct Ready {
    std::optional<Decided> decided;
    bool fresh;
  };

  // What plugins have started, and workers of a server that died before it could tell of them.
  void end_strays() const {
    std::vector<pid_t> ours{server_.process()};
    for (const auto& run : runs_) ours.push_back(run->match.worker().process());
    descendants_.end_all_but(ours);
  }

  // Gives every free worker a match.
  void fill() {
    if (store_.waiting_is_full()) return;
    while (runs_.size() < workers_ && next_ < schedule_.matches && next_ < due_ + ahead * workers_) {
      const std::uint64_t index = next_++;
      const std::optional<MatchKey> key = schedule_.at(index);
      if (!key) {
        decided_.emplace(index, Ready{std::nullopt, false});
        continue;
      }
      if (auto stored = store_.find(row(index), *key, schedule_.metrics)) {
        decided_.emplace(index, Ready{std::move(stored), false});
        continue;
      }
      const auto same = std::ranges::find_if(runs_, [&](const std::unique_ptr<Run>& run) { return run->key == *key; });
      if (same != runs_.end()) {
        (*same)->indices.push_back(index);
        continue;
      }
      const bool twice = limits_.play_twice && schedule_.twice && schedule_.twice(index);
      std::string failure_record = schedule_.record_failure ? schedule_.record_failure(index) : std::string();
      runs_.emplace_back(
          new Run{*key, {index}, MatchRun(schedule_.job(index), limits_, twice, std::move(failure_record), &server_)});
    }
  }

  std::int64_t row(std::uint64_t index) const { return static_cast<std::int64_t>(schedule_.first_row + index) + 1; }

  bool hand_on() {
    for (auto first = decided_.begin(); first != decided_.end() && first->first == due_; first = decided_.begin()) {
      const std::optional<Decided>& decided = first->second.decided;
      const bool more = schedule_.take(due_, decided ? &*decided : nullptr, first->second.fresh);
      decided_.erase(first);
      ++due_;
      if (!more) return false;
    }
    return true;
  }

  void wait() {
    std::vector<pollfd> watched;
    int patient = patience;
    for (const auto& run : runs_) watch(run->match.worker(), watched, patient);
    poll(watched.data(), watched.size(), patient);  // a signal ends it early
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
  std::map<std::uint64_t, Ready> decided_;  // by index, not yet handed on
  std::uint64_t next_ = 0, due_ = 0;
  ForkServer server_;  // ends before the runs: it looks for children that are none of theirs
};

}  // namespace

Finish run(const Schedule& schedule, Store& store, int workers, const Limits& limits) {
  return Engine(schedule, store, workers, limits).run();
}

Decided play_alone(const Job& job, const Limits& limits, bool twice) {
  const process::Descendants descendants;
  MatchRun match(job, limits, twice, {});
  while (!match.advance()) {
    std::vector<pollfd> watched;
    int patient = patience;
    watch(match.worker(), watched, patient);
    poll(watched.data(), watched.size(), patient);
  }
  descendants.end_all();
  return match.decided();
}

}  // namespace regista::campaign
