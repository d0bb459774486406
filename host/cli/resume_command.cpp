// SPDX-License-Identifier: MIT
// `regista resume`: goes on with the study of a file of results, which holds all that it was begun with.
#include <fmt/format.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "campaign/inputs.hpp"
#include "campaign/job_setup.hpp"
#include "campaign/mathematics.hpp"
#include "cli/commands.hpp"
#include "cli/plugin_folders.hpp"
#include "cluster/run.hpp"
#include "config/typed.hpp"
#include "output/output_files.hpp"
#include "results/results_file.hpp"
#include "results/study_run.hpp"
#include "study/tournament_plan.hpp"
#include "texts/message.hpp"

namespace regista::cli {
namespace {

constexpr auto resume_examples = R"(Examples:
  regista resume tournament.db
  regista resume night.db --workers 1
  regista resume rivals.db --pairs 200

Plays what is missing, as it was planned: the file holds teams, profiles, seeds, test and limits, and knows what stood in
the documents and plugins. Where one of them or the program has changed since, nothing is played and the change is named.
--pairs gives a tournament more pairs of matches: one that has ended, too, but none whose test was fixed for a number of
them. A tuning writes its team to NAME.tuned.yaml beside the results.

Exit codes: 0 played, whatever was found; 1 the results could not be written; 2 bad input; 3 a defect of
Regista; 130 interrupted.)";

struct ResumeOptions : campaign::Options {
  std::string file, pairs;
};

// Before anything is played or written: the files hold what they held, and this is the program that began it.
void require_unchanged(const std::string& results, std::span<const campaign::Job> jobs,
                       const plugin::Catalogue& catalogue) {
  const std::string program = campaign::program_hash(), mathematics = campaign::mathematics_fingerprint();
  for (const campaign::Job& job : jobs) {
    const campaign::MatchSetup now = campaign::match_setup(campaign::request_of(job), catalogue);
    const std::string changed = campaign::what_changed(job, now, catalogue, program, mathematics);
    if (changed.empty()) continue;
    throw BadInput(fmt::format("resume: {} was begun with something else: {}; its matches would be mixed with others",
                               results, changed));
  }
}

// Messages name files as the study was begun with them: goes there.
void enter_folder(const std::string& results, const std::string& folder) {
  std::error_code error;
  std::filesystem::current_path(folder, error);
  if (error) {
    throw BadInput(fmt::format("resume: {}: the folder it was begun in, {}, cannot be entered: {}", results, folder,
                               error.message()));
  }
}

// The folder of a study on a cluster.
int go_on_with_folder(const ResumeOptions& options, const Invocation& invocation) {
  const cluster::StudyFolder folder(options.file);
  folder.settings();  // else the folder is none of a study
  for (const auto& [name, value] :
       {std::pair{"--workers", &options.workers}, {"--record-every", &options.record_every}}) {
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
    enter_folder(file, report->study().folder());
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
  using enum output::OutputFiles::Page;
  outputs.write_beside(options.results, options.no_page ? none : figures ? with_figures : alone);
  outputs.check(false);
  if (pairs) results::give_pairs(options.results, *pairs, invocation.studies);

  const std::string plan = results::stored_plan(results::read_results(options.results));
  const results::StudyKind& kind = results::kind_of(file, plan, invocation.studies);
  if (kind.play) return kind.play(plan, options, outputs, invocation);
  const auto report = results::stored_study(file, results::read_results(options.results),
                                            results::play_again(invocation), invocation.studies);
  campaign::Store store = results::open_results(options.results, true, report->study(), {}, invocation.studies);
  results::StudyWishes wishes;
  wishes.figures = figures;
  return results::play_study(*report, options, invocation, store, wishes);
}

}  // namespace

void add_resume(Command& parent, const Invocation& invocation) {
  Command& command = parent.add("resume", "go on with the study of a file of results");
  const auto options = std::make_shared<ResumeOptions>();
  command.take("results", options->file, "RESULTS.db", "file that a tournament, an experiment or a tuning wrote",
               Writes::results);
  command.take("--pairs", options->pairs, "N",
               "of a tournament: play so many pairs of matches in all, of each pairing");
  command.take("--workers", options->workers, "N", "matches at the same time; default: one for each processor core");
  command.take("--record-every", options->record_every, "N",
               "record every N-th match, beside the results in NAME.recordings/ROW.mcap; those that fail always are");
  command.flag("--no-page", options->no_page, "write no page NAME.html beside the results NAME.db at the end");
  command.flag("--json", options->json, "write the report as JSON");
  command.flag("--quiet", options->quiet, "no progress on standard error");
  command.notes(resume_examples);
  command.run = [options, &command, &invocation] {
    return play(*options, output::OutputFiles(command.given(), "study"), invocation);
  };
}

}  // namespace regista::cli
