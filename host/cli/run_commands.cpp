// SPDX-License-Identifier: MIT
// `regista run` and `resume` play any study, from its document or its file of results. `gather`, `status` and `stop`
// work on the folder of a study on a cluster.
#include <fmt/format.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>

#include "campaign/match_setup.hpp"
#include "cli/study_commands.hpp"
#include "cluster/run.hpp"
#include "cluster/step.hpp"
#include "cluster/study_folder.hpp"
#include "cluster/task.hpp"
#include "config/scalar.hpp"
#include "output/replaced_file.hpp"
#include "report/number.hpp"
#include "results/results_file.hpp"
#include "study/tournament_plan.hpp"
#include "texts/json.hpp"
#include "texts/message.hpp"

namespace regista::cli {
namespace {

// --- `regista run`: plays the study of a document of any kind.

constexpr auto run_examples = R"(Examples:
  regista run configs/studies/rivals.yaml
  regista run configs/studies/role_overlap.yaml --results night.db
  regista run configs/studies/tune_paper.yaml --set search.algorithm=spsa
  regista run configs/studies/rivals.yaml --until 08:00
  regista run configs/studies/rivals.yaml --on slurm --array 64 --per-task 200

The document is a tournament, an experiment or a tuning, and is played as `regista tournament`, `experiment` or `tune`
would play it; these have options of their own besides. What was begun is gone on with by: regista resume RESULTS.db)";

struct RunOptions : StudyOptions {
  cluster::Options on_cluster;
};

int play_here(const RunOptions& options, const output::OutputFiles& outputs, const Invocation& invocation) {
  if (options.file.empty()) throw BadInput("run: which study? Name its document; see: regista run --help");
  const config::Node document = config::load(options.file);
  if (const results::StudyKind* const study = results::study_asked(document, invocation.studies))
    return play(*study, options, outputs, invocation);
  const config::DocumentKind kind = config::kind_of(document);
  if (kind == config::DocumentKind::predictor_study) {
    throw BadInput(fmt::format(
        "run: {0} is a predictor study, which needs recordings: regista evaluate-predictor {0} --data RECORDING",
        texts::one_line(options.file)));
  }
  const auto names = texts::names_of(invocation.studies, [](const auto& each) { return each.document.name; });
  throw BadInput(fmt::format("run: {} is no study but of the kind {}; studies are {}", texts::one_line(options.file),
                             kind.name, texts::join(names)));
}

int play(const RunOptions& options, const output::OutputFiles& outputs, const Invocation& invocation) {
  const cluster::Options& cluster = options.on_cluster;
  if (!cluster.on.empty()) {
    campaign::Options campaign = options;
    campaign::check(campaign);
    if (options.live) throw BadInput("--live: belongs to a study that is played here, not to --on");
    if (campaign.end_of_time)
      throw BadInput(fmt::format("{}: is of a study that is played here, not on a cluster; --time limits its tasks",
                                 options.until.empty() ? "--minutes" : "--until"));
    const auto begin = [&](const campaign::Options& with) {
      RunOptions own = options;
      static_cast<campaign::Options&>(own) = with;
      play_here(own, outputs, invocation);
    };
    return cluster::run_on_cluster(cluster, options, options.file, begin, invocation);
  }
  for (const auto& [name, given] : {std::pair{"--folder", !cluster.folder.empty()},
                                    {"--array", !cluster.array.empty()},
                                    {"--per-task", !cluster.per_task.empty()},
                                    {"--partition", !cluster.partition.empty()},
                                    {"--time", !cluster.time.empty()},
                                    {"--sbatch", !cluster.sbatch.empty()},
                                    {"--detach", cluster.detach}}) {
    if (given) throw BadInput(fmt::format("{}: belongs to --on, which is not given", name));
  }
  return play_here(options, outputs, invocation);
}

void add_cluster_options(Command& command, cluster::Options& options) {
  command.choose("--on", options.on, {"slurm"}, "play the matches as a job array of this scheduler");
  command.take("--folder", options.folder, "FOLDER",
               "with --on: a new folder that all nodes see, for the study; default: its document's name with .cluster",
               Writes::sources);
  command.take("--array", options.array, "N", "with --on: at most so many tasks at a time; default 64");
  command.take(
      "--per-task", options.per_task, "N",
      "with --on: at most so many matches in a task, one that is played twice counts as six; default 100. N times "
      "--array is what a test can be late");
  command.take("--partition", options.partition, "NAME", "with --on: where the tasks run; default: the cluster's own");
  command.take("--time", options.time, "TIME", "with --on: limit of a task's time, as sbatch understands it");
  command.take("--sbatch", options.sbatch, "NAME=VALUE",
               "with --on: another option for sbatch, without its --, as account=robots; may be repeated");
  command.flag("--detach", options.detach, "with --on: do not wait for the end of the study");
}

// --- `regista resume`: continues the study of a file of results, which contains all inputs of the study.

constexpr auto resume_examples = R"(Examples:
  regista resume tournament.db
  regista resume night.db --workers 1
  regista resume rivals.db --pairs 200
  regista resume night.db --until 08:00

Plays what is missing, as it was planned: the file holds teams, profiles, seeds, test and limits, and knows what stood in
the documents and plugins. Where one of them or the program has changed since, nothing is played and the change is named.
--pairs gives a tournament or an experiment more pairs of matches: one that has ended, too, but none whose sequential
test was fixed for a number of them. A study that --until or --minutes stopped is complete; only another --until,
--minutes or --pairs goes on with it, and its report then says that pairs were added. A tuning writes its team to NAME.tuned.yaml beside the results.
--workers, --until, --minutes, --record-every and --notify are not stored: name them again.)";

struct ResumeOptions : campaign::Options {
  std::string file, pairs;
};

// Throws BadInput if the input files or the program have changed since the study began.
void require_unchanged(const std::string& results, std::span<const campaign::Job> jobs,
                       const plugin::Catalogue& catalogue) {
  const std::string program = campaign::program_hash(), mathematics = campaign::mathematics_fingerprint();
  for (const campaign::Job& job : jobs) {
    const campaign::MatchSetup now = campaign::match_setup(job, catalogue, campaign::KeyNames::former_too);
    const std::string changed = campaign::what_changed(job, now, catalogue, program, mathematics);
    if (changed.empty()) continue;
    throw BadInput(
        fmt::format("resume: {0} was begun with something else: {1}; its matches would be mixed with others; "
                    "to play it anew: regista report {0} --study FOLDER",
                    results, changed));
  }
}

// Continues a study on a cluster. options.file: the folder of the study.
int go_on_with_folder(const ResumeOptions& options, const Invocation& invocation) {
  const cluster::StudyFolder folder(options.file);
  folder.settings();  // throws if the folder is not a study folder
  for (const auto& [name, value] : {std::pair{"--workers", &options.workers},
                                    {"--record-every", &options.record_every},
                                    {"--notify", &options.notify},
                                    {"--until", &options.until},
                                    {"--minutes", &options.minutes}}) {
    if (!value->empty())
      throw BadInput(fmt::format("{}: is of a file of results; {} is the folder of a study on a cluster", name,
                                 texts::one_line(options.file)));
  }
  if (!options.pairs.empty()) {
    const std::uint64_t pairs = config::parse_whole("--pairs", options.pairs, 1, study::most_pairs);
    results::give_pairs(folder.results().string(), pairs, invocation.studies);
  }
  return cluster::tell_step(folder, cluster::take_step(folder, true, invocation), options, invocation);
}

int play(ResumeOptions options, output::OutputFiles outputs, const Invocation& invocation) {
  campaign::check(options);
  if (options.file.empty()) throw BadInput("resume: which results? Name the file; see: regista resume --help");
  if (std::filesystem::is_directory(options.file)) return go_on_with_folder(options, invocation);
  std::optional<std::uint64_t> pairs;
  if (!options.pairs.empty()) pairs = config::parse_whole("--pairs", options.pairs, 1, study::most_pairs);
  const std::string file = texts::one_line(options.file);
  options.results = std::filesystem::absolute(options.file).string();
  options.resume = true;
  std::vector<campaign::Job> jobs;
  bool figures = true;
  try {
    const campaign::Store store = results::read_results(options.file);
    figures = results::kind_of(file, results::stored_plan(store), invocation.studies).figures;
    const auto report = results::stored_study(file, store, {}, invocation.studies);
    results::enter_folder("resume: " + file, report->study().folder());
    jobs = results::first_jobs(report->study());
  } catch (const std::invalid_argument& error) {
    throw BadInput(fmt::format("resume: {}: {}", file, error.what()));
  }
  options.plugins = jobs.empty() ? std::vector<std::string>() : jobs.front().plugins;
  const plugin::Catalogue catalogue = results::open_stored_plugins(file, options.plugins, invocation);
  require_unchanged(file, jobs, catalogue);
  tell_what_is_not_used(catalogue, options.plugins);
  options.plugin_files = catalogue.used_files();
  outputs.read(folders_of(catalogue), Reads::plugins);
  for (const campaign::Job& job : jobs)
    outputs.read({job.teams.begin(), job.teams.end()}, Reads::documents, job.overrides);
  outputs.write_beside(options.results, !options.no_page, figures);
  outputs.check(false);
  if (pairs) results::give_pairs(options.results, *pairs, invocation.studies);

  const std::string plan = results::stored_plan(results::read_results(options.results));
  const results::StudyKind& kind = results::kind_of(file, plan, invocation.studies);
  if (kind.play) return kind.play(plan, options, outputs, invocation);
  auto report = results::stored_study(file, results::read_results(options.results), results::play_again(invocation),
                                      invocation.studies);
  campaign::Store store = results::open_results(options.results, true, report->study(), {}, invocation.studies);
  if (options.end_of_time) {
    results::lift_end(file, store, invocation.studies);
    report = results::stored_study(file, store, results::play_again(invocation), invocation.studies);
  }
  return results::play_study(*report, options, invocation, store, {});
}

using cluster::Progress;
using cluster::StudyFolder;

// --- `regista gather`, `status` and `stop`: commands for the folder of a study on a cluster.

constexpr auto gather_examples = R"(Examples:
  regista gather rivals.cluster
  regista gather rivals.cluster --json

Takes what the tasks have played over into FOLDER/results.db, and submits the next matches where some are missing and no
task plays. The job after each array does the same. A study that is complete is reported. Matches that do not fit are
named, and their part is kept in FOLDER/set_aside.)";

constexpr auto status_examples = R"(Examples:
  regista status rivals.cluster
  regista status rivals.cluster --json

By the files alone: matches that were gathered and that tasks have played since, and what was found in those that were
gathered. Nothing is changed, and Slurm is not asked.)";

constexpr auto stop_examples = R"(Examples:
  regista stop rivals.cluster

Ends the jobs of the study. What was played is kept, and regista resume FOLDER goes on.)";

struct FolderOptions {
  campaign::Options campaign;
  std::string folder;
};

StudyFolder folder_of(const FolderOptions& options, const char* command) {
  if (options.folder.empty())
    throw BadInput(fmt::format("{0}: which study? Name its folder; see: regista {0} --help", command));
  StudyFolder out(options.folder);
  out.settings();
  return out;
}

int tell_status(const FolderOptions& options) {
  const StudyFolder folder = folder_of(options, "status");
  const cluster::Status status = cluster::status_of(folder);
  const Progress& progress = status.progress;
  if (options.campaign.json) {
    const nlohmann::ordered_json json{{"folder", folder.root().string()},
                                      {"title", progress.title},
                                      {"state", name_of(progress.state)},
                                      {"message", progress.message},
                                      {"matches", progress.matches > 0 ? Json(progress.matches) : Json(nullptr)},
                                      {"gathered", progress.rows},
                                      {"in_parts", status.in_parts},
                                      {"failed_in_parts", status.failed_in_parts},
                                      {"tasks_playing", status.running},
                                      {"tasks_ended", status.ended},
                                      {"batches", progress.batches.size()},
                                      {"matches_per_second", status.rate},
                                      {"refused_nodes", progress.refused_nodes},
                                      {"remarks", progress.remarks},
                                      {"finding", progress.finding}};
    output::print(report::text_of(json, 2));
    return exit_done;
  }
  std::string text = fmt::format("{}: {}\n", texts::one_line(progress.title), name_of(progress.state));
  const auto line = [&text](const std::string& said) {
    if (!said.empty()) text += fmt::format("  {}\n", texts::one_line(said));
  };
  line(progress.message);
  line(cluster::in_words(status));
  for (const std::string& each : progress.remarks) line(each);
  line(progress.finding);
  output::print(text);
  return exit_done;
}

int gather(const FolderOptions& options, const Invocation& invocation) {
  const StudyFolder folder = folder_of(options, "gather");
  return cluster::tell_step(folder, cluster::take_step(folder, false, invocation), options.campaign, invocation);
}

int stop(const FolderOptions& options) {
  cluster::stop_study(folder_of(options, "stop"));
  return exit_done;
}

}  // namespace

void add_run(Command& parent, const Invocation& invocation) {
  Command& command = parent.add("run", "play the study of a document");
  const auto options = std::make_shared<RunOptions>();
  command.take("file", options->file, "STUDY.yaml", "a tournament, an experiment or a tuning", Reads::documents);
  add_document_options(command, *options, config::DocumentKind::tournament, {});
  add_campaign_options(command, *options, "the study's name with .db");
  add_cluster_options(command, options->on_cluster);
  command.notes(run_examples, "0 played, whatever was found; 1 the results could not be written", command::resumable);
  command.run = [options, &command, &invocation] { return play(*options, command.outputs("study"), invocation); };
}

void add_resume(Command& parent, const Invocation& invocation) {
  Command& command = parent.add("resume", "go on with the study of a file of results");
  const auto options = std::make_shared<ResumeOptions>();
  command.take("results", options->file, "RESULTS.db", "file that a tournament, an experiment or a tuning wrote",
               Writes::results);
  command.take("--pairs", options->pairs, "N",
               "of a tournament or an experiment: play so many pairs of matches in all, of each pairing or arm");
  add_playing_options(command, *options);
  command.notes(resume_examples, "0 played, whatever was found; 1 the results could not be written",
                command::resumable);
  command.run = [options, &command, &invocation] { return play(*options, command.outputs("study"), invocation); };
}

void add_gather(Command& parent, const Invocation& invocation) {
  Command& command = parent.add("gather", "take over what the tasks of a study on a cluster have played");
  const auto options = std::make_shared<FolderOptions>();
  command.take("folder", options->folder, "FOLDER", "the study's folder", Writes::results);
  command.flag("--no-page", options->campaign.no_page, "of a complete study: write no page beside the results");
  command.flag("--json", options->campaign.json, "write the report of a complete study as JSON");
  command.flag("--quiet", options->campaign.quiet, "say nothing on standard error but errors");
  command.notes(gather_examples, "0 done; 1 the results could not be written");
  command.run = [options, &invocation] { return gather(*options, invocation); };
}

void add_status(Command& parent, const Invocation& /*invocation*/) {
  Command& command = parent.add("status", "how far a study on a cluster has come");
  const auto options = std::make_shared<FolderOptions>();
  command.take("folder", options->folder, "FOLDER", "the study's folder", Reads::results);
  command.flag("--json", options->campaign.json, "write the status as JSON");
  command.notes(status_examples, "0 done; 1 the status could not be written");
  command.run = [options] { return tell_status(*options); };
}

void add_stop(Command& parent, const Invocation& /*invocation*/) {
  Command& command = parent.add("stop", "end the jobs of a study on a cluster");
  const auto options = std::make_shared<FolderOptions>();
  command.take("folder", options->folder, "FOLDER", "the study's folder", Writes::results);
  command.notes(stop_examples, "0 done; 1 its state could not be written");
  command.run = [options] { return stop(*options); };
}

// Adds the hidden command that one task of a cluster's job array runs.
void add_cluster_task(Command& parent, const Invocation& invocation) {
  Command& command = parent.add("cluster-task", "a slice of a study on a cluster");
  command.hidden = true;
  const auto words = std::make_shared<std::vector<std::string>>();
  command.take("words", *words, "FOLDER BATCH TASK", "the study's folder, the batch, and the place in its array");
  command.run = [words, &invocation] {
    if (words->size() != 3) throw BadInput("cluster-task: is for the program itself, which starts it for an array");
    constexpr std::uint64_t most = 1'000'000'000;
    cluster::play_task(
        (*words)[0],
        {config::parse_whole("batch", (*words)[1], 1, most), config::parse_whole("task", (*words)[2], 0, most)},
        invocation);
    return exit_done;
  };
}

}  // namespace regista::cli
