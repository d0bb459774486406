// SPDX-License-Identifier: MIT
// The folder of a study that many machines play. All these machines share the folder:
// clang-format off
//
//   cluster.json    the settings and the progress of the study
//   results.db      the file of results: the plan, and all matches that were gathered
//   plan.db         the plan without matches, for the tasks
//   bin/regista     a copy of the program
//   files/          copies of documents, plugins and data that the study reads, each at its absolute path: the study
//                   does not change if a user edits the original files
//   batches/B.json  the matches that each task of batch B plays
//   batches/B.db    the results of earlier rounds, for the tasks of batch B; missing in the first round
//   parts/B-T.db    the matches of task T of batch B after the end of the task; B-T.db.part while the task runs
//   parts/B-T.txt   the progress of the task; B-T.refused: the reason why the task plays nothing
//   set_aside/      parts that are damaged or contain refused matches
//   log/            the output of the tasks
//
// clang-format on
// Only a process that has locked results.db writes results.db and cluster.json. Only a task writes its part. A task
// publishes a file by renaming it, because file systems that several machines share guarantee little more.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "campaign/job.hpp"
#include "campaign/store.hpp"

namespace regista::cluster {

// --- Small files in a folder that several machines share. A writer replaces a file by renaming a new file, even while
// a reader reads. On a network file system the reader may then get ESTALE (see nfs(5)), although the file exists.

// Reads the whole file. Returns 0 or the error number (errno).
using ReadOnce = std::function<int(const std::filesystem::path& file, std::string& out)>;
int read_once(const std::filesystem::path& file, std::string& out);

// Reads a file; tries again after ESTALE. Returns nothing for a missing file. Throws std::system_error on other errors.
std::optional<std::string> shared_content(const std::filesystem::path& file, const ReadOnce& read = read_once,
                                          std::chrono::milliseconds between_tries = std::chrono::milliseconds(100));

// A task of an array: the number of its batch, from 1, and its index in the batch, from 0.
struct TaskName {
  std::uint64_t batch = 0, task = 0;
  friend auto operator<=>(const TaskName&, const TaskName&) = default;
};

struct Settings {
  std::string scheduler = "slurm";
  std::uint64_t tasks = 64;          // largest number of tasks in a batch
  std::uint64_t matches = 100;       // largest number of matches in a task
  std::uint64_t workers = 1;         // workers of each task
  std::string partition, time;       // in the form of sbatch; empty: defaults of sbatch
  std::vector<std::string> options;  // more options for sbatch
  std::uint64_t record_every = 0;    // 0: record only failed matches
  std::vector<std::string> plugin_files;
};

struct SubmittedBatch {
  std::uint64_t number = 0, tasks = 0, matches = 0;
  std::uint64_t rows_before = 0;  // matches in the file of results at submission
  std::string array_job{}, gather_job{};
};

struct Progress {
  enum class State { running, complete, stopped, failed };
  State state = State::running;
  std::string message;  // one line: the reason of a stop or failure, or a remark about a complete study
  std::vector<SubmittedBatch> batches;
  std::uint64_t fruitless = 0;             // consecutive batches without a new match
  std::vector<std::string> refused_nodes;  // nodes that refused to play; later batches exclude them
  std::vector<std::string> remarks;        // the latest remarks about parts and nodes, one line each
  // State at the last gathering.
  std::string title, finding;           // finding: from the results before the first missing match; empty: none yet
  std::uint64_t matches = 0, rows = 0;  // matches of the study; rows of the file of results
};

const char* name_of(Progress::State state);  // "running"

class StudyFolder {
 public:
  explicit StudyFolder(const std::filesystem::path& root);  // the stored path is absolute; the folder may be missing

  const std::filesystem::path& root() const { return root_; }
  std::string name() const;                     // root() for messages
  std::string command(const char* verb) const;  // for a shell: "regista VERB FOLDER"
  std::filesystem::path description() const { return root_ / "cluster.json"; }
  std::filesystem::path results() const { return root_ / "results.db"; }
  std::filesystem::path plan() const { return root_ / "plan.db"; }
  std::filesystem::path program() const { return root_ / "bin" / "regista"; }
  std::filesystem::path files() const { return root_ / "files"; }
  std::filesystem::path parts() const { return root_ / "parts"; }
  std::filesystem::path set_aside() const { return root_ / "set_aside"; }
  std::filesystem::path logs() const { return root_ / "log"; }
  std::filesystem::path batch(std::uint64_t number) const { return in_batches(number, ".json"); }
  std::filesystem::path known_before(std::uint64_t number) const { return in_batches(number, ".db"); }
  std::filesystem::path part(const TaskName& task) const { return in_parts(task, ".db"); }
  std::filesystem::path under_way(const TaskName& task) const { return in_parts(task, ".db.part"); }
  std::filesystem::path progress(const TaskName& task) const { return in_parts(task, ".txt"); }
  std::filesystem::path refusal(const TaskName& task) const { return in_parts(task, ".refused"); }

  // Creates the folder, its subfolders and cluster.json. Throws BadInput if the folder exists or cannot be created.
  void create(const Settings& settings) const;
  // Copies these files, which have absolute paths, and the running program. Throws BadInput, WriteError.
  void copy_in(const std::vector<std::filesystem::path>& files) const;

  // settings() and progress() read cluster.json. Both functions throw BadInput if the folder is not a study folder.
  Settings settings() const;
  Progress progress() const;
  // Replace the progress or the settings in cluster.json by writing a whole new file. Both functions throw WriteError.
  void write(const Progress& progress) const;
  void write(const Settings& settings) const;

  // Returns the path of the copy of `file`, an absolute path.
  std::filesystem::path copy_of(const std::filesystem::path& file) const { return files() / file.relative_path(); }
  // Writes plan.db: the content of `results` without the matches. Throws campaign::StoreError, WriteError.
  void write_plan(const campaign::Store& results) const;

  // Returns `job` with the paths of the copied files. given_in: the folder in which the user began the study.
  campaign::Job of_copies(campaign::Job job, const std::filesystem::path& given_in, const Settings& settings) const;

 private:
  std::filesystem::path in_batches(std::uint64_t number, const char* ending) const {
    return root_ / "batches" / (std::to_string(number) + ending);
  }
  std::filesystem::path in_parts(const TaskName& task, const char* ending) const {
    return parts() / (std::to_string(task.batch) + '-' + std::to_string(task.task) + ending);
  }

  std::filesystem::path root_;
};

// --- Results of tasks, and their transfer into the file of results of the study.

struct Gathered {
  std::uint64_t rows = 0;            // newly added matches
  std::uint64_t refused = 0;         // refused matches (campaign::Taken); their part moves to set_aside/
  std::vector<std::string> remarks;  // one line each
  std::vector<std::string> refused_nodes;
};

// The tasks whose parts are gathered. killed_too: also unfinished parts of killed tasks that do not run again.
enum class Tasks { ended, killed_too };

// Adds the matches of the parts to `results`, and removes each part that was added completely. A part that is damaged
// or has a refused match (see campaign::Taken) is moved to set_aside/, and its matches count as not played. Throws
// campaign::StoreError for an error of `results` or of the disk, StoreRefusal for a part that cannot be opened now.
Gathered gather(const StudyFolder& folder, campaign::Store& results, Tasks tasks);

struct TaskProgress {
  std::uint64_t done = 0, all = 0;      // done: decided matches of the task; all: all matches of the task
  std::uint64_t fresh = 0, failed = 0;  // fresh: matches decided since the last start of the task; failed: matches of
                                        // `done` that were forfeited or set aside
  double seconds = 0.0;                 // s of this node's steady clock since the last start of the task
  bool ended = false;
  std::string node;
};

std::string to_json(const TaskProgress& progress);
// Throws std::invalid_argument for a text that is not from to_json().
TaskProgress progress_from_json(const std::string& text);

// Returns the progress of tasks with matches that have not been gathered yet, by task name.
std::vector<TaskProgress> task_progress(const StudyFolder& folder);

// Tells gather() that a node plays nothing, because matches on this node would have other results. why: one line.
void write_refusal(const StudyFolder& folder, const TaskName& task, const std::string& node, const std::string& why);

// Replaces the progress file of the task. A reader sees either the old or the new file.
void write_progress(const StudyFolder& folder, const TaskName& task, const TaskProgress& progress);

}  // namespace regista::cluster
