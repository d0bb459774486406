// SPDX-License-Identifier: MIT
// `regista metrics`: which numbers matches have.
#include <memory>
#include <stdexcept>

#include "cli/commands.hpp"
#include "config/bad_input.hpp"
#include "config/file.hpp"
#include "match/metric_table.hpp"
#include "output/output.hpp"
#include "report/metric_reference.hpp"

namespace regista::cli {
namespace {

constexpr auto metrics_examples = R"(Examples:
  regista metrics
  regista metrics --json
  regista metrics --page docs/metrics.md > new.md
Each number can be named as a metric of a tournament or a measure of a study, but for lists and numbers of the match as a
whole; with the name of a role in the place of <role>, and without "<role>." as the sum over all roles.

Exit codes: 0 done; 1 the output could not be written; 2 bad input; 3 a defect of Regista.)";

struct MetricsOptions {
  bool json = false;
  std::string page;
};

std::string written(const MetricsOptions& options) {
  if (options.json && !options.page.empty()) throw config::BadInput("metrics: --json and --page: one of them");
  if (options.json) return report::metrics_json(match::metric_table());
  if (options.page.empty()) return report::metrics_text(match::metric_table());
  const std::string page = config::read_file(options.page);
  try {
    return report::with_metric_tables(page, match::metric_table());
  } catch (const std::invalid_argument& error) {
    throw config::BadInput(options.page + ": " + error.what());
  }
}

}  // namespace

void add_metrics(Command& parent) {
  Command& command = parent.add("metrics", "list the numbers that every match has");
  const auto options = std::make_shared<MetricsOptions>();
  command.flag("--json", options->json, "write JSON");
  command.take("--page", options->page, "FILE",
               "write this page of Markdown, with its tables of metrics as they are now", Reads::data);
  command.notes(metrics_examples);
  command.run = [options] {
    output::print(written(*options));
    return exit_done;
  };
}

}  // namespace regista::cli
