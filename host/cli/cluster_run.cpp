// SPDX-License-Identifier: MIT
#include "cli/cluster_run.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <stdexcept>
#include <system_error>
#include <thread>
#include <utility>

#include "campaign/job_setup.hpp"
#include "campaign/match_setup.hpp"
#include "campaign/shell.hpp"
#include "cli/commands.hpp"
#include "cli/plugin_folders.hpp"
#include "cli/results_file.hpp"
#include "cli/study_run.hpp"
#include "cluster/batch.hpp"
#include "cluster/missing.hpp"
#include "cluster/slurm.hpp"
#include "command/interruption.hpp"
#include "command/terminal.hpp"
#include "config/text.hpp"
#include "config/typed.hpp"
#include "output/output.hpp"
#include "output/output_files.hpp"
#include "output/replaced_file.hpp"

namespace regista::cli {
namespace {

namespace fs = std::filesystem;
using cluster::Progress;
using cluster::Settings;
using cluster::StudyFolder;

constexpr std::uint64_t most_tasks = 1000;  // of an array, as clusters are usually set (MaxArraySize 1001)
constexpr std::uint64_t most_fruitless = 3;
constexpr std::chrono::seconds patience{60};  // for another process that gathers

std::string name_of(const StudyFolder& folder) { return config::one_line(folder.root().string()); }

// What of the options was typed for it.
Settings settings_of(const ClusterOptions& options, const campaign::Options& campaign) {
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

// The files of plugins that the study's matches need: whatever the folders hold besides does not travel.
std::vector<std::string> plugin_files_of(study::Study& study, const Invocation& invocation) {
  const std::vector<campaign::Job> jobs = first_jobs(study);
  if (jobs.empty()) throw BadInput("run: the study asks for no match");
  const plugin::Catalogue catalogue = open_plugins(jobs.front().plugins, invocation);
  for (const campaign::Job& each : jobs) campaign::match_setup(campaign::request_of(each), catalogue);
  std::vector<std::string> out;
  for (const std::string& each : catalogue.used_files()) out.push_back(fs::absolute(each).lexically_normal().string());
  return out;
}

void write_script(const fs::path& file, const std::string& command) {
  output::write_whole(file, "#!/bin/sh\n" + command + "\n", output::Existing::replaced);
  std::error_code none;
  fs::permissions(file, fs::perms::owner_exec | fs::perms::group_exec, fs::perm_options::add, none);
}

std::string line_of(const std::vector<std::string>& words) { return campaign::shell_line(words); }
std::string word(const fs::path& path) { return line_of({path.string()}); }

void write_scripts(const StudyFolder& folder) {
  write_script(folder.root() / "task.sh", fmt::format("exec {} cluster-task {} \"$1\" \"$SLURM_ARRAY_TASK_ID\"",
                                                      word(folder.program()), word(folder.root())));
  write_script(folder.root() / "gather.sh",
               fmt::format("exec {} gather {}", word(folder.program()), word(folder.root())));
}

void copy_over(const fs::path& from, const fs::path& to) {
  std::error_code error;
  fs::copy_file(from, to, fs::copy_options::overwrite_existing, error);
  if (error)
    throw output::WriteError(fmt::format("cannot copy {} to {}: {}", from.string(), to.string(), error.message()));
}

std::vector<std::string> array_jobs(const Progress& progress) {
  return progress.batches.empty() ? std::vector<std::string>() : std::vector{progress.batches.back().array_job};
}

void submit_next(const StudyFolder& folder, const Settings& settings, const cluster::Missing& missing,
                 Progress& progress) {
  cluster::Batch batch;
  batch.first_row = missing.first_row;
  // As many tasks as may be, each with as few matches as then are left for it.
  std::uint64_t left = 0;
  for (const cluster::Slice& each : missing.places) left += each.end - each.begin;
  const std::uint64_t matches =
      std::clamp<std::uint64_t>((left + settings.tasks - 1) / settings.tasks, 1, settings.matches);
  batch.slices = cluster::divided(missing.places, matches, settings.tasks);
  const std::uint64_t number = progress.batches.size() + 1;
  if (!missing.is_first) copy_over(folder.results(), folder.known_before(number));
  output::write_whole(folder.batch(number), cluster::to_json(batch), output::Existing::replaced);

  cluster::JobRequest array;
  array.name = folder.root().filename().string();
  array.script = folder.root() / "task.sh";
  array.arguments = {std::to_string(number)};
  array.output = folder.logs() / fmt::format("{}-%a.txt", number);
  array.tasks = batch.slices.size();
  array.processors = settings.workers;
  if (!settings.partition.empty()) array.options.push_back("--partition=" + settings.partition);
  if (!settings.time.empty()) array.options.push_back("--time=" + settings.time);
  array.options.insert(array.options.end(), settings.options.begin(), settings.options.end());
  cluster::JobRequest gather = array;
  if (!progress.refused_nodes.empty())
    array.options.push_back(fmt::format("--exclude={}", fmt::join(progress.refused_nodes, ",")));
  cluster::SubmittedBatch submitted{number, batch.slices.size(), batch.matches(), cluster::submit(array), ""};
  progress.batches.push_back(submitted);
  folder.write(progress);  // so that the array is known, whatever becomes of the next
  gather.name += "-gather";
  gather.script = folder.root() / "gather.sh";
  gather.arguments.clear();
  gather.output = folder.logs() / fmt::format("{}-gather.txt", number);
  gather.tasks = 0;
  gather.processors = 1;
  gather.after = submitted.array_job;
  progress.batches.back().gather_job = cluster::submit(gather);
  folder.write(progress);
}

campaign::Store opened(const StudyFolder& folder) {
  const auto until = std::chrono::steady_clock::now() + patience;
  for (;;) {
    try {
      return {folder.results(), campaign::Store::Mode::open, REGISTA_VERSION, campaign::Journal::rollback};
    } catch (const campaign::StoreInUse& error) {
      if (std::chrono::steady_clock::now() > until) throw BadInput(error.what());
    } catch (const campaign::StoreRefusal& error) {
      throw BadInput(error.what());
    } catch (const campaign::StoreDiskError& error) {
      throw output::WriteError(error.what());
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
  }
}

// In a moment that belongs to whoever holds the file of results.
ClusterStep step_while_open(const StudyFolder& folder, campaign::Store& results, bool restart,
                            const Invocation& invocation) {
  const Settings settings = folder.settings();
  ClusterStep out;
  out.gathered = cluster::gather(folder, results, REGISTA_VERSION);
  Progress& progress = out.progress = folder.progress();
  for (const std::string& each : out.gathered.refused_nodes) {
    if (std::ranges::find(progress.refused_nodes, each) == progress.refused_nodes.end())
      progress.refused_nodes.push_back(each);
  }
  const auto report = stored_study(folder.results().string(), results, {}, invocation.studies);
  const cluster::Missing missing = cluster::missing_of(report->study(), results, settings.tasks * settings.matches);
  if (missing.complete()) {
    // What plays on is not wanted any more: a test has decided.
    std::vector<std::string> rest = all_jobs(progress);
    std::erase_if(rest, [](const std::string& job) { return cluster::is_within({job}); });
    if (progress.state != Progress::State::complete) cluster::cancel(cluster::alive(rest));
    progress.state = Progress::State::complete;
    const auto rows = static_cast<std::uint64_t>(results.rows());
    progress.message = rows <= missing.taken ? std::string()
                                             : fmt::format(
                                                   "{} matches were played beyond the end of the study, and "
                                                   "are not counted",
                                                   rows - missing.taken);
    folder.write(progress);
    return out;
  }
  out.round = missing.round;
  if (restart) {
    progress.state = Progress::State::running;
    progress.message.clear();
    progress.fruitless = 0;
    progress.refused_nodes.clear();
  }
  out.plays = !cluster::alive(array_jobs(progress)).empty();
  if (!out.plays && progress.state == Progress::State::running) {
    const bool fruitless = !progress.batches.empty() && out.gathered.rows == 0 && !restart;
    progress.fruitless = fruitless ? progress.fruitless + 1 : 0;
    if (progress.fruitless >= most_fruitless) {
      progress.state = Progress::State::failed;
      progress.message =
          fmt::format("{} batches in a row brought no match; what their tasks wrote stands in {}{}", most_fruitless,
                      folder.logs().string(), out.gathered.remarks.empty() ? "" : "; " + out.gathered.remarks.back());
    } else {
      submit_next(folder, settings, missing, progress);
      out.submitted = progress.batches.back().matches;
      out.plays = true;
    }
  }
  folder.write(progress);
  return out;
}

std::string to_look(const StudyFolder& folder) { return line_of({"regista", "status", folder.root().string()}); }
std::string to_go_on(const StudyFolder& folder) { return line_of({"regista", "resume", folder.root().string()}); }

void tell_of_end(const Progress& progress, const campaign::Options& options) {
  if (!options.quiet && !progress.message.empty()) command::say(progress.message + '\n');
}

std::string in_words(const cluster::SubmittedBatch& batch) {
  return fmt::format("batch {}: job {}, {} matches in {} tasks", batch.number, batch.array_job, batch.matches,
                     batch.tasks);
}

std::string minutes_text(double seconds) {
  if (seconds < 90.0) return fmt::format("{:.0f} s", seconds);
  if (seconds < 5400.0) return fmt::format("{:.0f} min", seconds / 60.0);
  return fmt::format("{:.1f} h", seconds / 3600.0);
}

}  // namespace

void add_cluster_options(Command& command, ClusterOptions& options) {
  command.choose("--on", options.on, {"slurm"}, "play the matches as a job array of this scheduler");
  command.take("--folder", options.folder, "FOLDER",
               "with --on: a new folder that all nodes see, for the study; default: its document's name with .cluster",
               Writes::sources);
  command.take("--array", options.array, "N", "with --on: at most so many tasks at a time; default 64");
  command.take("--per-task", options.per_task, "N",
               "with --on: at most so many matches in a task; default 100. N times --array is what a test can be late");
  command.take("--partition", options.partition, "NAME", "with --on: where the tasks run; default: the cluster's own");
  command.take("--time", options.time, "TIME", "with --on: limit of a task's time, as sbatch understands it");
  command.take("--sbatch", options.sbatch, "NAME=VALUE",
               "with --on: another option for sbatch, without its --, as account=robots; may be repeated");
  command.flag("--detach", options.detach, "with --on: do not wait for the end of the study");
}

std::vector<std::string> all_jobs(const Progress& progress) {
  std::vector<std::string> out;
  for (const cluster::SubmittedBatch& each : progress.batches) {
    for (const std::string& job : {each.array_job, each.gather_job}) {
      if (!job.empty()) out.push_back(job);
    }
  }
  return out;
}

ClusterStep take_step(const StudyFolder& folder, bool restart, const Invocation& invocation) {
  folder.settings();  // else the folder is none of a study
  campaign::Store results = opened(folder);
  const auto failed = [&](const std::string& why) {
    Progress progress = folder.progress();
    if (progress.batches.empty()) return why;
    progress.state = Progress::State::failed;
    progress.message = why;
    folder.write(progress);
    return fmt::format("{}; to go on: {}", why, to_go_on(folder));
  };
  try {
    return step_while_open(folder, results, restart, invocation);
  } catch (const cluster::SlurmError& error) {
    throw BadInput(failed(error.what()));
  } catch (const study::StudyError& error) {
    throw BadInput(failed(error.what()));
  } catch (const campaign::StoreDiskError& error) {
    throw output::WriteError(fmt::format("{}; to go on: {}", error.what(), to_go_on(folder)));
  } catch (const campaign::StoreError& error) {
    throw BadInput(error.what());
  }
}

int run_on_cluster(const ClusterOptions& options, const campaign::Options& campaign, const std::string& file,
                   const std::function<void(const campaign::Options& options)>& begin, const Invocation& invocation) {
  if (!campaign.results.empty()) throw BadInput("--results: with --on the results lie in the study's folder: --folder");
  if (campaign.resume) throw BadInput("--resume: a study on a cluster is gone on with by: regista resume FOLDER");
  Settings settings = settings_of(options, campaign);
  const StudyFolder folder(options.folder.empty() ? fs::path(file).stem().string() + ".cluster" : options.folder);
  folder.create(settings);
  ClusterStep step;
  try {
    campaign::Options own = campaign;
    own.results = folder.results().string();
    own.begin_only = own.no_page = true;
    begin(own);
    std::vector<fs::path> files;
    {
      const campaign::Store store = read_results(own.results);
      const auto report = stored_study(own.results, store, {}, invocation.studies);
      settings.plugin_files = plugin_files_of(report->study(), invocation);
      for (const campaign::Document& each : store.documents()) files.emplace_back(each.path);
      std::error_code none;
      fs::create_directories(folder.copy_of(report->study().folder()), none);
    }
    files.insert(files.end(), settings.plugin_files.begin(), settings.plugin_files.end());
    folder.copy_in(files);
    copy_over(folder.results(), folder.plan());
    folder.write(settings);
    write_scripts(folder);
    step = take_step(folder, false, invocation);
  } catch (...) {
    std::error_code none;
    if (folder.progress().batches.empty()) fs::remove_all(folder.root(), none);  // there is nothing in it but copies
    throw;
  }
  if (!campaign.quiet && step.plays) {
    command::say(fmt::format("{}: {}\n", name_of(folder), in_words(step.progress.batches.back())));
    if (step.round < settings.tasks)
      command::say(fmt::format("the study asks for {} matches at a time: more tasks gain nothing\n", step.round));
  }
  if (options.detach) {
    if (!campaign.quiet) command::say(fmt::format("to look: {}\n", to_look(folder)));
    return exit_done;
  }
  return follow(folder, campaign, invocation);
}

int finish_on_cluster(const StudyFolder& folder, const campaign::Options& options, const Invocation& invocation) {
  campaign::Options own = options;
  own.results = folder.results().string();
  own.resume = true;
  const std::string plan = stored_plan(read_results(own.results));
  const StudyKind& kind = kind_of(own.results, plan, invocation.studies);
  using enum output::OutputFiles::Page;
  output::OutputFiles outputs({}, "study");
  outputs.write_beside(own.results, own.no_page ? none : kind.figures ? with_figures : alone);
  if (kind.go_on) return kind.go_on(plan, own, outputs, invocation);
  const auto report = stored_study(own.results, read_results(own.results), play_again(invocation), invocation.studies);
  campaign::Store store = open_results(own.results, true, report->study(), {}, invocation.studies);
  StudyWishes wishes;
  wishes.figures = kind.figures;
  return play_study(*report, own, invocation, store, wishes);
}

int follow(const StudyFolder& folder, const campaign::Options& options, const Invocation& invocation) {
  using namespace std::chrono_literals;
  const command::Interruption interruption(
      fmt::format("regista: interrupted; the array plays on; to look: {}\n", to_look(folder)));
  command::RewrittenLine line(!options.quiet);
  auto asked = std::chrono::steady_clock::now();
  std::size_t told = folder.progress().batches.size();
  for (;;) {
    const Progress progress = folder.progress();
    for (; told < progress.batches.size() && !options.quiet; ++told) {
      line.clear();
      command::say(in_words(progress.batches[told]) + '\n');
    }
    if (progress.state == Progress::State::complete) break;
    if (progress.state != Progress::State::running) {
      line.clear();
      throw BadInput(fmt::format("{}: the study has {}: {}; to go on: {}", name_of(folder),
                                 progress.state == Progress::State::stopped ? "been stopped" : "failed",
                                 progress.message, to_go_on(folder)));
    }
    if (interruption.requested()) {
      line.clear();
      throw Interrupted(fmt::format("interrupted; the array plays on; to look: {}; to end it: {}", to_look(folder),
                                    line_of({"regista", "stop", folder.root().string()})),
                        interruption.signal_number());
    }
    if (std::chrono::steady_clock::now() - asked > 5s) {
      asked = std::chrono::steady_clock::now();
      try {
        if (cluster::alive(all_jobs(progress)).empty()) take_step(folder, false, invocation);
      } catch (const cluster::SlurmError&) {
        // Slurm is restarted, perhaps; the files tell how things stand.
      }
    }
    if (line.due()) line.show(in_words(status_of(folder, invocation, Findings::left_out)));
    std::this_thread::sleep_for(500ms);
  }
  line.clear();
  // The job that gathered the last matches may still write the page.
  { const campaign::Store store = opened(folder); }
  tell_of_end(folder.progress(), options);
  return finish_on_cluster(folder, options, invocation);
}

int tell_step(const StudyFolder& folder, const ClusterStep& step, const campaign::Options& options,
              const Invocation& invocation) {
  for (const std::string& each : step.gathered.remarks) complain(each);
  if (step.gathered.refused > 0)
    complain(fmt::format("{} matches do not fit; their parts are kept in {}", step.gathered.refused,
                         config::one_line(folder.set_aside().string())));
  if (step.progress.state == Progress::State::complete) {
    tell_of_end(step.progress, options);
    return finish_on_cluster(folder, options, invocation);
  }
  if (step.progress.state == Progress::State::failed)
    throw BadInput(fmt::format("{}; to go on: {}", config::one_line(step.progress.message), to_go_on(folder)));
  if (!options.quiet) {
    std::string text = fmt::format("{} matches gathered", step.gathered.rows);
    if (step.submitted > 0) text += fmt::format(", {} submitted", step.submitted);
    if (step.progress.state == Progress::State::stopped)
      text += fmt::format("; the study was stopped; to go on: {}", to_go_on(folder));
    command::say(text + '\n');
  }
  return exit_done;
}

ClusterStatus status_of(const StudyFolder& folder, const Invocation& invocation, Findings findings) {
  ClusterStatus out;
  out.progress = folder.progress();
  for (const cluster::Course& each : cluster::courses(folder)) {
    out.in_parts += each.done;
    out.failed += each.failed;
    ++(each.ended ? out.ended : out.running);
    if (!each.ended && each.seconds > 0.0) out.rate += static_cast<double>(each.fresh) / each.seconds;
  }
  try {
    const campaign::Store store = read_results(folder.results().string());
    out.gathered = static_cast<std::uint64_t>(store.rows());
    const auto report = stored_study(folder.results().string(), store, {}, invocation.studies);
    out.most = report->study().most_matches();
    out.title = report->title();
    if (findings == Findings::wanted) study::read_back(report->study(), store, report->study().metrics());
    if (report->study().counted() > 0) out.headline = report->headline();
  } catch (const campaign::StoreError&) {
    // It is being written to just now.
  }
  return out;
}

std::string in_words(const ClusterStatus& status) {
  const std::uint64_t done = status.gathered + status.in_parts;
  std::string out = fmt::format("{} of {} matches", done, status.most);
  if (status.failed > 0) out += fmt::format(", {} forfeited or set aside", status.failed);
  if (status.running > 0)
    out += fmt::format(", {} {}", status.running, status.running == 1 ? "task plays" : "tasks play");
  if (status.rate > 0.0) {
    out += fmt::format(", {:.3g} matches a second", status.rate);
    if (status.most > done)
      out += fmt::format(", some {} left", minutes_text(static_cast<double>(status.most - done) / status.rate));
  }
  return out;
}

}  // namespace regista::cli
