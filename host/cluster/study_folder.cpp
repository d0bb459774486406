// SPDX-License-Identifier: MIT
#include "cluster/study_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <system_error>
#include <utility>

#include "campaign/document_copies.hpp"
#include "config/bad_input.hpp"
#include "config/file.hpp"
#include "config/json.hpp"
#include "config/text.hpp"
#include "output/output.hpp"
#include "output/replaced_file.hpp"

namespace regista::cluster {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using config::BadInput;

constexpr std::array<std::pair<Progress::State, const char*>, 4> states{{{Progress::State::running, "running"},
                                                                         {Progress::State::complete, "complete"},
                                                                         {Progress::State::stopped, "stopped"},
                                                                         {Progress::State::failed, "failed"}}};

Json json_of(const Settings& settings) {
  return {{"scheduler", settings.scheduler},      {"tasks", settings.tasks},
          {"matches", settings.matches},          {"workers", settings.workers},
          {"partition", settings.partition},      {"time", settings.time},
          {"options", settings.options},          {"record_every", settings.record_every},
          {"plugin_files", settings.plugin_files}};
}

Settings settings_of(const Json& json) {
  Settings out;
  json.at("scheduler").get_to(out.scheduler);
  json.at("tasks").get_to(out.tasks);
  json.at("matches").get_to(out.matches);
  json.at("workers").get_to(out.workers);
  json.at("partition").get_to(out.partition);
  json.at("time").get_to(out.time);
  json.at("options").get_to(out.options);
  json.at("record_every").get_to(out.record_every);
  json.at("plugin_files").get_to(out.plugin_files);
  return out;
}

Json json_of(const Progress& progress) {
  Json batches = Json::array();
  for (const SubmittedBatch& each : progress.batches) {
    batches.push_back({{"number", each.number},
                       {"tasks", each.tasks},
                       {"matches", each.matches},
                       {"rows_before", each.rows_before},
                       {"array_job", each.array_job},
                       {"gather_job", each.gather_job}});
  }
  return {{"state", name_of(progress.state)},
          {"message", progress.message},
          {"batches", batches},
          {"fruitless", progress.fruitless},
          {"refused_nodes", progress.refused_nodes},
          {"remarks", progress.remarks},
          {"title", progress.title},
          {"finding", progress.finding},
          {"matches", progress.matches},
          {"rows", progress.rows}};
}

Progress progress_of(const Json& json) {
  Progress out;
  for (const auto& [value, name] : states) {
    if (json.at("state") == name) out.state = value;
  }
  json.at("message").get_to(out.message);
  for (const Json& each : json.at("batches")) {
    out.batches.push_back({each.at("number"), each.at("tasks"), each.at("matches"), each.at("rows_before"),
                           each.at("array_job"), each.at("gather_job")});
  }
  json.at("fruitless").get_to(out.fruitless);
  json.at("refused_nodes").get_to(out.refused_nodes);
  json.at("remarks").get_to(out.remarks);
  json.at("title").get_to(out.title);
  json.at("finding").get_to(out.finding);
  json.at("matches").get_to(out.matches);
  json.at("rows").get_to(out.rows);
  return out;
}

Json description_of(const StudyFolder& folder) {
  const fs::path file = folder.description();
  const auto text = config::file_content(file);
  const std::string name = config::one_line(folder.root().string());
  if (!text) throw BadInput(fmt::format("{} is no folder of a study on a cluster: it has no cluster.json", name));
  Json json = Json::parse(*text, nullptr, false);
  if (!json.is_object()) throw BadInput(fmt::format("{} is damaged", config::one_line(file.string())));
  return json;
}

template <class Read>
auto part_of(const StudyFolder& folder, const char* name, Read read) {
  try {
    return read(description_of(folder).at(name));
  } catch (const nlohmann::json::exception&) {
    throw BadInput(fmt::format("{} is damaged", config::one_line(folder.description().string())));
  }
}

void write_description(const StudyFolder& folder, const Json& settings, const Json& progress,
                       output::Existing existing) {
  const Json all{{"study_folder", 1}, {"settings", settings}, {"progress", progress}};
  output::write_whole(folder.description(), all.dump(2, ' ', false, Json::error_handler_t::replace) + '\n', existing);
}

std::string name_of(const TaskName& task, const char* ending) {
  return fmt::format("{}-{}{}", task.batch, task.task, ending);
}

void copy_whole(const fs::path& from, const fs::path& to) {
  std::error_code error;
  fs::create_directories(to.parent_path(), error);
  if (!error) fs::copy_file(from, to, fs::copy_options::skip_existing, error);
  if (!error) return;
  if (error == std::errc::no_such_file_or_directory)
    throw BadInput(fmt::format("{}: no such file any more", config::one_line(from.string())));
  throw output::WriteError(fmt::format("cannot copy {} to {}: {}", config::one_line(from.string()),
                                       config::one_line(to.string()), error.message()));
}

}  // namespace

const char* name_of(Progress::State state) {
  return std::ranges::find(states, state, &std::pair<Progress::State, const char*>::first)->second;
}

StudyFolder::StudyFolder(const fs::path& root) : root_(fs::absolute(root).lexically_normal()) {
  if (!root_.has_filename()) root_ = root_.parent_path();
}

fs::path StudyFolder::batch(std::uint64_t number) const { return root_ / "batches" / fmt::format("{}.json", number); }
fs::path StudyFolder::known_before(std::uint64_t number) const {
  return root_ / "batches" / fmt::format("{}.db", number);
}
fs::path StudyFolder::part(const TaskName& task) const { return parts() / name_of(task, ".db"); }
fs::path StudyFolder::under_way(const TaskName& task) const { return parts() / name_of(task, ".db.part"); }
fs::path StudyFolder::course(const TaskName& task) const { return parts() / name_of(task, ".txt"); }
fs::path StudyFolder::refusal(const TaskName& task) const { return parts() / name_of(task, ".refused"); }

void StudyFolder::create(const Settings& settings) const {
  const std::string name = config::one_line(root_.string());
  std::error_code error;
  if (fs::exists(root_, error)) {
    throw BadInput(fmt::format(
        "{} exists already; regista gather {} goes on with a study in it, --folder names another", name, name));
  }
  for (const fs::path& each : {root_, root_ / "batches", parts(), set_aside(), logs(), files()}) {
    fs::create_directories(each, error);
    if (error) throw BadInput(fmt::format("cannot make the folder {}: {}", each.string(), error.message()));
  }
  write_description(*this, json_of(settings), json_of(Progress()), output::Existing::refused);
}

void StudyFolder::copy_in(const std::vector<fs::path>& given) const {
  for (const fs::path& each : given) copy_whole(each, copy_of(each));
  copy_whole("/proc/self/exe", program());
}

Settings StudyFolder::settings() const { return part_of(*this, "settings", settings_of); }
Progress StudyFolder::progress() const { return part_of(*this, "progress", progress_of); }

void StudyFolder::write(const Progress& progress) const {
  write_description(*this, json_of(settings()), json_of(progress), output::Existing::replaced);
}

void StudyFolder::write_plan(const campaign::Store& results, const std::string& program_version) const {
  using campaign::Store;
  const fs::path fresh = plan().string() + ".new";
  std::error_code error;
  fs::remove(fresh, error);
  {
    Store store(fresh, Store::Mode::create, program_version, campaign::Journal::rollback);
    store.keep(results.documents());
    for (const char* each : {"documents", "schedule"}) store.set_meta(each, results.meta(each));
  }
  fs::rename(fresh, plan(), error);
  if (error) throw output::WriteError(fmt::format("cannot write {}: {}", plan().string(), error.message()));
}

void StudyFolder::write(const Settings& settings) const {
  write_description(*this, json_of(settings), json_of(progress()), output::Existing::replaced);
}

campaign::Job StudyFolder::of_copies(campaign::Job job, const fs::path& given_in, const Settings& settings) const {
  campaign::Job out = campaign::in_copies(std::move(job), files(), given_in);
  out.root = files().string();
  out.plugin_files.clear();
  for (const std::string& each : settings.plugin_files) out.plugin_files.push_back(copy_of(each).string());
  return out;
}

bool is_in_study_folder(const fs::path& results) {
  std::error_code none;
  return fs::exists(fs::absolute(results, none).parent_path() / "cluster.json", none);
}

}  // namespace regista::cluster
