// SPDX-License-Identifier: MIT
// Functions that pair tracks of the same robot or ball, and that fuse estimates of one object (f of the paper). A track
// (regista_track) is the estimate that a predictor makes of one robot or ball.
//
// Tracks are paired by the squared Mahalanobis distance: the nearest pair first, each track at most once. Robots use
// equal models and see the same ball, so the errors of their estimates are correlated to an unknown degree, and a
// product of Gaussians would be overconfident. Covariance intersection (Julier and Uhlmann 1997) with the closed-form
// weights of Niehsen 2002 stays consistent.
#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "mind/geometry.hpp"
#include "mind/percepts.hpp"
#include "regista/abi.h"

namespace regista::mind {

// --- delta of the paper (Affinita et al. 2023) for the balls or the opponents of OLM_j, which is made from the packets
// of robot j: "merges the OLM of the previous step with any received event". A received track replaces the known track
// of the same object, because a fusion of the two would count the same sightings twice. Other known tracks are dropped,
// unless they may be too old for the packet or the packet had no room. A track that is kept loses weight if the sender
// may have looked at its place, because the sender then saw no object there.

// What the sender of a packet may have seen lately, and which tracks its packets contain. Field frame.
struct SenderView {
  Pose pose;
  double half_angle = 0.0;   // rad: half the image's angle plus the head's largest yaw
  double range = 0.0;        // m
  double probability = 0.0;  // probability that a visible object is detected
  double tells_up_to = 0.0;  // s: packets contain only tracks up to this age
  bool tells_all = true;     // the packet had room for more tracks, so the packet contains all young tracks
};

// Merges known tracks and received tracks (`told`) into `out`. Both lists must describe the moment of the packet's
// arrival; `out` must be neither list. A received track that replaces a known track gets the known track's label; other
// received tracks get new labels. Kept tracks keep their labels.
void merge_told(std::span<const regista_track> known, std::span<const regista_track> told, const SenderView& sender,
                std::vector<regista_track>& out);

// --- The obstacle model of Affinita et al. 2023 holds "all robots", so also teammates. A robot's camera sees where a
// teammate is, but not its number. The last packets of teammates tell which teammate it may be.

// A teammate that this robot's camera sees. `track`: an element of the list `seen` given to match_teammates().
struct SeenTeammate {
  int number;
  const regista_track* track;
};

// Pairs tracks with active robots other than `own`, and appends the pairs to `out`. The pair with the least squared
// Mahalanobis distance comes first; each track and robot is paired at most once. Left out are pairs with more than 9.21
// (99 % of true pairs have less), tracks that fit two robots about equally well (a difference below 4), and tracks
// older than 5 s (an assumption: the robot may have walked on).
void match_teammates(std::span<const regista_track> seen, std::span<const regista_robot> robots, int own,
                     std::vector<SeenTeammate>& out);

// Replaces the robot's position by its fusion with the seen track: the product of two independent Gaussians.
void sharpen(regista_robot& robot, const regista_track& seen);

// The covariance of a ball's state (x, y, vx, vy): ten numbers in the 2 x 2 blocks position, velocity and cross. The
// inverse by blocks (Schur complement) costs a third of a general inverse.
struct Symmetric4 {
  struct Block {
    double xx = 0.0, xy = 0.0, yy = 0.0;
    Block inverse() const {
      const double factor = 1.0 / (xx * yy - xy * xy);
      return {factor * yy, -factor * xy, factor * xx};
    }
  };
  Block position, velocity;
  double xx = 0.0, xy = 0.0, yx = 0.0, yy = 0.0;  // cross: x with vx, x with vy, y with vx, y with vy

  // from() reads `covariance` and `motion` of a regista_track. write() writes `covariance` of a regista_ball.
  static Symmetric4 from(const double (&place)[3], const double (&rest)[7]) {
    return {{place[0], place[1], place[2]}, {rest[4], rest[5], rest[6]}, rest[0], rest[1], rest[2], rest[3]};
  }
  void write(double (&motion)[10]) const {
    const double values[10]{position.xx, position.xy, position.yy, xx,          xy,
                            yx,          yy,          velocity.xx, velocity.xy, velocity.yy};
    std::copy_n(values, 10, motion);
  }

  // this += factor * other
  void add(double factor, const Symmetric4& other) {
    position.xx += factor * other.position.xx;
    position.xy += factor * other.position.xy;
    position.yy += factor * other.position.yy;
    velocity.xx += factor * other.velocity.xx;
    velocity.xy += factor * other.velocity.xy;
    velocity.yy += factor * other.velocity.yy;
    xx += factor * other.xx;
    xy += factor * other.xy;
    yx += factor * other.yx;
    yy += factor * other.yy;
  }

  Eigen::Vector4d operator*(const Eigen::Vector4d& v) const {
    return {position.xx * v[0] + position.xy * v[1] + xx * v[2] + xy * v[3],
            position.xy * v[0] + position.yy * v[1] + yx * v[2] + yy * v[3],
            xx * v[0] + yx * v[1] + velocity.xx * v[2] + velocity.xy * v[3],
            xy * v[0] + yy * v[1] + velocity.xy * v[2] + velocity.yy * v[3]};
  }

  // Returns the inverse. The matrix must be positive definite.
  Symmetric4 inverse() const {
    const Block p = position.inverse();
    // U = P^-1 C and the Schur complement S = V - C^T U.
    const double u00 = p.xx * xx + p.xy * yx, u01 = p.xx * xy + p.xy * yy;
    const double u10 = p.xy * xx + p.yy * yx, u11 = p.xy * xy + p.yy * yy;
    const Block schur{velocity.xx - (xx * u00 + yx * u10), velocity.xy - (xx * u01 + yx * u11),
                      velocity.yy - (xy * u01 + yy * u11)};
    const Block s = schur.inverse();
    // W = U S^-1; the blocks are P^-1 + W U^T, -W, S^-1.
    const double w00 = u00 * s.xx + u01 * s.xy, w01 = u00 * s.xy + u01 * s.yy;
    const double w10 = u10 * s.xx + u11 * s.xy, w11 = u10 * s.xy + u11 * s.yy;
    return {{p.xx + (w00 * u00 + w01 * u01), p.xy + (w00 * u10 + w01 * u11), p.yy + (w10 * u10 + w11 * u11)},
            s,
            -w00,
            -w01,
            -w10,
            -w11};
  }
};

// An estimate of one object. source: 0 = this robot's camera, n = the packets of robot n. A predictor owns `track`.
struct Estimate {
  const regista_track* track;
  int source;
};

// Fuses the most certain estimate of the ball with the estimates that do not contradict it (whose squared Mahalanobis
// distance from it is at most 9.21: 99 % of true pairs are nearer). The variance of an old estimate is increased,
// because a robot may have moved the ball since the sighting. The result has the age of the youngest fused estimate.
// Estimates of weight 0 are ignored. Without estimates the ball is unknown (flags 0).
regista_ball fuse_ball(std::span<const Estimate> estimates);

// Fuses the opponents of several sources: track-to-track association by the nearest pair first (Bar-Shalom and Li,
// Multitarget-Multisensor Tracking, 1995, section 8.3), then covariance intersection with the weights of Niehsen.
// Tracks of one source are different robots. A track and what earlier sources have of a robot are the same one if their
// squared Mahalanobis distance is at most 9.21 (99 % of true pairs) and they are within 2 m, beyond which an old track
// would fit anybody. So two sources that have just seen two robots side by side have two robots, and an old place joins
// the robot that has been seen since.
class OpponentFusion {
 public:
  OpponentFusion() {
    clusters_.reserve(128);
    order_.reserve(128);
  }
  void clear() { clusters_.clear(); }
  // Adds all tracks of one source (at most 64; numbers as in Estimate); each source once. They must last until clear().
  // Sources may be added in any order, but the order decides where more than one association is possible.
  void add(std::span<const regista_track> tracks, int source);
  // Replaces `out` with at most `most` opponents. That one comes first which most likely exists and is within 1 m of
  // its place: of more than can play, the least sure gives way. More sources may be added afterwards.
  void write(std::size_t most, std::vector<regista_opponent>& out);

 private:
  struct Cluster {  // the tracks of one opponent
    Cluster(const regista_track& track, int from) { add(track, from); }
    void add(const regista_track& track, int from);
    Vector2d position{0.0, 0.0};          // weighted_sum / information2
    double trace = 0.0;                   // of the covariance of `position`
    const regista_track* best = nullptr;  // the most certain track
    int source = 0, source_of_best = 0;   // of the last track; of the most certain one
    Vector2d weighted_sum{0.0, 0.0};      // of positions, by information^2
    double information = 0.0;             // sum of 1 / trace of the covariances
    double information2 = 0.0;            // sum of 1 / trace^2
    double missing = 1.0;                 // probability that no track of the cluster is real
    double likelihood = 0.0;              // of an opponent near this place; below 0: not computed since the last track
    double age = std::numeric_limits<double>::infinity(), best_trace = age;  // the least ones
    std::int32_t label() const;  // unique over all sources, if the tracks' labels are below 2^27
  };
  std::vector<Cluster> clusters_;
  std::vector<const Cluster*> order_;
};

// Negative information (Hoffmann, Spranger, Göhring and Jüngel 2005): to see no ball at its estimated place refutes it.
class NegativeInformation {
 public:
  // Estimate::source may be 0 to team_size.
  explicit NegativeInformation(int team_size) : sources_(static_cast<std::size_t>(team_size) + 1) {}

  // Compares the balls (at most one a source, field frame) with the view from `own`. `dt`: s since the last call.
  void look(std::span<const Estimate> balls, const Frame2& own, const Percepts& percepts, double dt);

  // Returns whether the camera has looked at the present estimate for more than 0.55 s without seeing a ball.
  bool refutes(int source) const { return sources_[static_cast<std::size_t>(source)].in_vain > enough; }

 private:
  // Limit of in_vain, s: five images. A camera that sees a ball with probability 0.9 misses it five times once in 10^5.
  static constexpr double enough = 0.55;
  struct Source {
    double in_vain = 0.0;  // time of looking in vain, s
    double age = 0.0;      // age of the estimate in the last look(), s
  };
  std::vector<Source> sources_;
};

}  // namespace regista::mind
