// SPDX-License-Identifier: MIT
// What `regista match` was asked for.
#pragma once

#include <string>
#include <vector>

#include "campaign/match_setup.hpp"

namespace regista::cli {

struct MatchOptions : campaign::MatchRequest {
  std::vector<std::string> set, plugins;  // --set, as typed
  std::string decisions, record, metrics, from, row;
  bool force = false, json = false, quiet = false, verbose = false, in_process = false;
  std::string log = "info";  // the least level of the lines of plugins that are shown; "none": none of them
  std::string processor_seconds = "10", wall_seconds = "200";
};

}  // namespace regista::cli
