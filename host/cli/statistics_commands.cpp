// SPDX-License-Identifier: MIT
// The commands `regista sprt`, `rank`, `metrics` and `evaluate-predictor`. They play no match.
#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <stdexcept>

#include "cli/common_options.hpp"
#include "config/document_files.hpp"
#include "config/errors.hpp"
#include "config/overlay.hpp"
#include "config/scalar.hpp"
#include "match/metric_table.hpp"
#include "output/replaced_file.hpp"
#include "plugin/shared_object.hpp"
#include "process/child.hpp"
#include "report/evaluation_report.hpp"
#include "report/given_results.hpp"
#include "report/metric_reference.hpp"
#include "statistics/sequential_test.hpp"
#include "study/table.hpp"
#include "texts/message.hpp"

namespace regista::cli {
namespace {

// --- `regista sprt --elo ELO0,ELO1 COUNTS`: a sequential test of counts of games or pairs.

constexpr auto sprt_notes =
    R"(COUNTS are of the first team: five of pairs (the same seed, sides swapped), LL LD WL+DD WD WW, or three of
single games, L D W.

Results: llr, the log-likelihood ratio of H1 (stronger by ELO1) to H0 (by ELO0), in nats, and its bounds; elo and nelo,
strength and normalised strength with intervals of 95 %; los, the probability that the first team is the stronger one
(a percentage in the text, from 0 to 1 in JSON). In JSON, null is a bound or ratio that the counts do not give.
The counts alone do not tell the way they came, so the bounds are without the overshoot correction that a tournament
applies. After a sequential test has stopped, elo and nelo are biased towards the verdict.

Examples:
  regista sprt --elo 0,10 34 54 63 64 75
  regista sprt --model logistic --elo=-5,0 --alpha 0.01 --beta 0.1 96 111 136 --json)";

struct SprtOptions {
  std::string model = "normalized", elo, alpha = "0.05", beta = "0.05";
  std::vector<std::string> counts;
  bool json = false;
};

std::vector<statistics::Count> parse_counts(const std::vector<std::string>& words) {
  std::vector<statistics::Count> counts;
  statistics::Count sum = 0;
  for (const std::string& word : words) {
    const auto count = config::number_in<statistics::Count>(word);
    if (!count || *count < 0 || *count > statistics::most_counted) {
      throw BadInput(fmt::format("sprt: count {}; expected a whole number from 0 to {}", texts::in_quotes(word),
                                 statistics::most_counted));
    }
    counts.push_back(*count);
    sum += *count;
  }
  if (counts.size() != 3 && counts.size() != 5) {
    throw BadInput(fmt::format("sprt: {} counts; expected five of pairs (LL LD DD WD WW) or three of games (L D W)",
                               counts.size()));
  }
  if (sum == 0) throw BadInput("sprt: all counts are zero");
  return counts;
}

constexpr double most_elo = 4000.0;

statistics::Model parse_model(const std::string& text) {
  if (text == "normalized") return statistics::Model::normalized;
  if (text == "logistic") return statistics::Model::logistic;
  throw BadInput(texts::unknown("model", text, "--model", std::vector<std::string>{"normalized", "logistic"}));
}

statistics::Hypotheses parse_hypotheses(const std::string& option, const std::string& text) {
  const std::size_t comma = text.find(',');
  const auto elo0 = config::typed_number(std::string_view(text).substr(0, comma));
  const auto elo1 =
      comma == std::string::npos ? std::nullopt : config::typed_number(std::string_view(text).substr(comma + 1));
  if (!elo0 || !elo1 || std::abs(*elo0) > most_elo || std::abs(*elo1) > most_elo) {
    throw BadInput(fmt::format("{}: {}; expected two numbers from {} to {}, as in 0,10", option, texts::in_quotes(text),
                               -most_elo, most_elo));
  }
  if (!(*elo0 < *elo1)) {
    throw BadInput(fmt::format("{}: {}; the first must be the smaller one", option, texts::in_quotes(text)));
  }
  return {*elo0, *elo1};
}

statistics::ErrorRates parse_rates(const std::string& alpha, const std::string& beta) {
  const statistics::ErrorRates rates{config::parse_rate("--alpha", alpha), config::parse_rate("--beta", beta)};
  if (!(rates.alpha + rates.beta < 1.0)) {
    throw BadInput(fmt::format("--alpha {} and --beta {}: their sum must be below 1", alpha, beta));
  }
  return rates;
}

report::SequentialTestOfCounts evaluate(const SprtOptions& options) {
  statistics::SequentialDesign design;
  design.model = parse_model(options.model);
  if (options.elo.empty()) throw BadInput("sprt: which hypotheses? Say --elo ELO0,ELO1, for example --elo 0,10");
  design.hypotheses = parse_hypotheses("--elo", options.elo);
  design.rates = parse_rates(options.alpha, options.beta);
  return report::test_counts(parse_counts(options.counts), design);
}

// --- `regista rank RESULTS.csv`: a ranking of teams from external results.

constexpr auto rank_notes =
    R"(RESULTS: values separated by commas; the first line names the columns, in any order. Two columns, first and
second, name the teams. The results are, from the point of view of the first, one of
  LL,LD,DD,WD,WW     counts of pairs: both games lost, ..., both won; DD counts one win each, too
  wins,draws,losses  counts of games without pairs
  score              one game a line: 1, 0.5 or 0 points; two lines with the same text in a column "pair" are a pair
Lines of the same teams add up. A game a line is also home,away,home_goals,away_goals, as in the matches of a tournament
(`regista report --csv`), and a game of chess in PGN: its headers White, Black and Result.

Results: Elo by Bradley and Terry, sum 0 in each group of teams that met, with intervals of 95 % by the spread of pairs,
or of games where there are no pairs. In JSON, null is what the results do not determine.

Examples:
  regista rank results.csv
  regista rank results.csv --json)";

// --- `regista metrics`: the numbers that matches have.

constexpr auto metrics_examples = R"(Examples:
  regista metrics
  regista metrics --json
  regista metrics --page docs/metrics.md > new.md
Each number can be named as a metric of a tournament or a measure of a study, but for lists and numbers of the match as a
whole; with the name of a role in the place of <role>, and without "<role>." as the sum over all roles.)";

struct MetricsOptions {
  bool json = false;
  std::string page;
};

std::string written(const MetricsOptions& options) {
  if (options.json && !options.page.empty()) throw BadInput("metrics: --json and --page: one of them");
  if (options.json) return report::metrics_json(match::metric_table());
  if (options.page.empty()) return report::metrics_text(match::metric_table());
  const std::string page = config::read_file(options.page);
  try {
    return report::with_metric_tables(page, match::metric_table());
  } catch (const std::invalid_argument& error) {
    throw BadInput(options.page + ": " + error.what());
  }
}

// --- `regista evaluate-predictor STUDY.yaml --data FILE`: how well a predictor predicts a recording.

constexpr auto evaluate_predictor_examples = R"(Examples:
  regista evaluate-predictor configs/studies/ssl_ball.yaml --data zjunlict_ball_raw.csv.gz
  regista evaluate-predictor configs/studies/ssl_ball.yaml --data zjunlict_ball_raw.csv.gz \
      --set predictor.params.deceleration=0.4 --set 'observations={every: 0.1, drop: 0.3, seed: 1}' \
      --set baselines.window=0.5 --json

The formats of recordings: regista config schema predictor_study)";

struct EvaluatePredictorOptions : PlainOptions {
  std::string data, referee;
  bool quiet = false;
};

int evaluate(const EvaluatePredictorOptions& options, const Invocation& invocation) {
  const std::string& file = the_only(options.words, "evaluate-predictor: expected one file of a study",
                                     "; see: regista evaluate-predictor --help");
  if (options.data.empty()) throw BadInput("evaluate-predictor: which recording? Say --data FILE");
  const config::PredictorStudy study =
      config::read_document<config::PredictorStudy>(file, config::typed_overrides(options.set));
  const plugin::Catalogue catalogue = open_plugins(options.plugins, invocation);
  const std::string again = process::shell_line(invocation.arguments);
  const command::Interruption interruption(
      fmt::format("regista: interrupted while a plugin did not return; the same study again: {}\n", again));
  command::RewrittenLine progress(!options.quiet);
  const auto tell_or_stop = [&](const std::string& stage) {
    if (progress.due()) progress.show(stage);
    if (!interruption.requested()) return;
    progress.clear();
    throw Interrupted(fmt::format("interrupted while {}; the same study again: {}", stage, again),
                      interruption.signal_number());
  };
  const study::GameRecording recording = study::read_recording(
      study, options.data, options.referee,
      [&](std::size_t lines) { tell_or_stop(fmt::format("reading {}, line {}", options.data, lines)); });
  const study::Evaluation evaluation = study::evaluate(
      study, recording, &catalogue,
      [&](std::size_t done, std::size_t of) { tell_or_stop(fmt::format("evaluating stretch {} of {}", done, of)); });
  progress.clear();
  report::Evaluated evaluated{file, options.data, {}, {}, REGISTA_VERSION};
  for (const std::string& each : catalogue.used_files()) {
    evaluated.predictor = each;
    evaluated.hash = plugin::content_hash(config::file_content(each).value_or(""));
  }
  output::print(options.json ? report::evaluation_json(study, evaluated, evaluation)
                             : report::evaluation_text(study, evaluated, evaluation));
  return exit_done;
}

}  // namespace

void add_sprt(Command& parent, const Invocation& /*invocation*/) {
  Command& command = parent.add("sprt", "what counts of games or pairs say: LLR, Elo, nElo, LOS");
  const auto options = std::make_shared<SprtOptions>();
  command.take("counts", options->counts, "COUNTS", "five counts of pairs or three of games");
  command.choose("--model", options->model, {"normalized", "logistic"},
                 "what the hypotheses are in; default normalized");
  command.take("--elo", options->elo, "ELO0,ELO1", "strengths of H0 and H1, of the first team against the other");
  command.take("--alpha", options->alpha, "RATE", "rate of accepting H1 in error; default 0.05");
  command.take("--beta", options->beta, "RATE", "rate of accepting H0 in error; default 0.05");
  command.flag("--json", options->json, "write the result as JSON");
  command.notes(sprt_notes, "0 done, whatever the verdict; 1 the result could not be written");
  command.run = [options] {
    const report::SequentialTestOfCounts test = evaluate(*options);
    output::print(options->json ? report::counts_json(test) : report::counts_text(test));
    return exit_done;
  };
}

void add_rank(Command& parent, const Invocation& /*invocation*/) {
  Command& command = parent.add("rank", "rank teams by results from elsewhere");
  const auto options = std::make_shared<PlainOptions>();
  command.take("results", options->words, "RESULTS", "the results", Reads::data);
  command.flag("--json", options->json, "write the result as JSON");
  command.notes(rank_notes, "0 done; 1 the result could not be written");
  command.run = [options] {
    const std::string& file =
        the_only(options->words, "rank: expected one file of results", "; see: regista rank --help");
    const report::RankedResults ranking = report::ranked(study::read_results_of_teams(file));
    output::print(options->json ? report::ranking_json(ranking) : report::ranking_text(ranking));
    return exit_done;
  };
}

void add_metrics(Command& parent, const Invocation& /*invocation*/) {
  Command& command = parent.add("metrics", "list the numbers that every match has");
  const auto options = std::make_shared<MetricsOptions>();
  command.flag("--json", options->json, "write JSON");
  command.take("--page", options->page, "FILE",
               "write this page of Markdown, with its tables of metrics as they are now", Reads::data);
  command.notes(metrics_examples, "0 done; 1 the output could not be written");
  command.run = [options] {
    output::print(written(*options));
    return exit_done;
  };
}

void add_evaluate_predictor(Command& parent, const Invocation& invocation) {
  Command& command = parent.add("evaluate-predictor", "measure a predictor on a recording, beside simple baselines");
  const auto options = std::make_shared<EvaluatePredictorOptions>();
  command.take("study", options->words, "STUDY.yaml", "the study's file", Reads::documents);
  command.take("--data", options->data, "FILE", "the recording: CSV, plain or .gz", Reads::data);
  command.take("--referee", options->referee, "FILE",
               "states of the referee (Small Size League); default: NAME_referee.csv.gz beside NAME_ball_raw.csv.gz",
               Reads::data);
  command.take("--set", options->set, "PATH=VALUE", "a value laid over the study; may be repeated");
  add_plugin_folders(command, options->plugins);
  command.flag("--json", options->json, "write the result as JSON");
  command.flag("--quiet", options->quiet, "no progress on the terminal");
  command.notes(evaluate_predictor_examples, "0 done; 1 the result could not be written", command::interruptible);
  command.run = [options, &invocation] { return evaluate(*options, invocation); };
}

}  // namespace regista::cli
