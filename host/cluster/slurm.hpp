// SPDX-License-Identifier: MIT
// Slurm by its own commands: sbatch, squeue, scancel. They know the cluster's settings and the user's rights; what they
// write about an error is what a user of Slurm understands.
//
// Options and job arrays: sbatch(1), "--array", "--dependency", "--parsable", "--requeue".
#pragma once

#include <cstdint>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace regista::cluster {

// A command of Slurm is absent or says no: what() is one line.
class SlurmError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct JobRequest {
  std::string name;
  std::filesystem::path script;  // is executed by the node's shell
  std::vector<std::string> arguments;
  std::string output;            // file for its standard output and error, a pattern of sbatch: see in_pattern()
  std::uint64_t tasks = 0;       // an array with so many tasks, from 0; 0: none
  std::uint64_t processors = 1;  // of each task
  std::string after;             // the job that has to end first, in whatever way; empty: none
  std::vector<std::string> options;
};

// A path in such a pattern.
std::string in_pattern(const std::filesystem::path& path);

// The number of the job. Throws SlurmError.
std::string submit(const JobRequest& request);
// Those of these jobs that wait or run. Throws SlurmError.
std::vector<std::string> alive(const std::vector<std::string>& jobs);
// The job that this request has become, by its name and folder, if it waits or runs: for who does not know whether it
// was submitted. Empty: there is none. Throws SlurmError.
std::string job_of(const JobRequest& request);
// Ends these jobs; what has ended already is no error. Throws SlurmError.
void cancel(const std::vector<std::string>& jobs);

// Whether the job of this process is one of them, or a task of one.
bool is_within(const std::vector<std::string>& jobs);

}  // namespace regista::cluster
