// SPDX-License-Identifier: MIT
// A study that is played by many machines, as a folder that all of them see:
// clang-format off
//
//   cluster.json    how it is played, and how far it has come
//   results.db      the file of results: the plan, and all matches that were gathered
//   plan.db         the same without any match, for the tasks
//   bin/regista     the program
//   files/          documents, plugins and data that the study reads, each at its absolute path: editing one while the
//                   study is played changes nothing
//   batches/B.json  which matches the tasks of batch B play
//   batches/B.db    what they need to know of earlier rounds, if there are any
//   parts/B-T.db    what task T of batch B has played, once it has ended; B-T.db.part while it plays
//   parts/B-T.txt   how far it has come; B-T.refused: why it plays nothing
//   set_aside/      parts with matches that do not fit
//   log/            what tasks wrote
//
// clang-format on
// results.db and cluster.json are written by whoever holds results.db, a part by its task. What a task tells of itself
// appears by renaming: file systems that several machines share promise little more.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "campaign/job.hpp"
#include "campaign/store.hpp"

namespace regista::cluster {

// A task of an array: its batch, from 1, and its place in that, from 0.
struct TaskName {
  std::uint64_t batch = 0, task = 0;
  friend auto operator<=>(const TaskName&, const TaskName&) = default;
};

struct Settings {
  std::string scheduler = "slurm";
  std::uint64_t tasks = 64;          // of a batch, at most
  std::uint64_t matches = 100;       // of a task, at most
  std::uint64_t workers = 1;         // of a task
  std::string partition, time;       // as sbatch understands them; empty: its defaults
  std::vector<std::string> options;  // more of them
  std::uint64_t record_every = 0;    // 0: none but matches that fail
  std::vector<std::string> plugin_files;
};

struct SubmittedBatch {
  std::uint64_t number = 0, tasks = 0, matches = 0;
  std::uint64_t rows_before = 0;  // matches in the file of results when it was submitted
  std::string array_job, gather_job;
};

struct Progress {
  enum class State { running, complete, stopped, failed };
  State state = State::running;
  std::string message;  // one line: why it stopped or failed
  std::vector<SubmittedBatch> batches;
  std::uint64_t fruitless = 0;             // batches in a row that brought no match
  std::vector<std::string> refused_nodes;  // which play nothing, and are left out from then on
  std::vector<std::string> remarks;        // about parts and nodes, a line each; the last ones
  // As it was when it was gathered last.
  std::string title, finding;           // finding: in the matches there were without a gap; empty: none yet
  std::uint64_t matches = 0, rows = 0;  // of the study; in the file of results
};

const char* name_of(Progress::State state);  // "running"

class StudyFolder {
 public:
  explicit StudyFolder(const std::filesystem::path& root);  // absolute from then on; need not be there

  const std::filesystem::path& root() const { return root_; }
  std::filesystem::path description() const { return root_ / "cluster.json"; }
  std::filesystem::path results() const { return root_ / "results.db"; }
  std::filesystem::path plan() const { return root_ / "plan.db"; }
  std::filesystem::path program() const { return root_ / "bin" / "regista"; }
  std::filesystem::path files() const { return root_ / "files"; }
  std::filesystem::path parts() const { return root_ / "parts"; }
  std::filesystem::path set_aside() const { return root_ / "set_aside"; }
  std::filesystem::path logs() const { return root_ / "log"; }
  std::filesystem::path batch(std::uint64_t number) const;
  std::filesystem::path known_before(std::uint64_t number) const;
  std::filesystem::path part(const TaskName& task) const;
  std::filesystem::path under_way(const TaskName& task) const;
  std::filesystem::path course(const TaskName& task) const;
  std::filesystem::path refusal(const TaskName& task) const;

  // Makes the folder and those in it, with the description. Throws BadInput where one stands there already, or where it
  // cannot be made.
  void create(const Settings& settings) const;
  // Copies of these files, whose paths are absolute, and of the program that runs. Throws BadInput, WriteError.
  void copy_in(const std::vector<std::filesystem::path>& files) const;

  // Throw BadInput for a folder that is none of a study.
  Settings settings() const;
  Progress progress() const;
  // As a whole. Throw WriteError.
  void write(const Progress& progress) const;
  void write(const Settings& settings) const;

  // The copy of a file.
  std::filesystem::path copy_of(const std::filesystem::path& file) const { return files() / file.relative_path(); }
  // The study without its matches, from its file of results, for tasks. Throws campaign::StoreError, WriteError.
  void write_plan(const campaign::Store& results, const std::string& program_version) const;

  // A match of the study as a task plays it: of the copies. given_in: the folder in which the study was begun.
  campaign::Job of_copies(campaign::Job job, const std::filesystem::path& given_in, const Settings& settings) const;

 private:
  std::filesystem::path root_;
};

}  // namespace regista::cluster
