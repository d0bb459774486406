// SPDX-License-Identifier: MIT
#include "cluster/study_folder.hpp"

#include <fmt/format.h>

#include <optional>
#include <stdexcept>
#include <system_error>

#include "campaign/document_copies.hpp"
#include "cluster/shared_file.hpp"
#include "config/bad_input.hpp"
#include "output/output.hpp"
#include "output/replaced_file.hpp"
#include "texts/json.hpp"
#include "texts/message.hpp"

namespace regista::cluster {

// How these stand in cluster.json.
static void to_json(nlohmann::json& json, Progress::State state) { json = name_of(state); }
static void from_json(const nlohmann::json& json, Progress::State& out) {
  using enum Progress::State;
  for (const Progress::State each : {running, complete, stopped, failed}) {
    if (json != name_of(each)) continue;
    out = each;
    return;
  }
  throw std::invalid_argument("no such state");
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

constexpr int layout = 1;  // of the folder

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
  const std::string name = texts::one_line(folder.root().string());
  if (!text) throw BadInput(fmt::format("{} is no folder of a study on a cluster: it has no cluster.json", name));
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

std::string name_of(const TaskName& task, const char* ending) {
  return fmt::format("{}-{}{}", task.batch, task.task, ending);
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

const char* name_of(Progress::State state) {
  switch (state) {
    case Progress::State::running:
      return "running";
    case Progress::State::complete:
      return "complete";
    case Progress::State::stopped:
      return "stopped";
    case Progress::State::failed:
      break;
  }
  return "failed";
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
  const std::string name = texts::one_line(root_.string());
  std::error_code error;
  if (fs::exists(root_, error)) {
    throw BadInput(fmt::format(
        "{} exists already; regista gather {} goes on with a study in it, --folder names another", name, name));
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
  write_description(*this, settings, progress(), output::Existing::replaced);
}

campaign::Job StudyFolder::of_copies(campaign::Job job, const fs::path& given_in, const Settings& settings) const {
  campaign::Job out = campaign::in_copies(std::move(job), files(), given_in);
  out.root = files().string();
  out.plugin_files.clear();
  for (const std::string& each : settings.plugin_files) out.plugin_files.push_back(copy_of(each).string());
  return out;
}

}  // namespace regista::cluster
