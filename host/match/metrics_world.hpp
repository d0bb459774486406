// SPDX-License-Identifier: MIT
// How well the robots of one team knew the world: what each believes (the distributed world model of Affinita et al.
// 2023) against the truth at the instant of a decision, once a second for each robot that is not penalised, in the
// phase Playing. docs/metrics.md has the formulas.
//
// - rmse: root of the mean squared distance of an estimate from the truth; over the samples in which there is one.
// - nees: the mean of e' P^-1 e, error e, covariance P of the place: 2 when the covariances are true, more when they
//   promise too much. Y. Bar-Shalom, X. R. Li, T. Kirubarajan, "Estimation with Applications to Tracking and
//   Navigation", 2001, 5.4.
// - coverage_95: how often the truth lies in the ellipse that should hold it in 95 of 100 cases. nees and coverage are
//   over estimates with a covariance that is positive definite; others promise nothing.
// - ospa: see ospa.hpp; all opponents it lists against those that are on the field. Cut off at 2 m.
// - ball_seen: some robot that is not penalised saw the ball in the image of its last decision; at 10 Hz.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "match/belief.hpp"
#include "match/ospa.hpp"

namespace regista::match {

constexpr double ospa_cutoff = 2.0;  // m; assumption: an estimate farther off is as bad as none

// Nothing where nothing was sampled.
struct EstimateMetrics {
  std::optional<double> known_share, rmse_metres, nees, coverage_95;
};

struct WorldModelMetrics {
  EstimateMetrics ball, self, teammates;
  std::optional<double> ospa_metres, ospa_location_metres, ospa_cardinality_metres;  // of opponents; means
  std::optional<double> opponents_listed;                                            // mean number
  std::optional<double> ball_seen_share;
};

class WorldMeasures {
 public:
  explicit WorldMeasures(int team_size);

  // Robot `number` has decided on an image in which it saw the ball, or not.
  void looked(int number, bool sees_ball) { sees_ball_[static_cast<std::size_t>(number - 1)] = sees_ball ? 1 : 0; }

  // A sample of what is seen; active: bit n - 1 for robot n.
  void sample(std::uint32_t active);

  // The truth at the instant of the belief, in its frame.
  struct Truth {
    Vector ball;
    std::span<const Vector> own;        // by robot (n - 1)
    std::uint32_t active;               // of them
    std::span<const Vector> opponents;  // on the field, in any order
  };
  void compare(int number, const Belief& belief, const Truth& truth);

  WorldModelMetrics result() const;

 private:
  struct Errors {
    int asked = 0, known = 0, with_covariance = 0, covered = 0;
    double squared = 0.0, normalised = 0.0;
    void add(const Estimate& estimate, Vector truth);
    EstimateMetrics result() const;
  };
  Errors ball_, self_, teammates_;
  Ospa ospa_;
  int compared_ = 0, listed_ = 0;
  double location_ = 0.0, cardinality_ = 0.0;
  std::vector<char> sees_ball_;
  int samples_ = 0, seen_ = 0;
};

}  // namespace regista::match
