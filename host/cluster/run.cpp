// SPDX-License-Identifier: MIT
#include "cluster/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <system_error>
#include <thread>

#include "campaign/match_setup.hpp"
#include "campaign/store.hpp"
#include "cluster/batch.hpp"
#include "command/terminal.hpp"
#include "config/scalar.hpp"
#include "output/output_files.hpp"
#include "output/replaced_file.hpp"
#include "process/child.hpp"
#include "results/results_file.hpp"
#include "results/study_run.hpp"
#include "texts/message.hpp"

namespace regista::cluster {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using command::BadInput;
using Clock = std::chrono::steady_clock;

constexpr std::uint64_t most_tasks = 1000;  // tasks of an array: usual limit of clusters (MaxArraySize 1001)

Settings settings_of(const Options& options, const campaign::Options& campaign) {
  Settings out;
  if (!options.array.empty()) out.tasks = config::parse_whole("--array", options.array, 1, most_tasks);
  if (!options.per_task.empty()) out.matches = config::parse_whole("--per-task", options.per_task, 1, 1'000'000);
  if (!campaign.workers.empty()) out.workers = static_cast<std::uint64_t>(campaign::number_of_workers(campaign));
  out.partition = options.partition;
  out.time = options.time;
  for (const std::string& each : options.sbatch) out.options.push_back("--" + each);
  out.record_every = campaign::record_every(campaign);
  return out;
}

// Returns the plugin files that the study's matches need: only these files of the plugin folders are copied.
std::vector<std::string> plugin_files_of(study::Study& study, const results::Invocation& invocation) {
  const std::vector<campaign::Job> jobs = results::first_jobs(study);
  if (jobs.empty()) throw BadInput("run: the study asks for no match");
  const plugin::Catalogue catalogue = results::open_plugins(jobs.front().plugins, invocation);
  for (const campaign::Job& each : jobs) campaign::match_setup(each, catalogue);
  std::vector<std::string> out;
  for (const std::string& each : catalogue.used_files()) out.push_back(fs::absolute(each).lexically_normal().string());
  return out;
}

void write_script(const fs::path& file, const std::string& command) {
  output::write_whole(file, "#!/bin/sh\n" + command + "\n", output::Existing::replaced);
  std::error_code none;
  fs::permissions(file, fs::perms::owner_exec | fs::perms::group_exec, fs::perm_options::add, none);
}

void write_scripts(const StudyFolder& folder) {
  const std::string program = process::shell_line({folder.program().string()}),
                    root = process::shell_line({folder.root().string()});
  write_script(folder.root() / "task.sh",
               fmt::format("exec {} cluster-task {} \"$1\" \"$SLURM_ARRAY_TASK_ID\"", program, root));
  write_script(folder.root() / "gather.sh", fmt::format("exec {} gather {}", program, root));
}

// Copies all inputs of a study into its folder.
void lay_out(const StudyFolder& folder, Settings settings, const results::Invocation& invocation) {
  const std::string results = folder.results().string();
  const campaign::Store store = results::read_results(results);
  const auto report = results::stored_study(results, store, {}, invocation.studies);
  const std::string given_in = report->study().folder();
  settings.plugin_files = plugin_files_of(report->study(), invocation);
  std::vector<fs::path> files(settings.plugin_files.begin(), settings.plugin_files.end());
  for (const campaign::Document& each : store.documents()) files.emplace_back(each.path);
  std::error_code none;
  fs::create_directories(folder.copy_of(given_in), none);
  folder.copy_in(files);
  folder.write_plan(store);
  folder.write(settings);
  write_scripts(folder);
}

std::string in_words(const SubmittedBatch& batch) {
  return fmt::format("batch {}: job {}, {} matches in {} tasks", batch.number, batch.array_job, batch.matches,
                     batch.tasks);
}

// Writes the report of a complete study and the files beside its results. Plays nothing.
int finish(const StudyFolder& folder, const Progress& progress, const campaign::Options& options,
           const results::Invocation& invocation) {
  if (!options.quiet && !progress.message.empty()) command::say(progress.message + '\n');
  campaign::Options own = options;
  own.results = folder.results().string();
  own.resume = own.quiet = true;
  own.plays = campaign::Options::Plays::nothing_more;
  const std::string plan = results::stored_plan(results::read_results(own.results));
  const results::StudyKind& kind = results::kind_of(own.results, plan, invocation.studies);
  const auto report = results::stored_study(own.results, results::read_results(own.results),
                                            results::play_again(invocation), invocation.studies);
  std::error_code no_folder;  // ignored: this node may lack the study's folder, from which file names start
  fs::current_path(report->study().folder(), no_folder);
  output::OutputFiles outputs({}, "study");
  outputs.write_beside(own.results, !own.no_page, kind.figures);
  if (!options.quiet) command::say(fmt::format("results: {}\n", texts::one_line(own.results)));
  if (kind.play) return kind.play(plan, own, outputs, invocation);
  campaign::Store store = results::open_results(own.results, true, report->study(), {}, invocation.studies);
  return results::play_study(*report, own, invocation, store, {});
}

// Waits for the end of a study and shows a line of progress.
class Follower {
 public:
  Follower(const StudyFolder& folder, const campaign::Options& options, const results::Invocation& invocation)
      : folder_(folder),
        options_(options),
        invocation_(invocation),
        line_(!options.quiet),
        batches_(folder.progress().batches.size()) {}

  int run() {
    wait();
    return finish(folder_, folder_.progress(), options_, invocation_);
  }

 private:
  // The Interruption of wait() must be destroyed before the report creates its own Interruption.
  void wait() {
    const std::string to_look = folder_.command("status"), to_end = folder_.command("stop");
    const command::Interruption interruption(
        fmt::format("regista: interrupted; the array plays on; to look: {}\n", to_look));
    for (;;) {
      const Progress progress = folder_.progress();
      tell_what_is_new(progress);
      if (progress.state == Progress::State::complete) break;
      if (progress.state != Progress::State::running) {
        line_.clear();
        throw BadInput(fmt::format("{}: the study has {}: {}; to go on: {}", folder_.name(),
                                   progress.state == Progress::State::stopped ? "been stopped" : "failed",
                                   progress.message, folder_.command("resume")));
      }
      if (interruption.requested()) {
        line_.clear();
        throw command::Interrupted(
            fmt::format("interrupted; the array plays on; to look: {}; to end it: {}", to_look, to_end),
            interruption.signal_number());
      }
      if (Clock::now() >= next_step_) take_step_if_it_is_time(progress);
      if (line_.due()) line_.show(in_words(status_of(folder_)));
      std::this_thread::sleep_for(500ms);
    }
    line_.clear();
    wait_for_jobs(interruption);
  }

  void tell_what_is_new(const Progress& progress) {
    if (options_.quiet) return;
    for (; batches_ < progress.batches.size(); ++batches_) say(in_words(progress.batches[batches_]));
    for (const std::string& each : progress.remarks) {
      if (std::ranges::find(remarks_, each) == remarks_.end()) say(each);
    }
    remarks_ = progress.remarks;
  }
  void say(const std::string& text) {
    line_.clear();
    command::say(text + '\n');
  }

  // Takes a step if tasks have ended, because their matches may end the study, or if no job is left to take a step.
  void take_step_if_it_is_time(const Progress& progress) {
    const auto began = Clock::now();
    bool wanted = status_of(folder_).ended > 0;
    try {
      wanted = wanted || jobs_alive(progress).empty();
    } catch (const SlurmError&) {
      // Slurm does not answer at present. This is ignored, because the study's files still show its state.
    }
    if (wanted) take_step(folder_, false, invocation_);
    // The slower a step is, the longer the pause before the next step.
    next_step_ = Clock::now() + std::max<Clock::duration>(5s, 20 * (Clock::now() - began));
  }

  // Waits for the end of all jobs, because the job that gathered the last matches also writes the page.
  void wait_for_jobs(const command::Interruption& interruption) const {
    const auto until = Clock::now() + 10min;
    try {
      while (!interruption.requested() && Clock::now() < until && !jobs_alive(folder_.progress()).empty())
        std::this_thread::sleep_for(300ms);
    } catch (const SlurmError&) {
      // Slurm did not answer. This is ignored: if a job still uses the file of results, opening this file will fail.
    }
  }

  const StudyFolder& folder_;
  const campaign::Options& options_;
  const results::Invocation& invocation_;
  command::RewrittenLine line_;
  std::size_t batches_;  // number of batches that were reported
  std::vector<std::string> remarks_;
  Clock::time_point next_step_ = Clock::now() + 5s;
};

}  // namespace

int run_on_cluster(const Options& options, const campaign::Options& campaign, const std::string& file,
                   const std::function<void(const campaign::Options& options)>& begin,
                   const results::Invocation& invocation) {
  if (!campaign.results.empty()) throw BadInput("--results: with --on the results lie in the study's folder: --folder");
  if (campaign.resume) throw BadInput("--resume: a study on a cluster is gone on with by: regista resume FOLDER");
  const Settings settings = settings_of(options, campaign);
  const StudyFolder folder(options.folder.empty() ? fs::path(file).stem().string() + ".cluster" : options.folder);
  folder.create(settings);
  Step step;
  try {
    campaign::Options own = campaign;
    own.results = folder.results().string();
    own.plays = campaign::Options::Plays::nothing_yet;
    own.no_page = true;
    begin(own);
    lay_out(folder, settings, invocation);
    step = take_step(folder, false, invocation);
  } catch (...) {
    std::error_code none;
    if (folder.progress().batches.empty()) fs::remove_all(folder.root(), none);  // there are no results yet
    throw;
  }
  if (!campaign.quiet && step.plays) {
    command::say(fmt::format("{}: {}\n", folder.name(), in_words(step.progress.batches.back())));
    if (step.round < step.progress.matches)
      command::say(
          fmt::format("the study asks for {} matches at a time and chooses them by the results so far: more tasks than "
                      "that gain nothing\n",
                      step.round));
  }
  if (options.detach) {
    if (!campaign.quiet) command::say(fmt::format("to look: {}\n", folder.command("status")));
    return command::exit_done;
  }
  return Follower(folder, campaign, invocation).run();
}

int tell_step(const StudyFolder& folder, const Step& step, const campaign::Options& options,
              const results::Invocation& invocation) {
  for (const std::string& each : step.gathered.remarks) command::complain(each);
  if (step.gathered.refused > 0)
    command::complain(fmt::format("{} matches do not fit; their parts are kept in {}", step.gathered.refused,
                                  texts::one_line(folder.set_aside().string())));
  if (step.progress.state == Progress::State::complete) return finish(folder, step.progress, options, invocation);
  if (step.progress.state == Progress::State::failed)
    throw BadInput(fmt::format("{}; to go on: {}", texts::one_line(step.progress.message), folder.command("resume")));
  if (!options.quiet) {
    std::string text = fmt::format("{} matches gathered", step.gathered.rows);
    if (step.submitted > 0) text += ", " + in_words(step.progress.batches.back());
    if (step.progress.state == Progress::State::stopped)
      text += fmt::format("; the study was stopped; to go on: {}", folder.command("resume"));
    command::say(text + '\n');
  }
  return command::exit_done;
}

Status status_of(const StudyFolder& folder) {
  Status out;
  out.progress = folder.progress();
  for (const TaskProgress& each : task_progress(folder)) {
    out.in_parts += each.done;
    out.failed_in_parts += each.failed;
    if (each.ended) ++out.ended;
    // A killed task does not write its end, so its file is ignored if the study does not run.
    if (each.ended || out.progress.state != Progress::State::running) continue;
    ++out.running;
    if (each.seconds > 0.0) out.rate += static_cast<double>(each.fresh) / each.seconds;
  }
  return out;
}

std::string in_words(const Status& status) {
  const std::uint64_t done = status.progress.rows + status.in_parts, all = status.progress.matches;
  std::string out = all == 0 ? texts::plural(done, "match", "matches") : fmt::format("{} of {} matches", done, all);
  if (status.failed_in_parts > 0) out += fmt::format(", {} forfeited or set aside lately", status.failed_in_parts);
  if (status.running > 0) out += ", " + texts::plural(status.running, "task plays", "tasks play");
  if (status.rate > 0.0) {
    out += fmt::format(", {:.3g} matches a second", status.rate);
    if (all > done)
      out += fmt::format(", some {} left", texts::duration(static_cast<double>(all - done) / status.rate));
  }
  return out;
}

}  // namespace regista::cluster
