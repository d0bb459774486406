// SPDX-License-Identifier: MIT
// Plays the matches of a schedule in parallel, each in a worker. Stored matches are not played again. The caller gets
// results in the order of the schedule, so reports do not depend on the number of workers. The schedule is a function,
// and only matches near the first undecided one are begun, so memory does not grow with their number.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "campaign/blame.hpp"
#include "campaign/job.hpp"
#include "campaign/store.hpp"
#include "config/match_settings.hpp"

namespace regista::campaign {

// --- How the matches of a study are played and where they are stored. These options are not part of the study and may
// change between runs. Values are stored as the user typed them. Times are in the local time zone of the machine.

using Moment = std::chrono::system_clock::time_point;

// Returns the moment from which a study begins no more matches. until: "08:00" (the next 08:00 of the clock), or
// "2026-11-28T08:00"; minutes: "90", counted from `now`. Returns nothing if both texts are empty. Throws BadInput if
// both texts are given, if the time is past, or if a text is not a time.
std::optional<Moment> end_of_time(const std::string& until, const std::string& minutes, Moment now);

// Returns the local time as "2026-11-28 08:00".
std::string in_words(Moment moment);

struct Options {
  std::vector<std::string> plugins;   // folders of plugins
  std::string workers, record_every;  // numbers; if empty: a worker for each core, only failed matches recorded
  std::string until, minutes;         // see end_of_time()
  std::string results;
  std::string notify;  // a command of the shell that runs when the study has ended
  bool resume = false, json = false, quiet = false, no_page = false;
  bool live = false;  // true: the study's HTML page is also rewritten while the study runs
  // What the run plays; not set by the user. what_is_missing: all matches that the file of results lacks. nothing_yet:
  // no match, because the run only creates the file. nothing_more: no match, because the file holds all matches.
  enum class Plays { what_is_missing, nothing_yet, nothing_more } plays = Plays::what_is_missing;
  std::vector<std::string> plugin_files;  // set by the program: files in the folders of `plugins`
  std::optional<Moment> end_of_time;      // set by the program: check() computes this time from `until` and `minutes`
};

// Throws BadInput for a bad option. Must be called before files are created. The time `minutes` begins at this call.
void check(Options& options);

// number_of_workers() and record_every() throw BadInput for a text that is no such number.
int number_of_workers(const Options& options);
std::uint64_t record_every(const Options& options);  // 0: only failed matches are recorded

Limits limits_of(const config::MatchSettings& settings);

struct Schedule {
  std::uint64_t matches = 0;
  std::uint64_t first_row = 0;  // the store keeps match `index` in row first_row + index + 1
  // Returns the key of the match at this place, counted from 0; nothing if the study no longer needs the match.
  std::function<std::optional<MatchKey>(std::uint64_t index)> at;
  // The job of the match; called only when the match is going to be played.
  std::function<Job(std::uint64_t index)> job;
  // Receives the results in the order of indices; `decided` is null if `at` returned nothing. fresh: true if this run
  // has played the match, false if the result was stored. Returns false to end the run early.
  std::function<bool(std::uint64_t index, const MatchResult* decided, bool fresh)> take;
  Metrics metrics = Metrics::left_out;  // metrics to read with stored results
  // Returns whether this match is played twice to test its reproducibility. May be empty.
  std::function<bool(std::uint64_t index)> twice;
  // Returns the file for the recording of a match that fails; empty: no recording. The engine plays the match again for
  // this recording, which ends with the failure. The function may be empty.
  std::function<std::string(std::uint64_t index)> record_failure;
  // Called for a match that was played but could not be recorded. May be empty.
  std::function<void(const Job& job, const std::string& why)> not_recorded;
  // Called for a match whose worker died, if another play of the match succeeded. May be empty.
  std::function<void(const Job& job, const std::string& what)> accident;
  std::function<bool()> asked_to_stop;  // whether the run must stop; called about ten times a second
  // true: the engine begins no more matches, and ends when the running matches have ended. May be empty.
  std::function<bool()> out_of_time;
};

// The reason why run() ended. complete: all matches are decided. enough: Schedule::take returned false. interrupted:
// Schedule::asked_to_stop returned true. out_of_time: Schedule::out_of_time returned true, and `take` has received the
// results of all places before the first match that was not begun.
enum class Finish { complete, enough, interrupted, out_of_time };

// Plays the schedule. Throws CampaignError, StoreError and std::system_error; stored matches stay in the store.
Finish run(const Schedule& schedule, Store& store, int workers, const Limits& limits);

// Plays one match until it is decided, as run() does, but does not store it. Throws CampaignError, std::system_error.
MatchResult play_alone(const Job& job, const Limits& limits);

}  // namespace regista::campaign
