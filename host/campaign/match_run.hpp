// SPDX-License-Identifier: MIT
// One match until it is decided: as many plays as that takes, one worker after the other. Never blocks.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "campaign/blame.hpp"
#include "campaign/decision_trail.hpp"
#include "campaign/job.hpp"
#include "campaign/limits.hpp"
#include "campaign/worker.hpp"
#include "plugin/plugin_file.hpp"

namespace regista::campaign {

class MatchRun {
 public:
  // twice: a second play holds the first to account. failure_record: the file for the recording of a match that fails;
  // empty: none. server: who may start workers more cheaply, outlives this; null: nobody. Throws std::system_error when
  // a worker cannot be started.
  MatchRun(Job job, const Limits& limits, bool twice, std::string failure_record, ForkServer* server = nullptr);
  MatchRun(const MatchRun&) = delete;  // its worker writes into its note
  MatchRun& operator=(const MatchRun&) = delete;

  const Job& job() const { return job_; }
  const Worker& worker() const { return *worker_; }

  // True when the match is decided. To be called when a descriptor of the worker is readable and every now and then.
  // Throws CampaignError, std::system_error.
  bool advance();

  // When it is decided:
  const Decided& decided() const { return *decided_; }
  int plays() const { return plays_; }  // that it took, without those that only record
  // How a worker died, though the match was then played to its end; else empty.
  const std::string& accident() const { return accident_; }
  const std::string& not_recorded() const { return not_recorded_; }  // why not, though it should be; else empty

 private:
  enum class Stage {
    first,
    second,         // holds the first one to account, where that is asked for: each robot in a process, and elsewhere
    isolated,       // each team in a process: whose fault a death was
    alone,          // each robot in a process, here: whether it was that which made the second play fail
    traced,         // where two plays differ: as the first one, but elsewhere. If that is the first one once more:
    traced_alone,   //   each robot in a process, elsewhere. If that is the first one, too:
    traced_hiding,  //   as the first one, elsewhere, without what plugins do not declare to read
    traced_here,    // else: as the first one
    recording,
  };
  // Whether what plugins answer is kept in that play.
  static bool is_traced(Stage stage) { return stage >= Stage::traced && stage <= Stage::traced_here; }
  bool isolated(Stage stage) const;
  Separation separation(Stage stage) const;
  void start(Stage stage);
  void settle();
  void blame_nobody_for_overwritten_files(const std::string& what) const;
  void played(const Answer& answer);
  void failed(Attempt attempt);
  void compare(const Decided& again);
  void explanation_failed(const Attempt& attempt, const std::optional<Answer>& answer);
  void decide_different();
  void decide_first();
  void note_outside(const OutsideNote& outside);
  void decide(Decided decided);
  void recorded(const End& end, const std::optional<Answer>& answer);

  Job job_;
  Limits limits_;
  bool twice_;
  std::string failure_record_;
  ForkServer* server_;
  std::vector<std::pair<std::string, plugin::FileStamp>> plugin_files_;  // before they were opened
  Stage stage_ = Stage::first;
  SharedNote note_;
  std::unique_ptr<TrailFile> trail_;
  std::string first_trail_;
  std::optional<Failure> second_failure_;
  std::size_t killed_ = 0;  // plays after the first one, from outside
  bool alone_ = false;      // a play with each robot in a process of its own has come to its end
  std::unique_ptr<Worker> worker_;
  std::vector<Attempt> attempts_;
  std::optional<Decided> first_;  // the first play, and what was found when it was held to account
  std::optional<Decided> decided_;
  bool complete_ = false;
  int plays_ = 0;
  double seconds_ = 0.0;
  std::string accident_, not_recorded_, output_;
};

}  // namespace regista::campaign
