// SPDX-License-Identifier: MIT
// Measures how well the robots of one team knew the world. Once a second in Playing, the belief of each robot without
// penalty (distributed world model of Affinita et al. 2023) is compared with the truth. Formulas: docs/metrics.md.
//
// - rmse: root mean squared distance of an estimate from the truth, over the samples with an estimate.
// - nees: mean of e' P^-1 e with the error e and the covariance P of the position. nees is 2 if the covariances are
//   correct, and greater if the covariances are too small. Y. Bar-Shalom, X. R. Li, T. Kirubarajan, "Estimation with
//   Applications to Tracking and Navigation", 2001, 5.4.
// - coverage_95: share of the estimates whose 95 % ellipse contains the truth. nees and coverage_95 use only estimates
//   with a positive definite covariance.
// - ospa: distance (see Ospa) between the opponents that a robot lists and the opponents on the field, cut off at 2 m.
// - ball_seen: share of samples (10 Hz, robots without penalty) in which the last decision's image showed the ball.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "match/side.hpp"
#include "mind/coordination/task_filter.hpp"

namespace regista::match {

// An estimated position (m) with its covariance (m^2).
struct Estimate {
  bool known = false;  // false: the robot has no estimate
  Vector at;
  double xx = 0.0, xy = 0.0, yy = 0.0;
};

struct Belief {  // What one robot believes at one moment. Field frame of the robot's side, metres.
  Estimate self, ball;
  std::vector<Estimate> teammates;  // by robot (n - 1); the robot's own entry is ignored
  std::vector<Vector> opponents;
};

// Fills `out` with the belief of robot `number` after its last decision. The memory of `out` is reused.
using Beliefs = std::function<void(Side side, int number, Belief& out)>;

// Ospa computes the distance between a set of estimated positions and a set of true positions: the OSPA metric of order
// 1, D. Schuhmacher, B.-T. Vo and B.-N. Vo, "A Consistent Metric for Performance Evaluation of Multi-Object Filters",
// IEEE Transactions on Signal Processing 56(8), 2008. For sets of m <= n positions and distances cut off at c,
//   OSPA = (min over assignments of the m to different ones of the n: sum of min(c, distance) + c (n - m)) / n.
// OSPA is 0 for two empty sets. OSPA of order 1 is the sum of a location part and a cardinality part.

struct OspaParts {
  double location = 0.0;     // m: part due to the distances of assigned positions
  double cardinality = 0.0;  // m: part due to missing or superfluous positions
};

class Ospa {
 public:
  // cutoff: m, greater than 0. most: memory is reserved for sets of up to `most` positions.
  Ospa(double cutoff, std::size_t most);

  OspaParts operator()(std::span<const Vector> a, std::span<const Vector> b);

 private:
  double cutoff_;
  std::vector<double> cost_;  // rows x columns, row by row
  mind::LeastCostAssignment assignment_;
};

constexpr double ospa_cutoff = 2.0;  // m; assumption: an estimate with a larger error is as bad as no estimate

struct EstimateMetrics {  // The top of this file defines these numbers. A number is nothing without samples.
  std::optional<double> known_share, rmse_metres, nees, coverage_95;
};

struct WorldModelMetrics {
  EstimateMetrics ball, self, teammates;
  std::optional<double> ospa_metres, ospa_location_metres, ospa_cardinality_metres;  // opponents; mean over samples
  std::optional<double> opponents_listed;                                            // opponents per belief, mean
  std::optional<double> ball_seen_share;
};

class WorldMeasures {
 public:
  explicit WorldMeasures(int team_size);

  // The caller calls this after each decision of robot `number`. sees_ball: the decision's image showed the ball.
  void looked(int number, bool sees_ball);

  // Takes a sample of ball_seen. active: the robots without penalty, bit n - 1 for robot n.
  void sample(std::uint32_t active);

  struct Truth {  // The truth at the moment of the belief; field frame of the robot's side, as in Belief.
    Vector ball;
    std::span<const Vector> own;        // by robot (n - 1)
    std::uint32_t active;               // robots without penalty: bit n - 1 for robot n
    std::span<const Vector> opponents;  // opponents on the field, in any order
  };
  void compare(int number, const Belief& belief, const Truth& truth);  // takes a sample of the belief

  WorldModelMetrics result() const;

 private:
  struct Errors {
    int asked = 0, known = 0, with_covariance = 0, covered = 0;  // numbers of samples
    double squared = 0.0, normalised = 0.0;
    void add(const Estimate& estimate, Vector truth);
    EstimateMetrics result() const;
  };
  Errors ball_, self_, teammates_;
  Ospa ospa_;
  int compared_ = 0, listed_ = 0;
  double location_ = 0.0, cardinality_ = 0.0;
  std::uint32_t sees_ball_ = 0;  // bit n - 1 for robot n
  int samples_ = 0, seen_ = 0;
};

}  // namespace regista::match
