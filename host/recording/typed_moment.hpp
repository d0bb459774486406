// SPDX-License-Identifier: MIT
// A moment of a recorded match, and a robot of it, as they are typed: 7:42, 462.3, 2/3:10; 3, away/5. Errors are
// BadInput and begin with the option.
#pragma once

#include <string>

#include "recording/recorded_match.hpp"

namespace regista::recording {

struct Moment {
  std::string typed;
  int half = 0;          // 0: seconds since the match began
  double seconds = 0.0;  // else of the clock of this half
};

Moment parse_moment(const std::string& typed);

// In seconds since the match began.
double time_of(const RecordedMatch& match, const Moment& moment);

RobotName parse_robot(const std::string& typed, int team_size);

}  // namespace regista::recording
