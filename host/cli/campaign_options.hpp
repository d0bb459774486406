// SPDX-License-Identifier: MIT
// The options that all commands share which play many matches.
#pragma once

#include <string>

#include "campaign/options.hpp"
#include "cli/common_names.hpp"

namespace regista::cli {

// default_results: what the help says.
void add_campaign_options(Command& command, campaign::Options& options, const std::string& default_results);

}  // namespace regista::cli
