// SPDX-License-Identifier: MIT
// Plays one match, in one worker after the other, until the match is decided. No function blocks.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "campaign/blame.hpp"
#include "campaign/decision_trail.hpp"
#include "campaign/job.hpp"
#include "campaign/worker.hpp"
#include "plugin/shared_object.hpp"
#include "process/file_descriptor.hpp"

namespace regista::campaign {

class MatchRun {
 public:
  // twice: a second play tests the first play. failure_record: file for the recording of a match that fails; empty:
  // none. server: a fork server, which must outlive this object; null: none. Throws std::system_error.
  MatchRun(Job job, const Limits& limits, bool twice, std::string failure_record, ForkServer* server = nullptr);
  MatchRun(const MatchRun&) = delete;  // not copyable, because the worker writes into note_
  MatchRun& operator=(const MatchRun&) = delete;

  const Job& job() const { return job_; }
  const Worker& worker() const { return *worker_; }

  // Returns true when the match is decided. Must be called when a descriptor of the worker is readable, and also at
  // regular times. Throws CampaignError and std::system_error.
  bool advance();

  // --- Precondition: advance() has returned true.
  const MatchResult& decided() const { return *decided_; }
  int plays() const { return plays_; }  // number of plays, without plays that only record the match
  // Says how a worker died, if another worker then played the match to its end; otherwise empty.
  const std::string& accident() const { return accident_; }
  const std::string& not_recorded() const { return not_recorded_; }  // why the recording is missing; usually empty

 private:
  // The purpose of a play. "Perturbed": in another folder, environment and date, at other addresses. With
  // Limits::allow_shared_memory, "one process for each robot" becomes one process for each team.
  enum class Stage {
    first,          // plays the match for the first time
    second,         // tests the first play: perturbed, one process for each robot
    isolated,       // after the worker died: one process for each team, to find the team whose process dies
    alone,          // after a failed second play: not perturbed, one process for each robot
    traced,         // after plays with different results: perturbed, with the processes of the first play
    traced_alone,   // if `traced` had the result of `first`: perturbed, one process for each robot
    traced_hiding,  // if `traced_alone` had the result of `first`: perturbed, plugins do not see undeclared inputs
    traced_here,    // if `traced` had another result: not perturbed, with the processes of the first play
    recording,      // only records the match, with all minds in one process
  };
  static bool is_traced(Stage stage) { return stage >= Stage::traced && stage <= Stage::traced_here; }
  bool isolated(Stage stage) const;
  Separation separation(Stage stage) const;
  void start(Stage stage);
  void settle();
  void blame_nobody_for_overwritten_files(const std::string& what) const;
  void played(const Answer& answer);
  void failed(Attempt attempt);
  void compare(const MatchResult& again);
  void explanation_failed(const Attempt& attempt, const std::optional<Answer>& answer);
  void decide_different();
  void decide_first();
  void note_outside(const OutsideNote& outside);
  void decide(MatchResult decided);
  void recorded(const End& end, const std::optional<Answer>& answer);

  Job job_;
  Limits limits_;
  bool twice_;
  std::string failure_record_;
  ForkServer* server_;
  std::vector<std::pair<std::string, plugin::FileStamp>> plugin_files_;  // stamps made before the files were opened
  Stage stage_ = Stage::first;
  SharedNote note_;
  process::FileDescriptor trail_;
  std::string first_trail_;
  std::optional<Failure> second_failure_;
  std::size_t killed_ = 0;  // number of plays after the first that were killed from outside
  bool alone_ = false;      // true: a play with one process for each robot came to its end
  std::unique_ptr<Worker> worker_;
  std::vector<Attempt> attempts_;
  std::optional<MatchResult> first_;  // the result of the first play, with the findings of later plays
  std::optional<MatchResult> decided_;
  bool complete_ = false;
  int plays_ = 0;
  double seconds_ = 0.0;
  std::string accident_, not_recorded_, output_;
};

}  // namespace regista::campaign
