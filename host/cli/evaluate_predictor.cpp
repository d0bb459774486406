// SPDX-License-Identifier: MIT
// `regista evaluate-predictor STUDY.yaml --data FILE`: how well a predictor foretells a recording.
#include <fmt/format.h>
#include <memory>

#include "cli/commands.hpp"
#include "cli/plugin_folders.hpp"
#include "command/interruption.hpp"
#include "command/terminal.hpp"
#include "config/documents.hpp"
#include "config/file.hpp"
#include "output/output.hpp"
#include "plugin/content_hash.hpp"
#include "process/program.hpp"
#include "report/evaluation_report.hpp"

namespace regista::cli {
namespace {

constexpr auto evaluate_predictor_examples = R"(Examples:
  regista evaluate-predictor configs/studies/ssl_ball.yaml --data zjunlict_ball_raw.csv.gz
  regista evaluate-predictor configs/studies/ssl_ball.yaml --data zjunlict_ball_raw.csv.gz \
      --set predictor.params.deceleration=0.4 --set 'observations={every: 0.1, drop: 0.3, seed: 1}' \
      --set baselines.window=0.5 --json

The formats of recordings: regista config schema predictor_study

Exit codes: 0 done; 1 the result could not be written; 2 bad input; 3 a defect of Regista; 130
interrupted.)";

struct EvaluatePredictorOptions {
  std::vector<std::string> studies, plugins, overrides;
  std::string data, referee;
  bool json = false, quiet = false;
};

int evaluate(const EvaluatePredictorOptions& options, const Invocation& invocation) {
  if (options.studies.size() != 1) {
    throw BadInput(
        fmt::format("evaluate-predictor: expected one file of a study, {} given; see: regista "
                    "evaluate-predictor --help",
                    options.studies.size()));
  }
  if (options.data.empty()) throw BadInput("evaluate-predictor: which recording? Say --data FILE");
  const config::PredictorStudy study = config::read_document<config::PredictorStudy>(
      options.studies.front(), config::typed_overrides(options.overrides));
  const plugin::Catalogue catalogue = open_plugins(options.plugins, invocation);
  const std::string again = process::shell_line(invocation.arguments);
  const command::Interruption interruption(
      fmt::format("regista: interrupted while a plugin did not return; the same study again: {}\n", again));
  command::RewrittenLine progress(!options.quiet);
  const auto stop_if_asked = [&](const std::string& stage) {
    if (!interruption.requested()) return;
    progress.clear();
    throw Interrupted(fmt::format("interrupted while {}; the same study again: {}", stage, again),
                      interruption.signal_number());
  };
  const study::GameRecording recording =
      study::read_recording(study, options.data, options.referee, [&](std::size_t lines) {
        const std::string stage = fmt::format("reading {}, line {}", options.data, lines);
        if (progress.due()) progress.show(stage);
        stop_if_asked(stage);
      });
  const study::Evaluation evaluation =
      study::evaluate(study, recording, &catalogue, [&](std::size_t done, std::size_t of) {
        const std::string stage = fmt::format("evaluating stretch {} of {}", done, of);
        if (progress.due()) progress.show(stage);
        stop_if_asked(stage);
      });
  progress.clear();
  report::Evaluated evaluated{options.studies.front(), options.data, {}, {}, REGISTA_VERSION};
  for (const std::string& each : catalogue.used_files()) {
    evaluated.predictor = each;
    evaluated.hash = plugin::content_hash(config::file_content(each).value_or(""));
  }
  output::print(options.json ? report::evaluation_json(study, evaluated, evaluation)
                             : report::evaluation_text(study, evaluated, evaluation));
  return exit_done;
}

}  // namespace

void add_evaluate_predictor(Command& parent, const Invocation& invocation) {
  Command& command = parent.add("evaluate-predictor", "measure a predictor on a recording, beside simple baselines");
  const auto options = std::make_shared<EvaluatePredictorOptions>();
  command.take("study", options->studies, "STUDY.yaml", "the study's file", Reads::documents);
  command.take("--data", options->data, "FILE", "the recording: CSV, plain or .gz", Reads::data);
  command.take("--referee", options->referee, "FILE",
               "states of the referee (Small Size League); default: NAME_referee.csv.gz beside NAME_ball_raw.csv.gz",
               Reads::data);
  command.take("--set", options->overrides, "PATH=VALUE", "a value laid over the study; may be repeated");
  add_plugin_folders(command, options->plugins);
  command.flag("--json", options->json, "write the result as JSON");
  command.flag("--quiet", options->quiet, "no progress on the terminal");
  command.notes(evaluate_predictor_examples);
  command.run = [options, &invocation] { return evaluate(*options, invocation); };
}

}  // namespace regista::cli
