// SPDX-License-Identifier: MIT
// Whether documents are sound. For teams and studies that means their plugins too: that they exist, can be opened, are
// of the right kind, and take the parameters they are given. For openings it means that they can be played by rules and
// a robot.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "config/documents.hpp"
#include "config/team_warnings.hpp"
#include "plugin/catalogue.hpp"

namespace regista::study {

// What openings and teams are to be played by.
struct Profiles {
  config::Rules rules;
  std::array<config::Robot, 2> robots;  // by side
};

struct DocumentMistake {
  config::Location where;     // of one that has no place in the document: its file alone
  std::string message, line;  // the second with the place, as it is printed
};

struct DocumentCheck {
  std::string file, kind;                 // kind: empty where it is not known
  std::vector<DocumentMistake> mistakes;  // in the order of the lines
  std::size_t more = 0;                   // mistakes that were found, but not kept
  std::vector<config::Warning> warnings;
};

// A kind of study, as far as its documents are checked: whether one that is sound in itself can be planned.
struct StudyCheck {
  config::DocumentKind document;
  std::function<void(const config::Node& document, config::Mistakes& mistakes)> check;
};

DocumentCheck check_document(const std::string& file, const Profiles& played_by, const plugin::Catalogue& catalogue,
                             std::span<const StudyCheck> studies);

}  // namespace regista::study
