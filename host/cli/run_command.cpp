// SPDX-License-Identifier: MIT
// `regista run`: plays the study of a document, whatever it is.
#include <fmt/format.h>

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "cli/commands.hpp"
#include "cli/study_commands.hpp"
#include "cluster/run.hpp"
#include "config/documents.hpp"
#include "texts/message.hpp"

namespace regista::cli {
namespace {

constexpr auto run_examples = R"(Examples:
  regista run configs/studies/rivals.yaml
  regista run configs/studies/role_overlap.yaml --results night.db
  regista run configs/studies/tune_paper.yaml --set search.algorithm=spsa
  regista run configs/studies/rivals.yaml --on slurm --array 64 --per-task 200

The document is a tournament, an experiment or a tuning, and is played as `regista tournament`, `experiment` or `tune`
would play it; these have options of their own besides. What was begun is gone on with by: regista resume RESULTS.db

Exit codes: 0 played, whatever was found; 1 the results could not be written; 2 bad input; 3 a defect of
Regista; 130 interrupted.)";

struct RunOptions : StudyOptions {
  cluster::Options on_cluster;
};

int play_here(const RunOptions& options, const output::OutputFiles& outputs, const Invocation& invocation) {
  if (options.file.empty()) throw BadInput("run: which study? Name its document; see: regista run --help");
  const config::Node document = config::load(options.file);
  for (const results::StudyKind& each : invocation.studies) {
    if (document[each.document.name]) return play(each, options, outputs, invocation);
  }
  const config::DocumentKind kind = config::kind_of(document);
  if (kind == config::DocumentKind::predictor_study) {
    throw BadInput(fmt::format(
        "run: {0} is a predictor study, which needs recordings: regista evaluate-predictor {0} --data RECORDING",
        texts::one_line(options.file)));
  }
  std::vector<std::string> names;
  for (const results::StudyKind& each : invocation.studies) names.emplace_back(each.document.name);
  throw BadInput(fmt::format("run: {} is no study but of the kind {}; studies are {}", texts::one_line(options.file),
                             kind.name, texts::join(names)));
}

int play(const RunOptions& options, const output::OutputFiles& outputs, const Invocation& invocation) {
  const cluster::Options& cluster = options.on_cluster;
  if (!cluster.on.empty()) {
    campaign::check(options);
    const auto begin = [&](const campaign::Options& campaign) {
      RunOptions own = options;
      static_cast<campaign::Options&>(own) = campaign;
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

}  // namespace

void add_run(Command& parent, const Invocation& invocation) {
  Command& command = parent.add("run", "play the study of a document");
  const auto options = std::make_shared<RunOptions>();
  command.take("file", options->file, "STUDY.yaml", "a tournament, an experiment or a tuning", Reads::documents);
  options->values.declare_common(command, config::DocumentKind::tournament);
  command.take("--set", options->set, "PATH=VALUE",
               "a value laid over that document, or over those of its matches; may be repeated");
  add_campaign_options(command, *options, "the study's name with .db");
  add_cluster_options(command, options->on_cluster);
  command.notes(run_examples);
  command.run = [options, &command, &invocation] {
    return play(*options, output::OutputFiles(command.given(), "study"), invocation);
  };
}

}  // namespace regista::cli
