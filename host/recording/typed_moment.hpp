// SPDX-License-Identifier: MIT
// A moment of a recorded match, a robot of it, and the layers that its plugins drew, as they are typed: 7:42, 462.3,
// 2/3:10; 3, away/5; cells, "voronoi: cells". Errors are BadInput and begin with the option.
#pragma once

#include <string>
#include <vector>

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

// Empties all drawings but those that are named, by "plugin: layer" or by the layer alone, which may be of several
// plugins. Without names all stay.
void keep_layers(std::vector<RecordedDrawing>& drawings, const std::vector<std::string>& typed);

}  // namespace regista::recording
