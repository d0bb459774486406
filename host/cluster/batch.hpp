// SPDX-License-Identifier: MIT
// Finds the matches that a study on a cluster still needs, and divides them among the tasks of a Slurm job array.
#pragma once

#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "campaign/store.hpp"
#include "study/study.hpp"

namespace regista::cluster {

// A range of indices, counted from 0, of matches in a round (study::Round: matches that can be played in any order):
// from `begin` up to `end`, without `end`.
struct Slice {
  std::uint64_t begin = 0, end = 0;
  friend bool operator==(const Slice&, const Slice&) = default;
};

using Slices = std::vector<Slice>;  // ascending, without empty slices

std::uint64_t matches_of(const Slices& slices);

struct Batch {
  std::uint64_t first_row = 0;  // first row of the round: see study::Round
  bool may_end_early = false;   // the round may end early: see study::Round
  std::vector<Slices> tasks;
  std::uint64_t matches() const;
  friend bool operator==(const Batch&, const Batch&) = default;
};

// A match that is played twice takes as long as this number of other matches, because its second play uses a process
// for each mind (benchmarks/README.md, "Clusters").
inline constexpr std::uint64_t weight_of_twice = 6;

// Divides `places` (indices of matches in a round) among at most `tasks` tasks of about equal length. A task gets at
// most `most` places; a place that is in `twice` (ascending), because its match is played twice, counts as
// weight_of_twice places. The last places get no task if no task has room.
std::vector<Slices> shared_out(const Slices& places, const std::vector<std::uint64_t>& twice, std::uint64_t most,
                               std::uint64_t tasks);

std::string to_json(const Batch& batch);
// Throws std::invalid_argument for a text that is not from to_json().
Batch batch_from_json(const std::string& text);

// --- The matches that a study still needs, given the matches in a file of results.

struct Missing {
  std::uint64_t first_row = 0;       // first row of the current round: see study::Round
  Slices places;                     // places of the current round without a result, ascending
  std::vector<std::uint64_t> twice;  // the places that are played twice
  std::uint64_t round = 0;           // number of matches in the current round
  bool may_end_early = false;        // true: the current round may end early, see study::Round
  std::uint64_t seen = 0;            // number of results that the study has taken: all before the first missing match
  bool is_first = true;              // true: the current round is the first round of the study
  bool complete() const { return places.empty(); }
};

// Passes the stored results to the study and stores the fixtures of its current round. Returns at most `most` places,
// and of equal matches only the first place. Throws campaign::StoreError, study::StudyError.
Missing missing_of(study::Study& study, campaign::Store& store, std::uint64_t most);

// --- Slurm through its commands sbatch, squeue and scancel. These commands know the settings of the cluster and the
// rights of the user, and Slurm users understand their error messages.
//
// Options and job arrays: sbatch(1), "--array", "--dependency", "--parsable", "--requeue".

// Thrown if a command of Slurm is missing or fails. what() is one line.
class SlurmError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct JobRequest {
  std::string name;
  std::filesystem::path script;  // the shell of the node executes this script
  std::vector<std::string> arguments{};
  std::string output;            // file for standard output and error, a pattern of sbatch: see in_pattern()
  std::uint64_t tasks = 0;       // number of tasks of an array, numbered from 0; 0: no array
  std::uint64_t processors = 1;  // processors of each task
  std::string after{};           // job that must end before this job starts, even if it fails; empty: no such job
  std::vector<std::string> options{};
};

// Returns a path as a file-name pattern of sbatch, in which "%%" stands for "%".
std::string in_pattern(const std::filesystem::path& path);

// Submits a job and returns its number. Throws SlurmError.
std::string submit(const JobRequest& request);
// Returns the waiting and running jobs among `jobs`. Throws SlurmError.
std::vector<std::string> alive(const std::vector<std::string>& jobs);
// Returns the waiting or running job with this request's name and folder; empty if there is none. Throws SlurmError.
std::string job_of(const JobRequest& request);
// Ends these jobs. A job that has already ended is not an error. Throws SlurmError.
void cancel(const std::vector<std::string>& jobs);

// Returns whether this process belongs to one of these jobs or to a task of one of these jobs.
bool is_within(const std::vector<std::string>& jobs);

}  // namespace regista::cluster
