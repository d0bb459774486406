// SPDX-License-Identifier: MIT
// Negative information (Hoffmann, Spranger, Göhring and Jüngel 2005): a robot that looks where the ball is said to be
// and does not see it knows that it is not there. Without it a team stares at the place of old news.
#pragma once

#include <span>
#include <vector>

#include "mind/geometry.hpp"
#include "mind/percepts.hpp"
#include "mind/world/fusion.hpp"

namespace regista::mind {

class NegativeInformation {
 public:
  // Sources are 0 (the own eyes) to team_size.
  explicit NegativeInformation(int team_size) : sources_(static_cast<std::size_t>(team_size) + 1) {}

  // Looks for each estimate of the ball (one per source at most, field frame) in what the camera saw, `dt` seconds
  // after the last time.
  void look(std::span<const Estimate> balls, const Frame2& own, const Percepts& percepts, double dt);

  // The source's present estimate has been looked for in vain.
  bool refutes(int source) const { return sources_[static_cast<std::size_t>(source)].in_vain > enough; }

 private:
  static constexpr double enough =
      0.55;  // s of clear view: five frames; at 0.9 per frame a ball is missed once in 10^5
  struct Source {
    double in_vain = 0.0;  // s
    double age = 0.0;      // of its estimate at the last look
  };
  std::vector<Source> sources_;
};

}  // namespace regista::mind
