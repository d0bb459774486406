// SPDX-License-Identifier: MIT
#include "cli/test_options.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>
#include <system_error>
#include <vector>

#include "cli/end_of_program.hpp"
#include "config/text.hpp"

namespace regista::cli {
namespace {

constexpr double most_elo = 4000.0;

std::optional<double> number(std::string_view text) {
  double value = 0.0;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || rest != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

}  // namespace

statistics::Model parse_model(const std::string& text) {
  if (text == "normalized") return statistics::Model::normalized;
  if (text == "logistic") return statistics::Model::logistic;
  throw BadInput(config::unknown("model", text, "--model", std::vector<std::string>{"normalized", "logistic"}));
}

statistics::Hypotheses parse_hypotheses(const std::string& option, const std::string& text) {
  const std::size_t comma = text.find(',');
  const auto elo0 = number(std::string_view(text).substr(0, comma));
  const auto elo1 = comma == std::string::npos ? std::nullopt : number(std::string_view(text).substr(comma + 1));
  if (!elo0 || !elo1 || std::abs(*elo0) > most_elo || std::abs(*elo1) > most_elo) {
    throw BadInput(fmt::format("{}: {}; two numbers from {} to {} are wanted, as in 0,10", option,
                               config::in_quotes(text), -most_elo, most_elo));
  }
  if (!(*elo0 < *elo1)) {
    throw BadInput(fmt::format("{}: {}; the first must be the smaller one", option, config::in_quotes(text)));
  }
  return {*elo0, *elo1};
}

double parse_rate(const std::string& option, const std::string& text) {
  const auto rate = number(text);
  if (!rate || !(*rate > 0.0 && *rate < 1.0)) {
    throw BadInput(fmt::format("{}: {}; a number above 0 and below 1 is wanted", option, config::in_quotes(text)));
  }
  return *rate;
}

statistics::ErrorRates parse_rates(const std::string& alpha, const std::string& beta) {
  const statistics::ErrorRates rates{parse_rate("--alpha", alpha), parse_rate("--beta", beta)};
  if (!(rates.alpha + rates.beta < 1.0)) {
    throw BadInput(fmt::format("--alpha {} and --beta {}: their sum must be below 1", alpha, beta));
  }
  return rates;
}

std::uint64_t parse_whole(const std::string& option, const std::string& text, std::uint64_t least, std::uint64_t most) {
  std::uint64_t value = 0;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || rest != end || value < least || value > most) {
    throw BadInput(
        fmt::format("{}: {}; a whole number from {} to {} is wanted", option, config::in_quotes(text), least, most));
  }
  return value;
}

}  // namespace regista::cli
