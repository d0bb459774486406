// SPDX-License-Identifier: MIT
#include "cluster/task.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "cluster/parts.hpp"
#include "cluster/shared_file.hpp"
#include "cluster/slice.hpp"
#include "cluster/step.hpp"
#include "cluster/study_folder.hpp"
#include "command/end_of_program.hpp"
#include "command/interruption.hpp"
#include "output/output.hpp"
#include "results/results_file.hpp"
#include "study/recording_place.hpp"

namespace regista::cluster {
namespace {

namespace fs = std::filesystem;
using command::BadInput;
using results::Invocation;

constexpr std::chrono::minutes patience_with_another{2};  // for the same task, which is about to die elsewhere
constexpr std::chrono::seconds between_courses{2};

std::string node_name() {
  if (const char* name = std::getenv("SLURMD_NODENAME"); name != nullptr) return name;
  std::array<char, 256> name{};
  return gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "a node";
}

// Nothing: the task has ended already, elsewhere.
std::unique_ptr<campaign::Store> part_of(const StudyFolder& folder, const TaskName& name) {
  using Mode = campaign::Store::Mode;
  const fs::path file = folder.under_way(name);
  const auto until = std::chrono::steady_clock::now() + patience_with_another;
  for (;;) {
    if (fs::exists(folder.part(name))) return nullptr;
    try {
      const Mode mode = fs::exists(file) ? Mode::open : Mode::create;
      return std::make_unique<campaign::Store>(file, mode, REGISTA_VERSION, campaign::Journal::rollback);
    } catch (const campaign::StoreInUse& error) {
      if (std::chrono::steady_clock::now() > until) throw BadInput(error.what());
    } catch (const campaign::StoreRefusal& error) {
      // Another process has made the file since.
      if (std::chrono::steady_clock::now() > until || !fs::exists(file)) throw BadInput(error.what());
    } catch (const campaign::StoreDiskError& error) {
      throw output::WriteError(error.what());
    }
    std::this_thread::sleep_for(std::chrono::seconds(1));
  }
}

Batch batch_of(const StudyFolder& folder, const TaskName& name) {
  const auto text = shared_content(folder.batch(name.batch));
  if (!text) throw BadInput(fmt::format("{}: no such batch", folder.batch(name.batch).string()));
  Batch out = batch_from_json(*text);
  if (name.task >= out.tasks.size()) throw BadInput(fmt::format("batch {} has no task {}", name.batch, name.task));
  return out;
}

void play(const StudyFolder& folder, const TaskName& name, const Batch& batch, const Invocation& invocation) {
  const Settings settings = folder.settings();
  const fs::path before = folder.known_before(name.batch);
  const std::string file = (fs::exists(before) ? before : folder.plan()).string();
  const campaign::Store known = results::read_results(file);
  const std::string plan = results::stored_plan(known);
  const std::vector<campaign::Job> jobs =
      results::first_jobs(results::stored_study(file, known, {}, invocation.studies)->study());
  const std::string node = node_name();
  if (const std::string different = jobs.empty() ? "" : what_differs_here(jobs.front()); !different.empty()) {
    write_refusal(folder, name, node, different);
    throw BadInput(fmt::format("node {} plays nothing: {}", node, different));
  }
  const std::unique_ptr<campaign::Store> part = part_of(folder, name);
  if (!part) return;
  if (part->meta("schedule").empty()) part->set_meta("schedule", plan);

  const auto report = results::stored_study(file, known, {}, invocation.studies);
  study::Study& study = report->study();
  const std::string given_in = study.folder();
  fs::current_path(folder.copy_of(given_in));
  const command::Interruption interruption("regista: the task was ended; what it has played is kept\n");
  const auto recording = [&](std::uint64_t row) {
    return study::recording_file(folder.results(), static_cast<std::int64_t>(row)).string();
  };
  auto written = std::chrono::steady_clock::now() - between_courses;
  SliceOrder order;
  order.first_row = batch.first_row;
  order.slices = batch.tasks[name.task];
  order.workers = static_cast<int>(settings.workers);
  order.job = [&](campaign::Job job, std::uint64_t row) {
    campaign::Job out = folder.of_copies(std::move(job), given_in, settings);
    if (settings.record_every > 0 && (row - 1) % settings.record_every == 0) out.record = recording(row);
    return out;
  };
  order.record_failure = recording;
  order.course = [&](const Course& course) {
    const auto now = std::chrono::steady_clock::now();
    if (!course.ended && now - written < between_courses) return;
    written = now;
    Course named = course;
    named.node = node;
    write_course(folder, name, named);
  };
  order.asked_to_stop = [&] { return interruption.requested(); };
  const campaign::Finish finish = play_slice(study, known, *part, order);
  if (finish == campaign::Finish::interrupted)
    throw command::Interrupted("the task was ended; what it has played is kept", interruption.signal_number());
  part->require_whole_file();
}

}  // namespace

void play_task(const std::string& folder_name, const TaskName& name, const Invocation& invocation) {
  const StudyFolder folder(folder_name);
  try {
    const Batch batch = batch_of(folder, name);
    play(folder, name, batch, invocation);
    std::error_code none;  // there is nothing to rename where another process has done it
    if (!fs::exists(folder.part(name), none)) fs::rename(folder.under_way(name), folder.part(name), none);
    if (batch.may_end_early) look_whether_it_is_over(folder, invocation);
  } catch (const std::invalid_argument& error) {
    throw BadInput(error.what());
  } catch (const study::StudyError& error) {
    throw BadInput(error.what());
  } catch (const campaign::CampaignError& error) {
    if (error.kind() == campaign::CampaignError::Kind::input) {
      // What the node reads is not what was planned.
      write_refusal(folder, name, node_name(), error.what());
      throw BadInput(error.what());
    }
    throw output::WriteError(error.what());
  } catch (const campaign::StoreError& error) {
    throw output::WriteError(error.what());
  } catch (const std::system_error& error) {
    throw output::WriteError(error.what());
  }
}

}  // namespace regista::cluster
