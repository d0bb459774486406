// SPDX-License-Identifier: MIT
// Where the resolved documents of teams differ: a row for each value that is not the same in all of them, by the path
// that --set would use. Elements of lists are called by their names where they have some, so that a list in another
// order, or with one element more, does not differ everywhere.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "report/outline.hpp"

namespace regista::report {

struct DifferingValue {
  std::string path;                                // "sender.params.reserve", "roles.playing[striker].target.at"
  std::vector<std::optional<std::string>> values;  // by document; nothing where there is no such value
};

// documents: YAML as config::show writes it without remarks. In the order of the first document, then what only later
// ones have. Throws config::Error for what is no YAML.
std::vector<DifferingValue> differing_values(std::span<const std::string> documents);

// For a page: in the teams' documents, disturbances, plugins and files; then each document in full. documents: of the
// first teams, in their order; none: not known.
Section configuration_section(std::span<const std::string> documents, std::span<const PlayedTeam> teams);

}  // namespace regista::report
