// SPDX-License-Identifier: MIT
#include "report/counts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "report/few_uneven.hpp"
#include "report/number.hpp"
#include "texts/json.hpp"

namespace regista::report {
namespace {

const char* sprt_name(statistics::Verdict verdict) {
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

const char* sprt_name(statistics::Method method) {
  switch (method) {
    case statistics::Method::exact:
      return "exact";
    case statistics::Method::closed_form:
      break;
  }
  return "closed_form";
}

std::string with_margin(const statistics::Estimate& estimate) {
  const std::string value = fixed(estimate.value, 2);
  if (estimate.interval.bounded()) return fmt::format("{} +- {:.2f}", value, estimate.margin());
  if (estimate.interval.unbounded()) return value + " (no interval)";
  return fmt::format("{}, 95 % interval {:.2f} to {:.2f}", value, estimate.interval.low, estimate.interval.high);
}

}  // namespace

SequentialTestOfCounts test_counts(const std::vector<statistics::Count>& counts, const std::string& model,
                                   const statistics::SequentialDesign& design) {
  SequentialTestOfCounts result{};
  result.counts = counts;
  result.model = model;
  result.design = design;
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

std::string counts_text(const SequentialTestOfCounts& result) {
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
  // Of even units alone the second says both.
  const std::string why = result.law.uneven() > 0 ? why_no_interval(result.law) : "";
  for (const std::string& sentence : {why, what_the_test_rests_on(result.law)}) {
    if (!sentence.empty()) out += sentence + '\n';
  }
  out += fmt::format("Verdict: {}\n", sprt_name(verdict_on(result.ratio, result.bounds)));
  return out;
}

std::string counts_json(const SequentialTestOfCounts& result) {
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
  out["llr_method"] = sprt_name(result.ratio.method);
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
  out["verdict"] = sprt_name(verdict_on(result.ratio, result.bounds));
  return out.dump() + '\n';
}

}  // namespace regista::report
