// SPDX-License-Identifier: MIT
#include "cluster/task.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <memory>
#include <optional>
#include <stdexcept>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "cluster/step.hpp"
#include "command/terminal.hpp"
#include "output/replaced_file.hpp"
#include "results/results_file.hpp"

namespace regista::cluster {

namespace {

// Adds only the fixtures (matches without their seeds) of the slices to `part`, because a large tournament has
// thousands. Returns for each fixture of the round its number in `part`; 0 for a fixture that was not added.
std::vector<std::int64_t> numbers_of(const study::Round& round, const Slices& slices, campaign::Store& part) {
  std::vector<bool> needed(round.fixtures.size());
  for (const Slice& slice : slices) {
    for (std::uint64_t index = slice.begin; index < slice.end; ++index) {
      if (const auto place = round.at(index)) needed[place->fixture] = true;
    }
  }
  std::vector<campaign::Store::Fixture> fixtures;
  for (std::size_t i = 0; i < needed.size(); ++i) {
    if (needed[i]) fixtures.push_back(round.fixtures[i]);
  }
  const std::vector<std::int64_t> added = part.add(fixtures);
  std::vector<std::int64_t> out(needed.size());
  for (std::size_t i = 0, next = 0; i < needed.size(); ++i) {
    if (needed[i]) out[i] = added[next++];
  }
  return out;
}

// Plays a schedule from the first place to the last place of the slices. Places between two slices are not played.
campaign::Finish play(const study::Round& round, const study::Study& study, campaign::Store& part,
                      const SliceOrder& order) {
  const Slices& slices = order.slices;
  if (slices.empty()) throw study::StudyError("the task has no match");
  if (slices.back().end > round.matches)
    throw study::StudyError("the study asks for fewer matches than the batch says");
  const std::vector<std::int64_t> numbers = numbers_of(round, slices, part);
  const std::uint64_t first = slices.front().begin;
  const auto is_wanted = [&](std::uint64_t place) {
    const auto after = std::ranges::upper_bound(slices, place, {}, &Slice::begin);
    return after != slices.begin() && place < std::prev(after)->end;
  };
  const auto row = [&](std::uint64_t index) { return round.first_row + first + index + 1; };
  const auto began = std::chrono::steady_clock::now();
  TaskProgress progress;
  progress.all = matches_of(slices);
  campaign::Schedule schedule;
  schedule.matches = slices.back().end - first;
  schedule.first_row = round.first_row + first;
  schedule.at = [&](std::uint64_t index) -> std::optional<campaign::MatchKey> {
    if (!is_wanted(first + index)) return std::nullopt;
    const auto place = round.at(first + index);
    if (!place) return std::nullopt;
    return campaign::MatchKey{numbers[place->fixture], place->seed};
  };
  schedule.job = [&](std::uint64_t index) { return order.job(round.job(first + index), row(index)); };
  schedule.take = [&](std::uint64_t index, const campaign::MatchResult* decided, bool fresh) {
    if (!is_wanted(first + index)) return true;
    ++progress.done;
    progress.fresh += fresh ? 1 : 0;
    if (decided != nullptr && (decided->failure || decided->set_aside())) ++progress.failed;
    progress.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
    progress.ended = progress.done == progress.all;
    if (order.progressed) order.progressed(progress);
    return true;
  };
  if (round.first_of_pairing) {
    schedule.twice = [&](std::uint64_t index) { return round.first_of_pairing(first + index); };
  }
  if (order.record_failure) {
    schedule.record_failure = [&](std::uint64_t index) { return order.record_failure(row(index)); };
  }
  schedule.asked_to_stop = order.asked_to_stop;
  return campaign::run(schedule, part, order.workers, study.limits());
}

namespace fs = std::filesystem;
using command::BadInput;
using results::Invocation;

constexpr std::chrono::minutes patience_with_another{2};  // wait for another node's process of the same task
constexpr std::chrono::seconds between_courses{2};

std::string node_name() {
  if (const char* name = std::getenv("SLURMD_NODENAME"); name != nullptr) return name;
  std::array<char, 256> name{};
  return gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "a node";
}

// Opens or creates the part of the task. Returns null if the task has already ended on another node.
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
      // If the file exists now, another process has just created it: the loop tries again.
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
  const std::string node = node_name();
  const std::string different = what_differs_here(results::stored_study(file, known, {}, invocation.studies)->study());
  if (!different.empty()) {
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
  order.progressed = [&](const TaskProgress& progress) {
    const auto now = std::chrono::steady_clock::now();
    if (!progress.ended && now - written < between_courses) return;
    written = now;
    TaskProgress named = progress;
    named.node = node;
    write_progress(folder, name, named);
  };
  order.asked_to_stop = [&] { return interruption.requested(); };
  const campaign::Finish finish = play_slice(study, known, *part, order);
  if (finish == campaign::Finish::interrupted)
    throw command::Interrupted("the task was ended; what it has played is kept", interruption.signal_number());
  part->require_whole_file();
}

}  // namespace

campaign::Finish play_slice(study::Study& study, const campaign::Store& known, campaign::Store& part,
                            const SliceOrder& order) {
  struct Played {
    campaign::Finish finish;
  };
  const study::PlayRound answer = [&](const study::Round& round) {
    if (round.first_row >= order.first_row) throw Played{play(round, study, part, order)};
    if (!study::answer_from(known, round, study.metrics()))
      throw study::StudyError("a match of an earlier round is missing");
  };
  try {
    study.run(answer);
  } catch (const Played& played) {
    return played.finish;
  }
  throw study::StudyError("the study has ended before the round of this batch");
}

void play_task(const std::string& folder_name, const TaskName& name, const Invocation& invocation) {
  const StudyFolder folder(folder_name);
  try {
    const Batch batch = batch_of(folder, name);
    play(folder, name, batch, invocation);
    std::error_code none;  // ignored: another process may have renamed the file
    if (!fs::exists(folder.part(name), none)) fs::rename(folder.under_way(name), folder.part(name), none);
    if (batch.may_end_early) look_whether_it_is_over(folder, invocation);
  } catch (const std::invalid_argument& error) {
    throw BadInput(error.what());
  } catch (const study::StudyError& error) {
    throw BadInput(error.what());
  } catch (const campaign::CampaignError& error) {
    if (error.kind == campaign::CampaignError::Kind::input) {
      // The inputs on this node differ from the inputs in the plan.
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
