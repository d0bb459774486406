// SPDX-License-Identifier: MIT
// The options that all commands share which play many matches.
#pragma once

#include <string>

#include "campaign/options.hpp"

namespace CLI {
class App;
}

namespace regista::cli {

// default_results: what the help says.
void add_campaign_options(CLI::App& app, campaign::Options& options, const std::string& default_results);

}  // namespace regista::cli
