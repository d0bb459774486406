// SPDX-License-Identifier: MIT
#include "study/sequential_test_options.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string_view>
#include <vector>

#include "config/bad_input.hpp"
#include "config/text.hpp"
#include "config/typed.hpp"

namespace regista::study {
namespace {

constexpr double most_elo = 4000.0;

}  // namespace

statistics::Model parse_model(const std::string& text) {
  if (text == "normalized") return statistics::Model::normalized;
  if (text == "logistic") return statistics::Model::logistic;
  throw config::BadInput(config::unknown("model", text, "--model", std::vector<std::string>{"normalized", "logistic"}));
}

statistics::Hypotheses parse_hypotheses(const std::string& option, const std::string& text) {
  const std::size_t comma = text.find(',');
  const auto elo0 = config::typed_number(std::string_view(text).substr(0, comma));
  const auto elo1 =
      comma == std::string::npos ? std::nullopt : config::typed_number(std::string_view(text).substr(comma + 1));
  if (!elo0 || !elo1 || std::abs(*elo0) > most_elo || std::abs(*elo1) > most_elo) {
    throw config::BadInput(fmt::format("{}: {}; expected two numbers from {} to {}, as in 0,10", option,
                                       config::in_quotes(text), -most_elo, most_elo));
  }
  if (!(*elo0 < *elo1)) {
    throw config::BadInput(fmt::format("{}: {}; the first must be the smaller one", option, config::in_quotes(text)));
  }
  return {*elo0, *elo1};
}

statistics::ErrorRates parse_rates(const std::string& alpha, const std::string& beta) {
  const statistics::ErrorRates rates{config::parse_rate("--alpha", alpha), config::parse_rate("--beta", beta)};
  if (!(rates.alpha + rates.beta < 1.0)) {
    throw config::BadInput(fmt::format("--alpha {} and --beta {}: their sum must be below 1", alpha, beta));
  }
  return rates;
}

}  // namespace regista::study
