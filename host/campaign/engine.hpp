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
#include <string>

#include "campaign/campaign_error.hpp"
#include "campaign/job.hpp"
#include "campaign/limits.hpp"
#include "campaign/store.hpp"

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
  // Whether this match is to be played twice, to see whether it is reproducible. May be empty.
  std::function<bool(std::uint64_t index)> twice;
  // The file for the recording of a match that fails, at the end of which it fails once more; empty: none. May itself
  // be empty.
  std::function<std::string(std::uint64_t index)> record_failure;
  // A match was played, but could not be recorded. May be empty.
  std::function<void(const Job& job, const std::string& why)> not_recorded;
  // A worker died over this match, but when it was played again none did: an accident of the machine. May be empty.
  std::function<void(const Job& job, const std::string& what)> accident;
  std::function<bool()> asked_to_stop;  // looked at ten times a second
};

enum class Finish { complete, enough, interrupted };

// Throws CampaignError, StoreError, std::system_error. What was stored until then stays.
Finish run(const Schedule& schedule, Store& store, int workers, const Limits& limits);

// One match by itself, in workers with limits, and who forfeits it. `twice`: see Schedule. Throws as run().
Decided play_alone(const Job& job, const Limits& limits, bool twice = false);

}  // namespace regista::campaign
