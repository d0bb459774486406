// SPDX-License-Identifier: MIT
#include "campaign/engine.hpp"

#include <fmt/format.h>
#include <poll.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <system_error>
#include <utility>
#include <vector>

namespace regista::campaign {
namespace {

// So many matches per worker may be decided before the one that is due.
constexpr std::uint64_t ahead = 16;

constexpr int patience = 100;      // ms between two looks at everything
constexpr int short_patience = 1;  // ms, while a worker that has said all it had to say ends

// A match under way: its worker, and what happened to those before.
struct Run {
  MatchKey key;
  Job job;
  std::vector<std::uint64_t> indices;  // places in the schedule that wait for it: equal teams play the same match twice
  SharedNote note;
  std::unique_ptr<Worker> worker;
  std::vector<End> deaths;
  std::optional<Decided> forfeited;  // already; what runs still is for the recording alone
  int attempts = 0;                  // workers so far
  double seconds = 0.0;              // of all of them
};

// What the answer decides; nothing when the worker broke down, and `end` then tells how. seconds: of all its workers.
std::optional<Decided> answered(End& end, double seconds, std::string& not_recorded) {
  Answer answer;
  try {
    answer = answer_from_json(end.text);
  } catch (const std::invalid_argument&) {
    end.how = End::How::died;
    end.text = "wrote an answer that cannot be read";
    return std::nullopt;
  }
  switch (answer.kind) {
    case Answer::Kind::played:
      answer.decided.seconds = seconds;
      not_recorded = answer.message;
      return answer.decided;
    case Answer::Kind::failed:
      return forfeit(*answer.decided.failure, seconds);
    case Answer::Kind::changed:
    case Answer::Kind::refused:
      throw CampaignError(CampaignError::Kind::input, answer.message);
    case Answer::Kind::stopped:
      end.how = End::How::died;
      end.text = answer.message;
      return std::nullopt;
  }
  return std::nullopt;
}

[[noreturn]] void give_up(std::span<const End> deaths) {
  throw CampaignError(CampaignError::Kind::machine, fmt::format("workers died {} times over one match, at last so: {}",
                                                                deaths.size(), deaths.back().text));
}

class Engine {
 public:
  Engine(const Schedule& schedule, Store& store, int workers, const Limits& limits)
      : schedule_(schedule), store_(store), workers_(static_cast<std::size_t>(workers)), limits_(limits) {}

  Finish run() {
    while (due_ < schedule_.matches) {
      if (schedule_.asked_to_stop && schedule_.asked_to_stop()) return Finish::interrupted;
      fill();
      if (!hand_on()) return Finish::enough;
      if (runs_.empty()) continue;
      wait();
      for (std::size_t i = 0; i < runs_.size();) {
        if (runs_[i]->worker->advance() && settle(*runs_[i]))
          runs_.erase(runs_.begin() + static_cast<std::ptrdiff_t>(i));
        else
          ++i;
      }
    }
    return Finish::complete;
  }

 private:
  struct Waiting {
    std::optional<Decided> decided;
    bool fresh;
  };

  // Gives every free worker a match.
  void fill() {
    while (runs_.size() < workers_ && next_ < schedule_.matches && next_ < due_ + ahead * workers_) {
      const std::uint64_t index = next_++;
      const std::optional<MatchKey> key = schedule_.at(index);
      if (!key) {
        decided_.emplace(index, Waiting{std::nullopt, false});
        continue;
      }
      if (auto stored = store_.find(row(index), *key, schedule_.metrics)) {
        decided_.emplace(index, Waiting{std::move(stored), false});
        continue;
      }
      const auto same = std::ranges::find_if(runs_, [&](const std::unique_ptr<Run>& run) { return run->key == *key; });
      if (same != runs_.end()) {
        (*same)->indices.push_back(index);
        continue;
      }
      auto run = std::make_unique<Run>();
      run->key = *key;
      run->job = schedule_.job(index);
      run->indices.push_back(index);
      start(*run);
      runs_.push_back(std::move(run));
    }
  }

  std::int64_t row(std::uint64_t index) const { return static_cast<std::int64_t>(schedule_.first_row + index) + 1; }

  void start(Run& run) {
    if (!run.forfeited) ++run.attempts;
    run.worker = std::make_unique<Worker>(run.job, limits_, run.note);
  }

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
    for (const auto& run : runs_) {
      watched.push_back({run->worker->descriptor(), POLLIN, 0});  // a negative one is passed over
      if (run->worker->descriptor() == -1) patient = short_patience;
    }
    poll(watched.data(), watched.size(), patient);  // a signal ends it early
  }

  // The worker has ended. True when the match is decided.
  bool settle(Run& run) {
    End end = run.worker->end();
    if (run.forfeited) {
      decide(run, *run.forfeited);
      return true;
    }
    run.seconds += end.seconds;
    if (end.how == End::How::answered) {
      std::string not_recorded;
      const std::optional<Decided> decided = answered(end, run.seconds, not_recorded);
      if (decided) {
        if (!run.deaths.empty() && schedule_.accident) schedule_.accident(run.job, run.deaths.back());
        if (!not_recorded.empty() && schedule_.not_recorded) schedule_.not_recorded(run.job, not_recorded);
        if (decided->failure && run.job.record.empty() && record(run)) {
          run.forfeited = decided;
          start(run);
          return false;
        }
        decide(run, *decided);
        return true;
      }
    }
    run.deaths.push_back(end);
    switch (judge(run.deaths)) {
      case Judgement::play_again:
        record(run);
        start(run);
        return false;
      case Judgement::forfeit:
        decide(run, forfeit(*suspect(end), run.seconds));
        return true;
      case Judgement::give_up:
        break;
    }
    give_up(run.deaths);
  }

  // What failed once is recorded when it is played again. False: it is already, or is not wanted.
  bool record(Run& run) {
    if (run.job.expects_failure || !schedule_.record_failure) return false;
    run.job.record = schedule_.record_failure(run.indices.front());
    run.job.expects_failure = !run.job.record.empty();
    return run.job.expects_failure;
  }

  void decide(const Run& run, const Decided& decided) {
    std::error_code none;
    if (run.job.expects_failure && schedule_.not_recorded && !std::filesystem::exists(run.job.record, none)) {
      schedule_.not_recorded(run.job, run.job.record + " could not be written");
    }
    store_.insert(row(run.indices.front()), run.key, decided, run.attempts);
    for (const std::uint64_t index : run.indices) decided_.emplace(index, Waiting{decided, true});
  }

  const Schedule& schedule_;
  Store& store_;
  std::size_t workers_;
  Limits limits_;
  std::vector<std::unique_ptr<Run>> runs_;
  std::map<std::uint64_t, Waiting> decided_;  // by index, not yet handed on
  std::uint64_t next_ = 0, due_ = 0;
};

}  // namespace

Finish run(const Schedule& schedule, Store& store, int workers, const Limits& limits) {
  return Engine(schedule, store, workers, limits).run();
}

Decided play_alone(const Job& job, const Limits& limits) {
  SharedNote note;
  std::vector<End> deaths;
  double seconds = 0.0;
  std::string not_recorded;
  for (;;) {
    Worker worker(job, limits, note);
    while (!worker.advance()) {
      pollfd watched{worker.descriptor(), POLLIN, 0};
      poll(&watched, 1, watched.fd == -1 ? short_patience : patience);
    }
    End end = worker.end();
    seconds += end.seconds;
    if (end.how == End::How::answered) {
      if (const std::optional<Decided> decided = answered(end, seconds, not_recorded)) return *decided;
    }
    deaths.push_back(end);
    const Judgement judgement = judge(deaths);
    if (judgement == Judgement::forfeit) return forfeit(*suspect(end), seconds);
    if (judgement == Judgement::give_up) give_up(deaths);
  }
}

}  // namespace regista::campaign
