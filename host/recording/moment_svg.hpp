// SPDX-License-Identifier: MIT
// One moment of a recorded match as a picture: the field as it truly was and, of one robot, the world as it believed
// it, where it saw waypoints and tasks, the utility estimation matrix from which it chose, and what its plugins drew
// and logged. For papers and slides: light, colours that can be told apart by the colour-blind (Okabe and Ito 2008),
// text as text.
#pragma once

#include <optional>
#include <string>

#include "recording/recorded_match.hpp"

namespace regista::recording {

// SVG 1.1 in UTF-8. Precondition: `moment` is of `match`, with all that is of `robot` if there is one.
std::string moment_svg(const RecordedMatch& match, const RecordedMoment& moment, const std::optional<RobotName>& robot);

}  // namespace regista::recording
