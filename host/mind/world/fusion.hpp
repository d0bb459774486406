// SPDX-License-Identifier: MIT
// f of the paper: several robots' estimates of the same thing become one (WorldModel::fuse calls it for each part).
// Their errors are correlated to an unknown degree (they saw the same ball, they carry it forward by the same model),
// so multiplying Gaussians would be overconfident; covariance intersection (Julier and Uhlmann 1997) with the
// closed-form weights of Niehsen 2002 stays consistent.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mind/geometry.hpp"
#include "regista/abi.h"

namespace regista::mind {

// An estimate of one object by one source (0: the own eyes, n: the packets of robot n). The track is its predictor's.
struct Estimate {
  const regista_track* track;
  int source;
};

// The ball that the estimates agree on: the most certain one, fused with those that do not contradict it. An estimate
// becomes less certain with its age, whatever its covariance says, because anybody may have kicked the ball since.
// `age` is the youngest of those fused. Not known (flags 0) without estimates. Estimates of weight 0 are ignored.
regista_ball fuse_ball(std::span<const Estimate> estimates);

// One list of opponents out of several: estimates of different sources within `merge_distance` are the same robot. At
// most `most` of them, the likeliest first, of equally likely ones the latest seen. `out` is replaced. Estimates of the
// source `without` are left out.
class OpponentFusion {
 public:
  OpponentFusion(double merge_distance, std::size_t most) : merge_distance_(merge_distance), most_(most) {
    clusters_.reserve(64 + 5 * most);  // own eyes, and five in a packet of each robot
  }
  void fuse(std::span<const Estimate> estimates, std::vector<regista_opponent>& out, int without = -1);

 private:
  struct Cluster {
    Vector2d weighted_sum, position, velocity;  // information-weighted
    double information = 0.0;                   // sum of 1 / trace
    double information2 = 0.0;
    double missing = 1.0;  // probability that none of its estimates is real
    double age = 0.0;
    double best_trace = 0.0;
    int label = 0;
    std::uint32_t sources = 0;
  };
  double merge_distance_;
  std::size_t most_;
  std::vector<Cluster> clusters_;
};

}  // namespace regista::mind
