// SPDX-License-Identifier: MIT
// `regista gather`, `status` and `stop`: a study on a cluster, by its folder.
#include <fmt/format.h>

#include <memory>
#include <string>

#include "cli/commands.hpp"
#include "cluster/run.hpp"
#include "cluster/step.hpp"
#include "cluster/study_folder.hpp"
#include "cluster/task.hpp"
#include "config/typed.hpp"
#include "output/output.hpp"
#include "texts/json.hpp"
#include "texts/message.hpp"

namespace regista::cli {
namespace {

using cluster::Progress;
using cluster::StudyFolder;

constexpr auto gather_examples = R"(Examples:
  regista gather rivals.cluster
  regista gather rivals.cluster --json

Takes what the tasks have played over into FOLDER/results.db, and submits the next matches where some are missing and no
task plays. The job after each array does the same. A study that is complete is reported. Matches that do not fit are
named, and their part is kept in FOLDER/set_aside.

Exit codes: 0 done; 1 the results could not be written; 2 bad input; 3 a defect of Regista.)";

constexpr auto status_examples = R"(Examples:
  regista status rivals.cluster
  regista status rivals.cluster --json

By the files alone: matches that were gathered and that tasks have played since, and what was found in those that were
gathered. Nothing is changed, and Slurm is not asked.

Exit codes: 0 done; 1 the status could not be written; 2 bad input; 3 a defect of Regista.)";

constexpr auto stop_examples = R"(Examples:
  regista stop rivals.cluster

Ends the jobs of the study. What was played is kept, and regista resume FOLDER goes on.

Exit codes: 0 done; 1 its state could not be written; 2 bad input; 3 a defect of Regista.)";

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
                                      {"matches", progress.matches},
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
    output::print(json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + '\n');
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

void add_gather(Command& parent, const Invocation& invocation) {
  Command& command = parent.add("gather", "take over what the tasks of a study on a cluster have played");
  const auto options = std::make_shared<FolderOptions>();
  command.take("folder", options->folder, "FOLDER", "the study's folder", Writes::results);
  command.flag("--no-page", options->campaign.no_page, "of a complete study: write no page beside the results");
  command.flag("--json", options->campaign.json, "write the report of a complete study as JSON");
  command.flag("--quiet", options->campaign.quiet, "say nothing on standard error but errors");
  command.notes(gather_examples);
  command.run = [options, &invocation] { return gather(*options, invocation); };
}

void add_status(Command& parent) {
  Command& command = parent.add("status", "how far a study on a cluster has come");
  const auto options = std::make_shared<FolderOptions>();
  command.take("folder", options->folder, "FOLDER", "the study's folder", Reads::results);
  command.flag("--json", options->campaign.json, "write the status as JSON");
  command.notes(status_examples);
  command.run = [options] { return tell_status(*options); };
}

void add_stop(Command& parent) {
  Command& command = parent.add("stop", "end the jobs of a study on a cluster");
  const auto options = std::make_shared<FolderOptions>();
  command.take("folder", options->folder, "FOLDER", "the study's folder", Writes::results);
  command.notes(stop_examples);
  command.run = [options] { return stop(*options); };
}

// Hidden: what a task of an array does.
void add_cluster_task(Command& parent, const Invocation& invocation) {
  Command& command = parent.add("cluster-task", "a slice of a study on a cluster");
  command.hide();
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
