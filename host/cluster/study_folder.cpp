// SPDX-License-Identifier: MIT
#include "cluster/study_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <fstream>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <thread>

#include "campaign/stored_setup.hpp"
#include "config/errors.hpp"
#include "output/replaced_file.hpp"
#include "process/child.hpp"
#include "process/file_descriptor.hpp"
#include "texts/json.hpp"
#include "texts/message.hpp"

namespace regista::cluster {

NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(TaskProgress, done, all, fresh, failed, seconds, ended, node)

int read_once(const std::filesystem::path& file, std::string& out) {
  out.clear();
  const process::FileDescriptor opened(::open(file.c_str(), O_RDONLY | O_CLOEXEC));
  if (opened.number == -1) return errno;
  std::array<char, 65536> part;
  for (;;) {
    const ssize_t size = process::uninterrupted([&] { return ::read(opened.number, part.data(), part.size()); });
    if (size <= 0) return size == 0 ? 0 : errno;
    out.append(part.data(), static_cast<std::size_t>(size));
  }
}

std::optional<std::string> shared_content(const std::filesystem::path& file, const ReadOnce& read,
                                          std::chrono::milliseconds between_tries) {
  constexpr int most_tries = 50;
  std::string out;
  for (int i = 1;; ++i) {
    const int error = read(file, out);
    if (error == 0) return out;
    if (error == ENOENT || error == ENOTDIR) return std::nullopt;
    if (error != ESTALE || i == most_tries) throw std::system_error(error, std::generic_category(), file.string());
    std::this_thread::sleep_for(between_tries);
  }
}

// Names of the states in cluster.json, in the order of the states.
static constexpr std::array state_names{"running", "complete", "stopped", "failed"};
static void to_json(nlohmann::json& json, Progress::State state) { json = name_of(state); }
static void from_json(const nlohmann::json& json, Progress::State& out) {
  const auto found = std::ranges::find_if(state_names, [&](const char* each) { return json == each; });
  if (found == state_names.end()) throw std::invalid_argument("no such state");
  out = static_cast<Progress::State>(found - state_names.begin());
}
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Settings, scheduler, tasks, matches, workers, partition, time, options, record_every,
                                   plugin_files)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(SubmittedBatch, number, tasks, matches, rows_before, array_job, gather_job)
NLOHMANN_DEFINE_TYPE_NON_INTRUSIVE(Progress, state, message, batches, fruitless, refused_nodes, remarks, title, finding,
                                   matches, rows)

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::json;
using config::BadInput;

constexpr int layout = 1;  // version of the folder's layout

std::optional<std::string> content_of(const fs::path& file) {
  try {
    return shared_content(file);
  } catch (const std::system_error& error) {
    throw BadInput(fmt::format("{} cannot be read: {}", texts::one_line(file.string()), error.code().message()));
  }
}

std::string damaged(const StudyFolder& folder) {
  return fmt::format("{} is damaged", texts::one_line(folder.description().string()));
}

Json description_of(const StudyFolder& folder) {
  const fs::path file = folder.description();
  const auto text = content_of(file);
  if (!text)
    throw BadInput(fmt::format("{} is no folder of a study on a cluster: it has no cluster.json", folder.name()));
  Json json = Json::parse(*text, nullptr, false);
  if (!json.is_object()) throw BadInput(damaged(folder));
  if (json.value("study_folder", nlohmann::json()) != layout)
    throw BadInput(fmt::format("{} was written by another version of Regista", texts::one_line(file.string())));
  return json;
}

template <class Part>
Part part_of(const StudyFolder& folder, const char* name) {
  try {
    return description_of(folder).at(name).get<Part>();
  } catch (const nlohmann::json::exception&) {
    throw BadInput(damaged(folder));
  } catch (const std::invalid_argument&) {
    throw BadInput(damaged(folder));
  }
}

void write_description(const StudyFolder& folder, const Json& settings, const Json& progress,
                       output::Existing existing) {
  const Json all{{"study_folder", layout}, {"settings", settings}, {"progress", progress}};
  output::write_whole(folder.description(), all.dump(2, ' ', false, Json::error_handler_t::replace) + '\n', existing);
}

void copy_whole(const fs::path& from, const fs::path& to) {
  std::error_code error;
  fs::create_directories(to.parent_path(), error);
  if (!error) fs::copy_file(from, to, fs::copy_options::skip_existing, error);
  if (!error) return;
  if (error == std::errc::no_such_file_or_directory)
    throw BadInput(fmt::format("{}: no such file any more", texts::one_line(from.string())));
  throw output::WriteError(fmt::format("cannot copy {} to {}: {}", texts::one_line(from.string()),
                                       texts::one_line(to.string()), error.message()));
}

}  // namespace

const char* name_of(Progress::State state) { return state_names.at(static_cast<std::size_t>(state)); }

StudyFolder::StudyFolder(const fs::path& root) : root_(fs::absolute(root).lexically_normal()) {
  if (!root_.has_filename()) root_ = root_.parent_path();
}

std::string StudyFolder::name() const { return texts::one_line(root_.string()); }

std::string StudyFolder::command(const char* verb) const {
  return process::shell_line({"regista", verb, root_.string()});
}

void StudyFolder::create(const Settings& settings) const {
  std::error_code error;
  if (fs::exists(root_, error)) {
    throw BadInput(fmt::format(
        "{} exists already; regista gather {} goes on with a study in it, --folder names another", name(), name()));
  }
  for (const fs::path& each : {root_, root_ / "batches", parts(), set_aside(), logs(), files()}) {
    fs::create_directories(each, error);
    if (error) throw BadInput(fmt::format("cannot make the folder {}: {}", each.string(), error.message()));
  }
  write_description(*this, settings, Progress(), output::Existing::refused);
}

void StudyFolder::copy_in(const std::vector<fs::path>& given) const {
  for (const fs::path& each : given) copy_whole(each, copy_of(each));
  copy_whole("/proc/self/exe", program());
}

Settings StudyFolder::settings() const { return part_of<Settings>(*this, "settings"); }
Progress StudyFolder::progress() const { return part_of<Progress>(*this, "progress"); }

void StudyFolder::write(const Progress& progress) const {
  write_description(*this, settings(), progress, output::Existing::replaced);
}

void StudyFolder::write_plan(const campaign::Store& results) const {
  using campaign::Store;
  const fs::path fresh = plan().string() + ".new";
  std::error_code error;
  fs::remove(fresh, error);
  {
    Store store(fresh, Store::Mode::create, REGISTA_VERSION, campaign::Journal::rollback);
    store.keep(results.documents());
    for (const char* each : {"documents", "schedule"}) store.set_meta(each, results.meta(each));
  }
  fs::rename(fresh, plan(), error);
  if (error) throw output::WriteError(fmt::format("cannot write {}: {}", plan().string(), error.message()));
}

void StudyFolder::write(const Settings& settings) const {
  write_description(*this, settings, progress(), output::Existing::replaced);
}

campaign::Job StudyFolder::of_copies(campaign::Job job, const fs::path& given_in, const Settings& settings) const {
  campaign::Job out = campaign::in_copies(std::move(job), files(), given_in);
  out.root = files().string();
  out.plugin_files.clear();
  for (const std::string& each : settings.plugin_files) out.plugin_files.push_back(copy_of(each).string());
  return out;
}

namespace {

struct Named {
  TaskName task;
  std::string ending;
  fs::path path;
};

// Reads batch and task from a file name such as "12-3.db.part".
std::optional<Named> named(const fs::path& path) {
  const std::string name = path.filename().string();
  const char *at = name.data(), *const end = at + name.size();
  Named out;
  const auto batch = std::from_chars(at, end, out.task.batch);
  if (batch.ec != std::errc() || batch.ptr == end || *batch.ptr != '-') return std::nullopt;
  const auto task = std::from_chars(batch.ptr + 1, end, out.task.task);
  if (task.ec != std::errc()) return std::nullopt;
  out.ending.assign(task.ptr, end);
  out.path = path;
  return out;
}

std::vector<Named> files_of(const StudyFolder& folder, std::string_view ending) {
  std::vector<Named> out;
  std::error_code error;
  for (fs::directory_iterator each(folder.parts(), error), end; !error && each != end; each.increment(error)) {
    if (const auto found = named(each->path()); found && found->ending == ending) out.push_back(*found);
  }
  std::ranges::sort(out, {}, &Named::task);
  return out;
}

void remove_with_journal(const fs::path& file) {
  std::error_code none;
  for (const char* each : {"", "-journal", "-wal", "-shm"}) fs::remove(file.string() + each, none);
}

// Returns the progress text of a task; empty if the file is unreadable at present.
std::string told_in(const fs::path& file) {
  try {
    return shared_content(file).value_or("");
  } catch (const std::system_error&) {
    return {};
  }
}

bool can_be_held(const fs::path& file) {
  const process::FileDescriptor opened(::open(file.c_str(), O_RDWR | O_CLOEXEC));
  if (opened.number == -1 || process::lock_file(opened.number, process::FileLock::exclusive)) return false;
  process::unlock_file(opened.number);
  return true;
}

void set_aside(const StudyFolder& folder, const fs::path& file) {
  std::error_code none;
  fs::path to = folder.set_aside() / file.filename();
  for (int i = 2; fs::exists(to, none); ++i)
    to = folder.set_aside() / fmt::format("{}.{}", file.filename().string(), i);
  fs::rename(file, to, none);
  fs::rename(file.string() + "-journal", to.string() + "-journal", none);
}

class Gathering {
 public:
  Gathering(const StudyFolder& folder, campaign::Store& results) : folder_(folder), results_(results) {}

  Gathered all(Tasks tasks) {
    for (const Named& each : files_of(folder_, ".db")) take(each, tasks);
    if (tasks == Tasks::killed_too) {
      for (const Named& each : files_of(folder_, ".db.part")) take(each, tasks);
    }
    for (const Named& each : files_of(folder_, ".refused")) take_refusal(each);
    return std::move(out_);
  }

 private:
  void remark(const Named& part, const std::string& what) {
    out_.remarks.push_back(texts::one_line(fmt::format("{}: {}", part.path.filename().string(), what)));
  }

  void take(const Named& part, Tasks tasks) {
    using campaign::Store;
    try {
      // The store is opened for writing, because this undoes half-written data of a killed task and detects a running
      // task. The store stays open until its file has been moved away.
      const Store store(part.path, Store::Mode::open, REGISTA_VERSION, campaign::Journal::rollback);
      const campaign::Taken taken = taken_of(store);
      out_.rows += taken.rows;
      out_.refused += taken.refused;
      std::error_code none;
      fs::remove(folder_.progress(part.task), none);
      if (taken.refused == 0) return remove_with_journal(part.path);
      for (const std::string& each : taken.why) remark(part, each);
      set_aside(folder_, part.path);
    } catch (const campaign::StoreInUse&) {
      if (tasks == Tasks::killed_too) remark(part, "a task that should have ended still holds it; it is taken later");
    } catch (const campaign::StoreRefusal& error) {
      if (!fs::exists(part.path)) return;  // the task has ended meanwhile and renamed the file
      if (!can_be_held(part.path)) throw;  // a lock or permission is missing: the file may be valid
      unreadable(part, error.what());
    } catch (const campaign::StoreDiskError&) {
      throw;
    } catch (const campaign::StoreError& error) {
      if (is_of_results(error)) throw;
      unreadable(part, error.what());
    }
  }

  campaign::Taken taken_of(const campaign::Store& store) {
    if (store.meta("schedule").empty()) return {};  // the task was killed before it stored the plan of the study
    if (store.meta("schedule") == results_.meta("schedule")) return results_.take(store);
    campaign::Taken out;
    out.refused = static_cast<std::uint64_t>(store.rows());
    out.why.emplace_back("these are results of another study");
    return out;
  }

  // Returns whether the error concerns the file of results, not a part.
  bool is_of_results(const campaign::StoreError& error) const {
    return std::string_view(error.what()).find(folder_.results().string()) != std::string_view::npos;
  }

  void unreadable(const Named& part, const char* why) {
    remark(part, fmt::format("cannot be read, so that its matches are missing: {}", why));
    std::error_code none;
    fs::remove(folder_.progress(part.task), none);
    set_aside(folder_, part.path);
  }

  void take_refusal(const Named& file) {
    const std::string text = told_in(file.path);
    const auto json = nlohmann::json::parse(text, nullptr, false);
    if (json.is_object() && json.contains("node") && json.contains("why") && json["node"].is_string() &&
        json["why"].is_string()) {
      const std::string node = json["node"], why = json["why"];
      out_.remarks.push_back(texts::one_line(fmt::format("node {} plays nothing: {}", node, why)));
      texts::add_once(out_.refused_nodes, node);
    }
    std::error_code none;
    fs::remove(file.path, none);
  }

  const StudyFolder& folder_;
  campaign::Store& results_;
  Gathered out_;
};

std::string line(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace) + '\n'; }

void replace(const fs::path& file, const std::string& text) {
  const fs::path fresh = file.string() + ".new";
  std::ofstream(fresh, std::ios::binary) << text;
  std::error_code none;  // ignored: the file only informs people and is rewritten soon
  fs::rename(fresh, file, none);
}

}  // namespace

Gathered gather(const StudyFolder& folder, campaign::Store& results, Tasks tasks) {
  return Gathering(folder, results).all(tasks);
}

std::vector<TaskProgress> task_progress(const StudyFolder& folder) {
  std::vector<TaskProgress> out;
  for (const Named& each : files_of(folder, ".txt")) {
    try {
      out.push_back(progress_from_json(told_in(each.path)));
    } catch (const std::invalid_argument&) {
      // The file is unreadable at present. This is ignored, because the task soon replaces the file.
    }
  }
  return out;
}

void write_refusal(const StudyFolder& folder, const TaskName& task, const std::string& node, const std::string& why) {
  replace(folder.refusal(task), line(Json{{"node", node}, {"why", why}}));
}

void write_progress(const StudyFolder& folder, const TaskName& task, const TaskProgress& progress) {
  replace(folder.progress(task), to_json(progress));
}

std::string to_json(const TaskProgress& progress) { return line(Json(progress)); }

TaskProgress progress_from_json(const std::string& text) {
  try {
    return nlohmann::json::parse(text).get<TaskProgress>();
  } catch (const nlohmann::json::exception&) {
    throw std::invalid_argument("no progress of a task");
  }
}

}  // namespace regista::cluster
