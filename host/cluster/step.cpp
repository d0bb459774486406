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

#include "campaign/inputs.hpp"
#include "campaign/job_setup.hpp"
#include "campaign/mathematics.hpp"
#include "cluster/batch.hpp"
#include "cluster/missing.hpp"
#include "cluster/slurm.hpp"
#include "command/end_of_program.hpp"
#include "output/output.hpp"
#include "output/replaced_file.hpp"
#include "process/program.hpp"
#include "results/results_file.hpp"
#include "texts/message.hpp"

namespace regista::cluster {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t most_fruitless = 5;  // a batch of few matches may be preempted again and again
constexpr std::size_t most_remarks = 20;
constexpr int most_looks = 10;                    // of one task, one after the other
constexpr std::chrono::minutes longest_wait{10};  // for another process that takes a step

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
  if (error)
    throw output::WriteError(fmt::format("cannot copy {} to {}: {}", from.string(), to.string(), error.message()));
}

// Options of sbatch that say who asks, and those of tasks: theirs, with the nodes that are left out.
std::vector<std::string> options_of_gather(const Settings& settings) {
  std::vector<std::string> out;
  if (!settings.partition.empty()) out.push_back("--partition=" + settings.partition);
  for (const std::string& each : settings.options) {
    if (each.starts_with("--account") || each.starts_with("--qos") || each.starts_with("--reservation"))
      out.push_back(each);
  }
  return out;
}

std::vector<std::string> options_of_tasks(const Settings& settings) {
  std::vector<std::string> out;
  if (!settings.partition.empty()) out.push_back("--partition=" + settings.partition);
  if (!settings.time.empty()) out.push_back("--time=" + settings.time);
  out.insert(out.end(), settings.options.begin(), settings.options.end());
  return out;
}

void leave_out(const std::vector<std::string>& nodes, std::vector<std::string>& options) {
  if (nodes.empty()) return;
  const std::string more = fmt::format("{}", fmt::join(nodes, ","));
  const auto given =
      std::ranges::find_if(options, [](const std::string& each) { return each.starts_with("--exclude="); });
  if (given == options.end())
    options.push_back("--exclude=" + more);
  else
    *given += "," + more;
}

// Of the last batch.
JobRequest array_request(const StudyFolder& folder, const Settings& settings, const Progress& progress) {
  const SubmittedBatch& batch = progress.batches.back();
  JobRequest out;
  out.name = fmt::format("{}-{}", folder.root().filename().string(), batch.number);
  out.script = folder.root() / "task.sh";
  out.arguments = {std::to_string(batch.number)};
  out.output = in_pattern(folder.logs()) + fmt::format("/{}-%a.txt", batch.number);
  out.tasks = batch.tasks;
  out.processors = settings.workers;
  out.options = options_of_tasks(settings);
  leave_out(progress.refused_nodes, out.options);
  return out;
}

JobRequest gather_request(const StudyFolder& folder, const Settings& settings, const Progress& progress) {
  const SubmittedBatch& batch = progress.batches.back();
  JobRequest out;
  out.name = folder.root().filename().string() + "-gather";
  out.script = folder.root() / "gather.sh";
  out.output = in_pattern(folder.logs()) + fmt::format("/{}-gather.txt", batch.number);
  out.after = batch.array_job;
  out.options = options_of_gather(settings);
  leave_out(progress.refused_nodes, out.options);
  return out;
}

void submit_gather(const StudyFolder& folder, const Settings& settings, Progress& progress) {
  progress.batches.back().gather_job = submit(gather_request(folder, settings, progress));
  folder.write(progress);
}

void submit_next(const StudyFolder& folder, const Settings& settings, const Missing& missing, std::uint64_t rows,
                 Progress& progress) {
  Batch batch;
  batch.first_row = missing.first_row;
  batch.may_end_early = missing.may_end_early;
  batch.tasks = shared_out(missing.places, missing.twice, settings.matches, settings.tasks);
  SubmittedBatch submitted;
  submitted.number = progress.batches.size() + 1;
  submitted.tasks = batch.tasks.size();
  submitted.matches = batch.matches();
  submitted.rows_before = rows;
  if (!missing.is_first) copy_over(folder.results(), folder.known_before(submitted.number));
  output::write_whole(folder.batch(submitted.number), to_json(batch), output::Existing::replaced);

  progress.batches.push_back(submitted);
  folder.write(progress);  // before: who goes on after a kill asks Slurm for it
  std::string& job = progress.batches.back().array_job;
  try {
    job = submit(array_request(folder, settings, progress));
  } catch (const SlurmError&) {
    progress.batches.pop_back();
    folder.write(progress);
    throw;
  }
  try {
    folder.write(progress);  // so that the array is known, whatever becomes of the next
  } catch (...) {
    cancel({job});
    throw;
  }
  submit_gather(folder, settings, progress);
}

// Who submitted the last jobs may have been killed before it noted their numbers.
void find_unnoted_jobs(const StudyFolder& folder, const Settings& settings, Progress& progress) {
  if (progress.batches.empty()) return;
  SubmittedBatch& batch = progress.batches.back();
  if (batch.array_job.empty()) batch.array_job = job_of(array_request(folder, settings, progress));
  if (batch.gather_job.empty()) batch.gather_job = job_of(gather_request(folder, settings, progress));
}

// What this step found about parts and nodes, after what earlier ones did.
void keep_remarks(const Gathered& gathered, Progress& progress) {
  for (const std::string& each : gathered.refused_nodes) {
    if (std::ranges::find(progress.refused_nodes, each) == progress.refused_nodes.end())
      progress.refused_nodes.push_back(each);
  }
  progress.remarks.insert(progress.remarks.end(), gathered.remarks.begin(), gathered.remarks.end());
  if (progress.remarks.size() > most_remarks)
    progress.remarks.erase(progress.remarks.begin(), progress.remarks.end() - most_remarks);
}

// Nobody comes after the array where the job for that was ended, or was refused.
void require_gather_job(const StudyFolder& folder, const Settings& settings, Progress& progress) {
  const std::string& job = progress.batches.back().gather_job;
  if (job.empty() || (!is_within({job}) && alive({job}).empty())) submit_gather(folder, settings, progress);
}

// What plays on is not wanted any more: a test has decided.
void end_jobs(const StudyFolder& folder, const Settings& settings, Progress& progress) {
  const std::string& array = progress.batches.back().array_job;
  if (!is_within({array})) return cancel(jobs_alive(progress));
  // A task ends its own array, and with it this process; the job after that one says what came of the study.
  require_gather_job(folder, settings, progress);
  cancel({array});
}

void complete(const StudyFolder& folder, const Settings& settings, std::uint64_t rows, std::uint64_t seen,
              bool array_lives, Progress& progress) {
  const bool was = std::exchange(progress.state, Progress::State::complete) == Progress::State::complete;
  // Equal matches share a row: of these there may be more than is said.
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
  const std::vector<campaign::Job> jobs =
      results::first_jobs(results::stored_study(folder.results().string(), results, {}, invocation.studies)->study());
  if (jobs.empty()) return;
  const std::string different = what_differs_here(jobs.front());
  if (different.empty()) return;
  throw command::BadInput(fmt::format(
      "this machine is none to go on with the study: {}; on one of its nodes: {}", different,
      process::shell_line(std::vector<std::string>{folder.program().string(), "gather", folder.root().string()})));
}

// The file of results is held.
Step step(const StudyFolder& folder, campaign::Store& results, bool restart, const results::Invocation& invocation) {
  const Settings settings = folder.settings();
  Step out;
  Progress& progress = out.progress = folder.progress();
  const bool has_batch = !progress.batches.empty();
  find_unnoted_jobs(folder, settings, progress);
  const bool array_lives = has_batch && !alive({progress.batches.back().array_job}).empty();
  out.gathered = gather(folder, results, array_lives ? Tasks::ended : Tasks::killed_too, REGISTA_VERSION);
  keep_remarks(out.gathered, progress);
  folder.write(progress);  // whatever is met below
  const auto report = results::stored_study(folder.results().string(), results, {}, invocation.studies);
  const Missing missing = missing_of(report->study(), results, settings.tasks * settings.matches);
  const report::Outline outline = report->outline();
  progress.title = outline.title;
  progress.matches = report->study().most_matches();
  progress.finding = report->study().counted() > 0 ? plain(outline.headline) : "";
  progress.rows = static_cast<std::uint64_t>(results.rows());
  folder.write(progress);  // whatever Slurm says below
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
        folder.write_plan(results, REGISTA_VERSION);  // it was given more pairs
      submit_next(folder, settings, missing, progress.rows, progress);
      out.submitted = progress.batches.back().matches;
      out.plays = true;
    }
  }
  folder.write(progress);
  return out;
}

}  // namespace

std::string command_to_go_on(const StudyFolder& folder) {
  return process::shell_line(std::vector<std::string>{"regista", "resume", folder.root().string()});
}

std::string what_differs_here(const campaign::Job& planned) {
  std::vector<std::string> out;
  if (campaign::input_of(planned, campaign::program_input) != campaign::program_hash())
    out.emplace_back("its program is another");
  if (campaign::input_of(planned, campaign::mathematics_input) != campaign::mathematics_fingerprint())
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
  const Settings settings = folder.settings();  // else the folder is none of a study
  const campaign::Store held = opened(folder);
  Progress progress = folder.progress();
  if (progress.state == Progress::State::complete)
    throw command::BadInput(fmt::format("stop: {}: the study is complete", texts::one_line(folder.root().string())));
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
  const auto something_is_left = [&folder] {
    const std::vector<Course> all = courses(folder);
    return std::ranges::any_of(all, &Course::ended);
  };
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
      // Who ended meanwhile met a file in use, and has left its matches to this process.
    } while (++looks < most_looks && something_is_left());
  } catch (const campaign::StoreInUse&) {
    // Somebody else takes a step just now.
  } catch (const std::exception& error) {
    command::complain(fmt::format("whether the study is over was not seen: {}", error.what()));  // the next step looks
  }
}

Step take_step(const StudyFolder& folder, bool restart, const results::Invocation& invocation) {
  folder.settings();  // else the folder is none of a study
  campaign::Store results = opened(folder);
  require_same_results_here(folder, results, invocation);
  const auto failed = [&](const std::string& why) {
    Progress progress = folder.progress();
    if (progress.batches.empty()) return why;
    progress.state = Progress::State::failed;
    progress.message = why;
    folder.write(progress);
    return fmt::format("{}; to go on: {}", why, command_to_go_on(folder));
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
    throw output::WriteError(fmt::format("{}; to go on: {}", error.what(), command_to_go_on(folder)));
  } catch (const campaign::StoreError& error) {
    throw command::BadInput(failed(error.what()));
  }
}

}  // namespace regista::cluster
