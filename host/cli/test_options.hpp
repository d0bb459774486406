// SPDX-License-Identifier: MIT
// Values of options that describe a sequential test, from what was typed. All throw BadInput.
#pragma once

#include <cstdint>
#include <string>

#include "statistics/likelihood_ratio.hpp"
#include "statistics/sequential_bounds.hpp"

namespace regista::cli {

// "normalized" or "logistic", of --model
statistics::Model parse_model(const std::string& text);

// "0,10": two numbers, the first the smaller one. `option`: who asks.
statistics::Hypotheses parse_hypotheses(const std::string& option, const std::string& text);

// A number above 0 and below 1.
double parse_rate(const std::string& option, const std::string& text);

// Of --alpha and --beta.
statistics::ErrorRates parse_rates(const std::string& alpha, const std::string& beta);

// Decimal digits alone.
std::uint64_t parse_whole(const std::string& option, const std::string& text, std::uint64_t least, std::uint64_t most);

}  // namespace regista::cli
