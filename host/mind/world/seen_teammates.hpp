// SPDX-License-Identifier: MIT
// The obstacle model of Affinita et al. 2023 holds "all robots", the own ones too. A robot that sees one of its own
// team's jerseys knows where somebody stands, and a teammate's last packet, carried forward, says who that may be.
#pragma once

#include <span>
#include <vector>

#include "regista/abi.h"

namespace regista::mind {

// `track`: of a robot of the own team as the own eyes have it. Points into the list that was matched.
struct SeenTeammate {
  int number;
  const regista_track* track;
};

// Pairs tracks with active robots but `own`: the least squared Mahalanobis distance of their places first, within the
// 99 % gate, each once. A track that fits two robots about as well is nobody's: the wrong number is worse than none.
// Appends to `out`.
void match_teammates(std::span<const regista_track> seen, std::span<const regista_robot> robots, int own,
                     std::vector<SeenTeammate>& out);

// Fuses the place by what the eyes say, which the packets do not know: the product of both Gaussians.
void sharpen(regista_robot& robot, const regista_track& seen);

}  // namespace regista::mind
