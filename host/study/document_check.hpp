// SPDX-License-Identifier: MIT
// Checks of documents. For a team or a study, the check includes its plugins: each plugin must exist, open, be of the
// right kind and accept its parameters. Openings must fit the rules and robots.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "config/documents.hpp"
#include "config/team_check.hpp"
#include "mind/team_plan.hpp"
#include "plugin/catalogue.hpp"

namespace regista::study {

// The rules and robots with which openings and teams are checked.
struct Profiles {
  config::Rules rules;
  std::array<config::Robot, 2> robots;  // [0] home, [1] away
};

struct DocumentMistake {
  config::Location where;     // names only the file if the mistake has no line
  std::string message, line;  // line: message with its place, as the program prints it
};

struct DocumentCheck {
  std::string file, kind;                 // kind: empty if unknown
  std::vector<DocumentMistake> mistakes;  // in the order of their lines
  std::size_t more = 0;                   // number of further mistakes, which the check did not keep
  std::vector<config::Warning> warnings;
};

// A kind of study. `check` tests whether a valid document of this kind can be planned, and adds mistakes to `mistakes`.
struct StudyCheck {
  config::DocumentKind document;
  std::function<void(const config::Node& document, config::Mistakes& mistakes)> check;
};

DocumentCheck check_document(const std::string& file, const Profiles& played_by, const plugin::Catalogue& catalogue,
                             std::span<const StudyCheck> studies);

}  // namespace regista::study
