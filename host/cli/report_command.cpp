// SPDX-License-Identifier: MIT
// `regista report`: what the stored results of a tournament say, without playing any; while it is still played, too.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <stdexcept>

#include "cli/command.hpp"
#include "cli/end_of_program.hpp"
#include "cli/output.hpp"
#include "cli/shell.hpp"
#include "cli/tournament_files.hpp"
#include "config/text.hpp"
#include "report/tournament.hpp"
#include "study/metric.hpp"

namespace regista::cli {
namespace {

constexpr auto examples = R"(Examples:
  regista report tournament.db
  regista report tournament.db --json
  regista report tournament.db --csv > matches.csv
  regista report tournament.db --csv --metrics > everything.csv

What is told is what `regista tournament` told at its end; of a tournament that is not at its end, as far as its matches
have been played without a gap.
Exit codes: 0 done; 1 the report could not be written; 2 bad input; 3 a defect of Regista.)";

struct Options {
  std::string file;
  bool json = false, csv = false, metrics = false;
};

// In pieces, so that a million rows need no memory.
constexpr std::size_t piece = std::size_t{1} << 20;

// Adds what a match has and is not there yet: teams differ in the names of their roles.
void add_columns(std::vector<std::string>& columns, const campaign::Decided& decided) {
  for (const int side : {0, 1}) {
    for (const study::NamedValue& each : study::metric_values(decided.metrics, side)) {
      if (std::ranges::find(columns, each.path) == columns.end()) columns.push_back(each.path);
    }
  }
}

int run(const Options& options, const Invocation& invocation) {
  if (options.file.empty()) throw BadInput("report: which results? Name a file that `regista tournament` wrote");
  if (options.csv && options.json) throw BadInput("report: --csv and --json: one of them");
  if (options.metrics && !options.csv) throw BadInput("report: --metrics adds columns to --csv, which is not given");
  const StoredTournament results = read_results(options.file);
  const campaign::Store& store = results.store;
  const study::TournamentPlan& plan = results.plan;
  study::Tournament course(plan);
  const report::TournamentView view{plan, course, [&plan, &course, &invocation](std::uint64_t index) {
                                      auto words =
                                          campaign::match_arguments(study::job(plan, course.calendar().at(index)));
                                      words.insert(words.begin(), invocation.arguments.front());
                                      return shell_line(words);
                                    }};
  try {
    std::vector<std::string> keys;
    for (campaign::Store::Fixture& each : study::fixtures(plan)) keys.push_back(std::move(each.key));
    const std::vector<std::int64_t> numbers = store.numbers(keys);
    const bool needed = course.needs_metrics() || options.metrics;
    const auto metrics = needed ? campaign::Metrics::wanted : campaign::Metrics::left_out;
    const auto stored = [&](std::uint64_t index) {
      const study::Fixture fixture = course.calendar().at(index);
      return store.find(static_cast<std::int64_t>(index) + 1, {numbers[fixture.number], fixture.seed}, metrics);
    };
    std::vector<std::string> columns;
    const std::uint64_t matches = course.calendar().matches();
    if (options.metrics) {
      // Until every team was seen in a match that was played to its end.
      std::vector<bool> seen(plan.teams.size(), false);
      for (std::uint64_t index = 0; index < matches && std::ranges::count(seen, false) > 0; ++index) {
        const study::Fixture fixture = course.calendar().at(index);
        if (seen[fixture.home] && seen[fixture.away]) continue;
        const auto decided = stored(index);
        if (!decided) break;
        if (decided->metrics.empty()) continue;
        add_columns(columns, *decided);
        seen[fixture.home] = seen[fixture.away] = true;
      }
    }
    std::string csv = options.csv ? report::csv_head(columns) : std::string();
    bool more = true;
    for (std::uint64_t index = 0; more && index < matches; ++index) {
      if (!course.wanted(index)) {
        more = course.take(nullptr);
        continue;
      }
      const std::optional<campaign::Decided> decided = stored(index);
      if (!decided) break;
      if (options.csv) csv += report::csv_line(view, index, *decided, columns);
      if (csv.size() > piece) {
        print(csv);
        csv.clear();
      }
      more = course.take(&*decided);
    }
    if (more && course.taken() < matches) {
      complain(fmt::format("{} holds {} of {} matches without a gap: the tournament is not at its end", options.file,
                           course.matches(), matches));
    }
    if (options.csv)
      print(csv);
    else
      print(options.json ? report::tournament_json(view) : report::tournament_text(view));
  } catch (const campaign::StoreError& error) {
    throw BadInput(error.what());
  } catch (const std::invalid_argument& error) {
    throw BadInput(damaged_metrics(options.file, error));
  }
  return exit_done;
}

}  // namespace

Command add_report(CLI::App& parent, const Invocation& invocation) {
  CLI::App& app = *parent.add_subcommand("report", "what stored results say");
  const auto options = std::make_shared<Options>();
  app.add_option("results", options->file, "file that a tournament wrote")->type_name("RESULTS.db");
  app.add_flag("--json", options->json, "write the report as JSON")->disable_flag_override();
  app.add_flag("--csv", options->csv, "write a table with a row for each match")->disable_flag_override();
  app.add_flag("--metrics", options->metrics, "with --csv: all numbers of the matches, too")->disable_flag_override();
  app.footer(examples);
  return {&app, [options, &invocation] { return run(*options, invocation); }};
}

}  // namespace regista::cli
