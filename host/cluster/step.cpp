// SPDX-License-Identifier: MIT
#include "cluster/step.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <system_error>
#include <thread>
#include <utility>

#include "campaign/match_setup.hpp"
#include "cluster/batch.hpp"
#include "command/terminal.hpp"
#include "output/replaced_file.hpp"
#include "process/child.hpp"
#include "results/results_file.hpp"
#include "texts/message.hpp"

namespace regista::cluster {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t most_fruitless = 5;  // consecutive batches without a new match after which a study fails
constexpr std::size_t most_remarks = 20;
constexpr int most_looks = 10;                    // largest number of steps that a task takes at its end
constexpr std::chrono::minutes longest_wait{10};  // longest wait for the end of another process's step

campaign::Store opened(const StudyFolder& folder) {
  const auto until = std::chrono::steady_clock::now() + longest_wait;
  for (;;) {
    try {
      return {folder.results(), campaign::Store::Mode::open, REGISTA_VERSION, campaign::Journal::rollback};
    } catch (const campaign::StoreInUse& error) {
      if (std::chrono::steady_clock::now() > until) throw command::BadInput(error.what());
    } catch (const campaign::StoreRefusal& error) {
      throw command::BadInput(error.what());
    } catch (const campaign::StoreDiskError& error) {
      throw output::WriteError(error.what());
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
  }
}

void copy_over(const fs::path& from, const fs::path& to) {
  std::error_code error;
  fs::copy_file(from, to, fs::copy_options::overwrite_existing, error);
  if (!error) return;
  throw output::WriteError(fmt::format("cannot copy {} to {}: {}", from.string(), to.string(), error.message()));
}

// Returns options of sbatch with the excluded nodes. of_tasks: false for the gather job, which takes a step after the
// job array; of the user's options it gets only account, QOS, reservation and partition.
std::vector<std::string> sbatch_options(const Settings& settings, const Progress& progress, bool of_tasks) {
  std::vector<std::string> out;
  if (!settings.partition.empty()) out.push_back("--partition=" + settings.partition);
  if (of_tasks && !settings.time.empty()) out.push_back("--time=" + settings.time);
  for (const std::string& each : settings.options) {
    const bool who = each.starts_with("--account") || each.starts_with("--qos") || each.starts_with("--reservation");
    if (of_tasks || who) out.push_back(each);
  }
  if (progress.refused_nodes.empty()) return out;
  const std::string nodes = fmt::format("{}", fmt::join(progress.refused_nodes, ","));
  const auto given = std::ranges::find_if(out, [](const std::string& each) { return each.starts_with("--exclude="); });
  if (given == out.end())
    out.push_back("--exclude=" + nodes);
  else
    *given += "," + nodes;
  return out;
}

JobRequest array_request(const StudyFolder& folder, const Settings& settings, const Progress& progress) {
  const SubmittedBatch& batch = progress.batches.back();
  return {.name = fmt::format("{}-{}", folder.root().filename().string(), batch.number),
          .script = folder.root() / "task.sh",
          .arguments = {std::to_string(batch.number)},
          .output = in_pattern(folder.logs()) + fmt::format("/{}-%a.txt", batch.number),
          .tasks = batch.tasks,
          .processors = settings.workers,
          .options = sbatch_options(settings, progress, true)};
}

JobRequest gather_request(const StudyFolder& folder, const Settings& settings, const Progress& progress) {
  const SubmittedBatch& batch = progress.batches.back();
  return {.name = folder.root().filename().string() + "-gather",
          .script = folder.root() / "gather.sh",
          .output = in_pattern(folder.logs()) + fmt::format("/{}-gather.txt", batch.number),
          .after = batch.array_job,
          .options = sbatch_options(settings, progress, false)};
}

void submit_gather(const StudyFolder& folder, const Settings& settings, Progress& progress) {
  progress.batches.back().gather_job = submit(gather_request(folder, settings, progress));
  folder.write(progress);
}

void submit_next(const StudyFolder& folder, const Settings& settings, const Missing& missing, std::uint64_t rows,
                 Progress& progress) {
  const Batch batch{missing.first_row, missing.may_end_early,
                    shared_out(missing.places, missing.twice, settings.matches, settings.tasks)};
  const SubmittedBatch submitted{.number = progress.batches.size() + 1,
                                 .tasks = batch.tasks.size(),
                                 .matches = batch.matches(),
                                 .rows_before = rows};
  if (!missing.is_first) copy_over(folder.results(), folder.known_before(submitted.number));
  output::write_whole(folder.batch(submitted.number), to_json(batch), output::Existing::replaced);

  progress.batches.push_back(submitted);
  folder.write(progress);  // written first: if this process is killed, the next process asks Slurm for the job
  std::string& job = progress.batches.back().array_job;
  try {
    job = submit(array_request(folder, settings, progress));
  } catch (const SlurmError&) {
    progress.batches.pop_back();
    folder.write(progress);
    throw;
  }
  try {
    folder.write(progress);  // written now, so that the array is known even if submit_gather() fails
  } catch (...) {
    cancel({job});
    throw;
  }
  submit_gather(folder, settings, progress);
}

// Asks Slurm for jobs that a process submitted before it was killed, without writing their numbers.
void find_unnoted_jobs(const StudyFolder& folder, const Settings& settings, Progress& progress) {
  if (progress.batches.empty()) return;
  SubmittedBatch& batch = progress.batches.back();
  if (batch.array_job.empty()) batch.array_job = job_of(array_request(folder, settings, progress));
  if (batch.gather_job.empty()) batch.gather_job = job_of(gather_request(folder, settings, progress));
}

void keep_remarks(const Gathered& gathered, Progress& progress) {
  for (const std::string& each : gathered.refused_nodes) texts::add_once(progress.refused_nodes, each);
  progress.remarks.insert(progress.remarks.end(), gathered.remarks.begin(), gathered.remarks.end());
  if (progress.remarks.size() > most_remarks)
    progress.remarks.erase(progress.remarks.begin(), progress.remarks.end() - most_remarks);
}

// Submits the gather job, which runs after the array, once more if the gather job has ended or was refused.
void require_gather_job(const StudyFolder& folder, const Settings& settings, Progress& progress) {
  const std::string& job = progress.batches.back().gather_job;
  if (job.empty() || (!is_within({job}) && alive({job}).empty())) submit_gather(folder, settings, progress);
}

void end_jobs(const StudyFolder& folder, const Settings& settings, Progress& progress) {
  const std::string& array = progress.batches.back().array_job;
  if (!is_within({array})) return cancel(jobs_alive(progress));
  // This process is a task of the array, so it ends itself here. The gather job then reports the result of the study.
  require_gather_job(folder, settings, progress);
  cancel({array});
}

void complete(const StudyFolder& folder, const Settings& settings, std::uint64_t rows, std::uint64_t seen,
              bool array_lives, Progress& progress) {
  const bool was = std::exchange(progress.state, Progress::State::complete) == Progress::State::complete;
  // Equal matches share a row, so the real number of superfluous matches may be larger than the number in the message.
  progress.message =
      rows <= seen
          ? std::string()
          : fmt::format("{} matches were played beyond the end of the study, and are not counted", rows - seen);
  folder.write(progress);
  if (progress.batches.empty() || (was && !array_lives)) return;
  try {
    end_jobs(folder, settings, progress);
  } catch (const SlurmError& error) {
    progress.remarks.push_back(error.what());
    folder.write(progress);
  }
}

void require_same_results_here(const StudyFolder& folder, const campaign::Store& results,
                               const results::Invocation& invocation) {
  const auto report = results::stored_study(folder.results().string(), results, {}, invocation.studies);
  const std::string different = what_differs_here(report->study());
  if (different.empty()) return;
  throw command::BadInput(
      fmt::format("this machine cannot go on with the study: {}; run this on one of its nodes: {}", different,
                  process::shell_line({folder.program().string(), "gather", folder.root().string()})));
}

// Precondition: the caller has opened and so locked the file of results.
Step step(const StudyFolder& folder, campaign::Store& results, bool restart, const results::Invocation& invocation) {
  const Settings settings = folder.settings();
  Step out;
  Progress& progress = out.progress = folder.progress();
  const bool has_batch = !progress.batches.empty();
  find_unnoted_jobs(folder, settings, progress);
  const bool array_lives = has_batch && !alive({progress.batches.back().array_job}).empty();
  out.gathered = gather(folder, results, array_lives ? Tasks::ended : Tasks::killed_too);
  keep_remarks(out.gathered, progress);
  folder.write(progress);  // written now, because the following calls may throw
  const auto report = results::stored_study(folder.results().string(), results, {}, invocation.studies);
  const Missing missing = missing_of(report->study(), results, settings.tasks * settings.matches);
  const report::Outline outline = report->outline();
  progress.title = outline.title;
  progress.matches = report->study().open_end().empty() ? report->study().most_matches() : 0;
  progress.finding = report->study().counted() > 0 ? plain(outline.headline) : "";
  progress.rows = static_cast<std::uint64_t>(results.rows());
  folder.write(progress);  // written now, because the following calls of Slurm may throw
  if (missing.complete()) {
    results.require_whole_file();
    complete(folder, settings, progress.rows, missing.seen, array_lives, progress);
    return out;
  }
  out.round = missing.round;
  if (const std::string why = report->study().unplayable(); !why.empty()) {
    progress.state = Progress::State::failed;
    progress.message = why;
    if (array_lives) end_jobs(folder, settings, progress);
    folder.write(progress);
    return out;
  }
  if (restart) {
    progress.state = Progress::State::running;
    progress.message.clear();
    progress.fruitless = 0;
    progress.refused_nodes.clear();
  }
  out.plays = array_lives;
  if (progress.state == Progress::State::running && array_lives) {
    require_gather_job(folder, settings, progress);
  } else if (progress.state == Progress::State::running) {
    const bool fruitless = has_batch && !restart && progress.rows == progress.batches.back().rows_before;
    progress.fruitless = fruitless ? progress.fruitless + 1 : 0;
    if (progress.fruitless >= most_fruitless) {
      progress.state = Progress::State::failed;
      progress.message =
          fmt::format("{} batches in a row brought no match; what their tasks wrote stands in {}{}", most_fruitless,
                      folder.logs().string(), progress.remarks.empty() ? "" : "; " + progress.remarks.back());
    } else {
      std::error_code none;
      if (has_batch) fs::remove(folder.known_before(progress.batches.size()), none);
      if (results::stored_plan(results::read_results(folder.plan().string())) != results::stored_plan(results))
        folder.write_plan(results);  // the user has added pairs to the study
      submit_next(folder, settings, missing, progress.rows, progress);
      out.submitted = progress.batches.back().matches;
      out.plays = true;
    }
  }
  folder.write(progress);
  return out;
}

}  // namespace

std::string what_differs_here(study::Study& study) {
  const std::vector<campaign::Job> planned = results::first_jobs(study);
  if (planned.empty()) return {};
  std::vector<std::string> out;
  if (campaign::input_of(planned.front(), campaign::program_input) != campaign::program_hash())
    out.emplace_back("its program is another");
  if (campaign::input_of(planned.front(), campaign::mathematics_input) != campaign::mathematics_fingerprint())
    out.emplace_back("its mathematics library or processor computes other numbers");
  return texts::join(out);
}

std::vector<std::string> jobs_alive(const Progress& progress) {
  std::vector<std::string> all;
  for (const SubmittedBatch& each : progress.batches) {
    for (const std::string& job : {each.array_job, each.gather_job}) {
      if (!job.empty() && !is_within({job})) all.push_back(job);
    }
  }
  return alive(all);
}

void stop_study(const StudyFolder& folder) {
  const Settings settings = folder.settings();  // throws if the folder is not a study folder
  const campaign::Store held = opened(folder);
  Progress progress = folder.progress();
  if (progress.state == Progress::State::complete)
    throw command::BadInput(fmt::format("stop: {}: the study is complete", folder.name()));
  try {
    find_unnoted_jobs(folder, settings, progress);
    cancel(jobs_alive(progress));
  } catch (const SlurmError& error) {
    throw command::BadInput(error.what());
  }
  progress.state = Progress::State::stopped;
  progress.message = "it was stopped";
  folder.write(progress);
}

void look_whether_it_is_over(const StudyFolder& folder, const results::Invocation& invocation) {
  const auto something_is_left = [&folder] { return std::ranges::any_of(task_progress(folder), &TaskProgress::ended); };
  try {
    int looks = 0;
    do {
      const Progress::State state = folder.progress().state;
      if (state != Progress::State::running && state != Progress::State::complete) return;
      {
        campaign::Store results(folder.results(), campaign::Store::Mode::open, REGISTA_VERSION,
                                campaign::Journal::rollback);
        step(folder, results, false, invocation);
      }
      // A task that ended meanwhile found the file of results in use, so this process gathers the task's matches.
    } while (++looks < most_looks && something_is_left());
  } catch (const campaign::StoreInUse&) {
    // The file of results is locked, so another process takes a step at present, and this task takes none.
  } catch (const std::exception& error) {
    // The study continues: the next step tries again.
    command::complain(fmt::format("whether the study is over was not seen: {}", error.what()));
  }
}

Step take_step(const StudyFolder& folder, bool restart, const results::Invocation& invocation) {
  folder.settings();  // throws if the folder is not a study folder
  campaign::Store results = opened(folder);
  require_same_results_here(folder, results, invocation);
  const auto failed = [&](const std::string& why) {
    Progress progress = folder.progress();
    if (progress.batches.empty()) return why;
    progress.state = Progress::State::failed;
    progress.message = why;
    folder.write(progress);
    return fmt::format("{}; to go on: {}", why, folder.command("resume"));
  };
  try {
    return step(folder, results, restart, invocation);
  } catch (const SlurmError& error) {
    throw command::BadInput(failed(error.what()));
  } catch (const study::StudyError& error) {
    throw command::BadInput(failed(error.what()));
  } catch (const campaign::StoreRefusal& error) {
    throw command::BadInput(failed(error.what()));
  } catch (const campaign::StoreDiskError& error) {
    throw output::WriteError(fmt::format("{}; to go on: {}", error.what(), folder.command("resume")));
  } catch (const campaign::StoreError& error) {
    throw command::BadInput(failed(error.what()));
  }
}

}  // namespace regista::cluster
