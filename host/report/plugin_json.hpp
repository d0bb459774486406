// SPDX-License-Identifier: MIT
// What there is to say about a plugin, for programs: numbers as numbers.
#pragma once

#include "plugin/found.hpp"
#include "texts/json.hpp"

namespace regista::report {

nlohmann::ordered_json plugin_json(const plugin::Found& plugin);

// One line of text; file names that are not UTF-8 lose what is not.
std::string text_of(const nlohmann::ordered_json& json);

}  // namespace regista::report
