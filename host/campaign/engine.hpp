// SPDX-License-Identifier: MIT
// Plays the matches of a schedule, several at a time, each in a worker. Knows nothing of what they are good for.
//
// What was stored is not played again. Results are handed on in the order of the schedule, never in that in which
// matches end, so what is made of them does not depend on the number of workers. Memory does not grow with the number
// of matches: the schedule is a function, and who runs ahead waits.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>

#include "campaign/blame.hpp"
#include "campaign/job.hpp"
#include "campaign/store.hpp"
#include "campaign/worker.hpp"

namespace regista::campaign {

struct Schedule {
  std::uint64_t matches = 0;
  std::uint64_t first_row = 0;  // match `index` is kept in the row first_row + index + 1 of the store
  // What is to be played at this place, from 0 on; nothing when it is not wanted any more. Else a pure function.
  std::function<std::optional<MatchKey>(std::uint64_t index)> at;
  // The match itself; asked for only when it is to be played.
  std::function<Job(std::uint64_t index)> job;
  // Called in the order of indices, for those not wanted without a result. `fresh`: played now, not read from the
  // store. False: enough, nothing more is needed.
  std::function<bool(std::uint64_t index, const Decided* decided, bool fresh)> take;
  Metrics metrics = Metrics::left_out;  // of results read from the store
  // The file for the recording of a match that fails, at the end of which it fails once more; empty: none. May itself
  // be empty.
  std::function<std::string(std::uint64_t index)> record_failure;
  // A match was played, but could not be recorded. May be empty.
  std::function<void(const Job& job, const std::string& why)> not_recorded;
  // A worker died over this match, but the next one did not: an accident of the machine. May be empty.
  std::function<void(const Job& job, const End& death)> accident;
  std::function<bool()> asked_to_stop;  // looked at ten times a second
};

// Matches cannot be played on: what() is one line that says why.
class CampaignError : public std::runtime_error {
 public:
  enum class Kind {
    input,    // a file changed while the campaign ran, or cannot be used any more
    machine,  // workers die before any plugin is called, or are killed again and again
  };
  CampaignError(Kind kind, const std::string& message) : std::runtime_error(message), kind_(kind) {}
  Kind kind() const { return kind_; }

 private:
  Kind kind_;
};

enum class Finish { complete, enough, interrupted };

// Throws CampaignError, StoreError, std::system_error. What was stored until then stays.
Finish run(const Schedule& schedule, Store& store, int workers, const Limits& limits);

// One match by itself, in workers with limits, and who forfeits it. Throws as run().
Decided play_alone(const Job& job, const Limits& limits);

}  // namespace regista::campaign
