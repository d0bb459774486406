// SPDX-License-Identifier: MIT
// A Node tree written back as YAML in one line: `{roles: searching, sender.params.period: 4}`.
#pragma once

#include <string>
#include <string_view>

#include "config/node.hpp"

namespace regista::config {

std::string flow(const Node& node);

// A scalar: as it is when that reads as the same text or number, else in double quotes.
std::string flow_text(std::string_view text, bool quoted);

}  // namespace regista::config
