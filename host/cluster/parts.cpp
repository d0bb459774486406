// SPDX-License-Identifier: MIT
#include "cluster/parts.hpp"

#include <fcntl.h>
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <string_view>
#include <system_error>

#include "cluster/shared_file.hpp"
#include "process/descriptor.hpp"
#include "texts/json.hpp"
#include "texts/message.hpp"

namespace regista::cluster {
namespace {

namespace fs = std::filesystem;

constexpr const char *whole = ".db", *under_way = ".db.part", *course_ending = ".txt", *refusal_ending = ".refused";

struct Named {
  TaskName task;
  std::string ending;
  fs::path path;
};

// "12-3.db.part"
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

// What a task tells of itself; empty where it is not to be had just now.
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
  Gathering(const StudyFolder& folder, campaign::Store& results, std::string version)
      : folder_(folder), results_(results), version_(std::move(version)) {}

  Gathered all(Tasks tasks) {
    for (const Named& each : files_of(folder_, whole)) take(each, tasks);
    if (tasks == Tasks::killed_too) {
      for (const Named& each : files_of(folder_, under_way)) take(each, tasks);
    }
    for (const Named& each : files_of(folder_, refusal_ending)) take_refusal(each);
    return std::move(out_);
  }

 private:
  void remark(const Named& part, const std::string& what) {
    out_.remarks.push_back(texts::one_line(fmt::format("{}: {}", part.path.filename().string(), what)));
  }

  void take(const Named& part, Tasks tasks) {
    using campaign::Store;
    try {
      // Opened for writing: what a killed task left half written is taken back first, and a task that runs is found.
      // Held until it is out of the way.
      const Store store(part.path, Store::Mode::open, version_, campaign::Journal::rollback);
      const campaign::Taken taken = taken_of(store);
      out_.rows += taken.rows;
      out_.refused += taken.refused;
      std::error_code none;
      fs::remove(folder_.course(part.task), none);
      if (taken.refused == 0) {
        remove_with_journal(part.path);
        return;
      }
      for (const std::string& each : taken.why) remark(part, each);
      set_aside(folder_, part.path);
    } catch (const campaign::StoreInUse&) {
      ++out_.in_use;
      if (tasks == Tasks::killed_too) remark(part, "a task that should have ended still holds it; it is taken later");
    } catch (const campaign::StoreRefusal& error) {
      if (!fs::exists(part.path)) return;  // its task has ended meanwhile: it has another name
      if (!can_be_held(part.path)) throw;  // a lock or a right is missing: it may be sound
      unreadable(part, error.what());
    } catch (const campaign::StoreDiskError&) {
      throw;
    } catch (const campaign::StoreError& error) {
      if (is_of_results(error)) throw;
      unreadable(part, error.what());
    }
  }

  campaign::Taken taken_of(const campaign::Store& store) {
    if (store.meta("schedule").empty()) return {};  // killed before it knew its study
    if (store.meta("schedule") == results_.meta("schedule")) return results_.take(store);
    campaign::Taken out;
    out.refused = static_cast<std::uint64_t>(store.rows());
    out.why.emplace_back("these are results of another study");
    return out;
  }

  // An error of the file of results names that file.
  bool is_of_results(const campaign::StoreError& error) const {
    return std::string_view(error.what()).find(folder_.results().string()) != std::string_view::npos;
  }

  void unreadable(const Named& part, const char* why) {
    remark(part, fmt::format("cannot be read, so that its matches are missing: {}", why));
    std::error_code none;
    fs::remove(folder_.course(part.task), none);
    set_aside(folder_, part.path);
  }

  void take_refusal(const Named& file) {
    const std::string text = told_in(file.path);
    const auto json = nlohmann::json::parse(text, nullptr, false);
    if (json.is_object() && json.contains("node") && json.contains("why") && json["node"].is_string() &&
        json["why"].is_string()) {
      const std::string node = json["node"], why = json["why"];
      out_.remarks.push_back(texts::one_line(fmt::format("node {} plays nothing: {}", node, why)));
      if (std::ranges::find(out_.refused_nodes, node) == out_.refused_nodes.end()) out_.refused_nodes.push_back(node);
    }
    std::error_code none;
    fs::remove(file.path, none);
  }

  const StudyFolder& folder_;
  campaign::Store& results_;
  std::string version_;
  Gathered out_;
};

void replace(const fs::path& file, const std::string& text) {
  const fs::path fresh = file.string() + ".new";
  std::ofstream(fresh, std::ios::binary) << text;
  std::error_code none;  // it tells people how things stand, and is written again soon
  fs::rename(fresh, file, none);
}

}  // namespace

Gathered gather(const StudyFolder& folder, campaign::Store& results, Tasks tasks, const std::string& program_version) {
  return Gathering(folder, results, program_version).all(tasks);
}

std::vector<Course> courses(const StudyFolder& folder) {
  std::vector<Course> out;
  for (const Named& each : files_of(folder, course_ending)) {
    try {
      out.push_back(course_from_json(told_in(each.path)));
    } catch (const std::invalid_argument&) {
      // it is written again soon
    }
  }
  return out;
}

void write_refusal(const StudyFolder& folder, const TaskName& task, const std::string& node, const std::string& why) {
  replace(folder.refusal(task), nlohmann::ordered_json{{"node", node}, {"why", why}}.dump(
                                    -1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) +
                                    '\n');
}

void write_course(const StudyFolder& folder, const TaskName& task, const Course& course) {
  replace(folder.course(task), to_json(course));
}

}  // namespace regista::cluster
