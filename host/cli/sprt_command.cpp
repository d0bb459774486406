// SPDX-License-Identifier: MIT
// `regista sprt --elo ELO0,ELO1 COUNTS`: what counts of games or pairs say, without playing any.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/command.hpp"
#include "cli/end_of_program.hpp"
#include "cli/output.hpp"
#include "config/text.hpp"
#include "statistics/likelihood_ratio.hpp"
#include "statistics/rating.hpp"
#include "statistics/sequential_test.hpp"
#include "study/sequential_test_options.hpp"

namespace regista::cli {
namespace {

constexpr auto notes =
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

struct Options {
  std::string model = "normalized", elo, alpha = "0.05", beta = "0.05";
  std::vector<std::string> counts;
  bool json = false;
};

// Everything that is told, in whatever form.
struct Result {
  std::vector<statistics::Count> counts;
  std::string model;
  statistics::SequentialDesign design;
  statistics::SequentialBounds bounds;
  statistics::LogLikelihoodRatio ratio;
  statistics::ScoreLaw law;
  statistics::Estimate elo, normalized_elo;
  double superiority;
  std::optional<double> pair_ratio;
};

std::vector<statistics::Count> parse_counts(const std::vector<std::string>& words) {
  std::vector<statistics::Count> counts;
  statistics::Count sum = 0;
  for (const std::string& word : words) {
    statistics::Count count = 0;
    const auto [rest, error] = std::from_chars(word.data(), word.data() + word.size(), count);
    if (error != std::errc() || rest != word.data() + word.size() || count < 0 || count > statistics::most_counted) {
      throw BadInput(fmt::format("sprt: count {}; a whole number from 0 to {} is wanted", config::in_quotes(word),
                                 statistics::most_counted));
    }
    counts.push_back(count);
    sum += count;
  }
  if (counts.size() != 3 && counts.size() != 5) {
    throw BadInput(fmt::format("sprt: {} counts; five of pairs (LL LD DD WD WW) or three of games (L D W) are wanted",
                               counts.size()));
  }
  if (sum == 0) throw BadInput("sprt: all counts are zero");
  return counts;
}

Result evaluate(const Options& options) {
  Result result{};
  result.model = options.model;
  result.design.model = study::parse_model(options.model);
  if (options.elo.empty()) throw BadInput("sprt: which hypotheses? Say --elo ELO0,ELO1, for example --elo 0,10");
  result.design.hypotheses = study::parse_hypotheses("--elo", options.elo);
  result.design.rates = study::parse_rates(options.alpha, options.beta);
  result.counts = parse_counts(options.counts);
  if (result.counts.size() == 5) {
    statistics::PairCounts pairs;
    std::copy(result.counts.begin(), result.counts.end(), pairs.seen.begin());
    result.law = score_law(pairs);
    result.pair_ratio = pair_ratio(pairs);
  } else {
    statistics::GameCounts games;
    std::copy(result.counts.begin(), result.counts.end(), games.seen.begin());
    result.law = score_law(games);
  }
  result.bounds = sequential_bounds(result.design.rates);
  result.ratio = log_likelihood_ratio(result.law, result.design.model, result.design.hypotheses);
  result.elo = elo(result.law);
  result.normalized_elo = normalized_elo(result.law);
  result.superiority = likelihood_of_superiority(result.law);
  return result;
}

const char* name(statistics::Verdict verdict) {
  switch (verdict) {
    case statistics::Verdict::accept_h0:
      return "H0";
    case statistics::Verdict::accept_h1:
      return "H1";
    case statistics::Verdict::inconclusive:
      break;
  }
  return "INCONCLUSIVE";
}

const char* name(statistics::Method method) {
  switch (method) {
    case statistics::Method::exact:
      return "exact";
    case statistics::Method::closed_form:
      return "closed_form";
    case statistics::Method::no_information:
      break;
  }
  return "no_information";
}

std::string json(const Result& result) {
  nlohmann::ordered_json out;
  const auto interval = [](const statistics::Estimate& estimate) {
    // An infinite bound becomes null.
    return nlohmann::ordered_json::array({estimate.interval.low, estimate.interval.high});
  };
  out["unit"] = result.law.unit == statistics::Unit::pair ? "pairs" : "games";
  out["counts"] = result.counts;
  out["model"] = result.model;
  out["elo0"] = result.design.hypotheses.elo0;
  out["elo1"] = result.design.hypotheses.elo1;
  out["alpha"] = result.design.rates.alpha;
  out["beta"] = result.design.rates.beta;
  out["llr"] = result.ratio.value;
  out["llr_bounds"] = {result.bounds.lower, result.bounds.upper};
  out["llr_method"] = name(result.ratio.method);
  out["elo"] = result.elo.value;
  out["elo_interval"] = interval(result.elo);
  out["nelo"] = result.normalized_elo.value;
  out["nelo_interval"] = interval(result.normalized_elo);
  out["los"] = result.superiority;
  if (result.pair_ratio) {
    out["pair_ratio"] = *result.pair_ratio;
  } else {
    out["pair_ratio"] = nullptr;
  }
  out["verdict"] = name(verdict_on(result.ratio, result.bounds));
  return out.dump() + '\n';
}

std::string with_margin(const statistics::Estimate& estimate) {
  if (estimate.interval.bounded()) return fmt::format("{:.2f} +- {:.2f}", estimate.value, estimate.margin());
  return fmt::format("{:.2f}, 95 % interval {:.2f} to {:.2f}", estimate.value, estimate.interval.low,
                     estimate.interval.high);
}

std::string text(const Result& result) {
  const bool of_pairs = result.law.unit == statistics::Unit::pair;
  std::string out = of_pairs ? "Pairs (LL, LD, WL+DD, WD, WW): " : "Games (L, D, W): ";
  out += fmt::format("{}\n", fmt::join(result.counts, ", "));
  out += fmt::format("Elo: {}, nElo: {}\n", with_margin(result.elo), with_margin(result.normalized_elo));
  out += fmt::format("LOS: {:.2f} %", 100.0 * result.superiority);
  if (result.pair_ratio) out += fmt::format(", pair ratio: {:.2f}", *result.pair_ratio);
  out += fmt::format("\nLLR: {:.3f} ({:.3f}, {:.3f}) [{}, {}] {}\n", result.ratio.value, result.bounds.lower,
                     result.bounds.upper, result.design.hypotheses.elo0, result.design.hypotheses.elo1, result.model);
  if (result.ratio.method == statistics::Method::closed_form) {
    out += "The bounds are out of reach of such scores: the LLR is an approximation.\n";
  }
  if (result.law.variation == statistics::Variation::none) {
    out += fmt::format("Every {} ended even: no information.\n", of_pairs ? "pair" : "game");
  }
  out += fmt::format("Verdict: {}\n", name(verdict_on(result.ratio, result.bounds)));
  return out;
}

}  // namespace

Command add_sprt(CLI::App& parent, const Invocation&) {
  CLI::App& app = *parent.add_subcommand("sprt", "what counts of games or pairs say: LLR, Elo, nElo, LOS");
  const auto options = std::make_shared<Options>();
  app.add_option("counts", options->counts, "five counts of pairs or three of games")->type_name("COUNTS");
  app.add_option("--model", options->model, "normalized (default) or logistic: what the hypotheses are in")
      ->type_name("MODEL");
  app.add_option("--elo", options->elo, "strengths of H0 and H1, of the first team against the other")
      ->type_name("ELO0,ELO1");
  app.add_option("--alpha", options->alpha, "rate of accepting H1 in error; default 0.05")->type_name("RATE");
  app.add_option("--beta", options->beta, "rate of accepting H0 in error; default 0.05")->type_name("RATE");
  app.add_flag("--json", options->json, "write the result as JSON");
  app.footer(notes);
  return {&app, [options] {
            const Result result = evaluate(*options);
            print(options->json ? json(result) : text(result));
            return exit_done;
          }};
}

}  // namespace regista::cli
