// SPDX-License-Identifier: MIT
// `regista sprt --elo ELO0,ELO1 COUNTS`: what counts of games or pairs say, without playing any.
#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "cli/commands.hpp"
#include "config/typed.hpp"
#include "output/output.hpp"
#include "report/counts.hpp"
#include "statistics/sequential_test.hpp"
#include "texts/message.hpp"

namespace regista::cli {
namespace {

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
  regista sprt --model logistic --elo=-5,0 --alpha 0.01 --beta 0.1 96 111 136 --json

Exit codes: 0 done, whatever the verdict; 1 the result could not be written; 2 bad input; 3 a defect of Regista.)";

struct SprtOptions {
  std::string model = "normalized", elo, alpha = "0.05", beta = "0.05";
  std::vector<std::string> counts;
  bool json = false;
};

std::vector<statistics::Count> parse_counts(const std::vector<std::string>& words) {
  std::vector<statistics::Count> counts;
  statistics::Count sum = 0;
  for (const std::string& word : words) {
    statistics::Count count = 0;
    const auto [rest, error] = std::from_chars(word.data(), word.data() + word.size(), count);
    if (error != std::errc() || rest != word.data() + word.size() || count < 0 || count > statistics::most_counted) {
      throw BadInput(fmt::format("sprt: count {}; expected a whole number from 0 to {}", texts::in_quotes(word),
                                 statistics::most_counted));
    }
    counts.push_back(count);
    sum += count;
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
  return report::test_counts(parse_counts(options.counts), options.model, design);
}

}  // namespace

void add_sprt(Command& parent) {
  Command& command = parent.add("sprt", "what counts of games or pairs say: LLR, Elo, nElo, LOS");
  const auto options = std::make_shared<SprtOptions>();
  command.take("counts", options->counts, "COUNTS", "five counts of pairs or three of games");
  command.choose("--model", options->model, {"normalized", "logistic"},
                 "what the hypotheses are in; default normalized");
  command.take("--elo", options->elo, "ELO0,ELO1", "strengths of H0 and H1, of the first team against the other");
  command.take("--alpha", options->alpha, "RATE", "rate of accepting H1 in error; default 0.05");
  command.take("--beta", options->beta, "RATE", "rate of accepting H0 in error; default 0.05");
  command.flag("--json", options->json, "write the result as JSON");
  command.notes(sprt_notes);
  command.run = [options] {
    const report::SequentialTestOfCounts test = evaluate(*options);
    output::print(options->json ? report::counts_json(test) : report::counts_text(test));
    return exit_done;
  };
}

}  // namespace regista::cli
