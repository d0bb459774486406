// SPDX-License-Identifier: MIT
// What describes a sequential test, from what was typed. All throw BadInput.
#pragma once

#include <string>

#include "statistics/likelihood_ratio.hpp"
#include "statistics/sequential_bounds.hpp"

namespace regista::study {

// "normalized" or "logistic", of --model
statistics::Model parse_model(const std::string& text);

// "0,10": two numbers, the first the smaller one. `option`: who asks.
statistics::Hypotheses parse_hypotheses(const std::string& option, const std::string& text);

// Of --alpha and --beta.
statistics::ErrorRates parse_rates(const std::string& alpha, const std::string& beta);

}  // namespace regista::study
