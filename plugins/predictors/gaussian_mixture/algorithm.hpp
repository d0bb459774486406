// SPDX-License-Identifier: MIT
// Opponents as a Gaussian mixture: predict, match, merge, prune. Each component is one robot that may be there: place
// and velocity by a Kalman filter, and the probability that it exists.
//
// Sources: Affinita et al. (the paper: a Gaussian mixture models the obstacles); velocities of 0.1 to 0.4 m/s as SPL
// teams have them; moment-preserving merge: Runnalls, "Kullback-Leibler approach to Gaussian mixture reduction" (IEEE
// Trans. AES 43, 2007), section IV.
//
// Opponents do not vanish, they walk out of sight. So only what surely was in view counts as missed, and two components
// become one only where one robot stands. docs/predictors.md has what each of these rules is worth.
//
// Motion: each velocity component is an Ornstein-Uhlenbeck process (a random walk pulled back to zero) with the
// standing deviation `speed` and the time constant `persistence`; over a longer time the place walks at random.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "../planar_state.hpp"

namespace gaussian_mixture {

struct Parameters {
  double speed = 0.13;                 // m/s, standard deviation of each component of the velocity
  double persistence = 2.0;            // s
  double gate = 13.8155106;            // squared Mahalanobis distance
  double merge_distance = 0.2;         // m
  double detection_probability = 0.6;  // of a robot in the visible area
  double false_probability = 0.05;     // that a sighting at a component's place is false
  double birth_weight = 0.4;           // of a component at its first sighting
  double prune_weight = 0.05;          // components below it are dropped
  double forget_after = 60.0;          // s unseen
  double body_radius = 0.15;           // m, of a robot that hides others
};

using planar::Sighting;

// A sector of a disc, seen from `apex` along the unit vector `axis`.
struct View {
  Eigen::Vector2d apex, axis;
  double cosine, sine;  // of half the opening angle, which is in [0, pi]
  double range;

  // Whether the disc of this radius about the point lies inside.
  bool holds(const Eigen::Vector2d& point, double radius = 0.0) const {
    const Eigen::Vector2d arm = point - apex;
    const double most = range - radius;
    if (most < 0.0 || arm.squaredNorm() > most * most) return false;
    const bool all_round = sine <= 0.0 && cosine < 0.0;
    const double ahead = arm.dot(axis), aside = std::abs(axis.x() * arm.y() - axis.y() * arm.x());
    return all_round || ahead * sine - aside * cosine >= radius;
  }

  // Whether a body of the radius `body`, with its centre at `before`, may hide what is within `radius` of the point.
  bool may_hide(const Eigen::Vector2d& before, double body, const Eigen::Vector2d& point, double radius) const {
    const Eigen::Vector2d arm = point - apex, nearer = before - apex;
    const double distance = arm.norm(), along = nearer.dot(arm) / distance;
    if (!(along > 0.0 && along < distance)) return false;
    const double across = std::abs(nearer.x() * arm.y() - nearer.y() * arm.x()) / distance;
    return across < body + radius * along / distance;
  }
};

struct Component {
  planar::State state;
  int label = 0;
  bool seen = false;    // in the image just taken in
  double weight = 0.0;  // probability that it exists
  double age = 0.0;     // s since it was last seen
};

class Mixture {
 public:
  static constexpr int capacity = 24;

  Mixture() : Mixture(Parameters{}) {}
  explicit Mixture(const Parameters& parameters) : parameters_(parameters) {}

  void reset() {
    count_ = 0;
    next_label_ = 1;
    step_ = {};
  }

  void predict(double dt) {
    if (count_ == 0) return;
    if (dt != step_.dt) step_ = Step(dt, parameters_);
    for (int i = 0; i < count_; ++i) advance(components_[index(i)]);
    drop([this](const Component& each) { return each.age > parameters_.forget_after; });
  }

  // One image: match, miss, merge, prune. `sightings`: a range of Sighting.
  template <class Sightings>
  void correct(const Sightings& sightings, const View& view) {
    for (int i = 0; i < count_; ++i) components_[index(i)].seen = false;
    for (const Sighting& sighting : sightings) match(sighting);
    const double detected = parameters_.detection_probability, missed = 1.0 - detected;
    for (int i = 0; i < count_; ++i) {
      Component& each = components_[index(i)];
      if (!each.seen && looked_at(each, view)) each.weight *= missed / (1.0 - each.weight * detected);
    }
    merge();
    drop([this](const Component& each) { return each.weight < parameters_.prune_weight; });
  }

  // Replacing the whole model by what a packet said: clear, add each, then predict(age).
  void clear() { count_ = 0; }
  // label <= 0 or taken: a fresh one. Ignored when there is no room or the weight is below what is kept.
  void add(Component told) {
    if (count_ == capacity || told.weight < parameters_.prune_weight) return;
    told.weight = std::min(told.weight, greatest_weight);
    if (told.label <= 0 || taken(told.label)) {
      told.label = fresh_label();
    } else if (told.label >= next_label_ && told.label < std::numeric_limits<int>::max()) {
      next_label_ = told.label + 1;
    }
    components_[index(count_++)] = told;
  }

  const Component* begin() const { return components_.data(); }
  const Component* end() const { return components_.data() + count_; }
  // The sightings have told more than half of what there was to know of the velocity.
  bool velocity_believed(const Component& each) const {
    return each.state.velocity_covariance.trace() < parameters_.speed * parameters_.speed;
  }

 private:
  // A weight of exactly 1 could never fall again.
  static constexpr double greatest_weight = 0.99;

  static std::size_t index(int i) { return static_cast<std::size_t>(i); }

  // The motion over dt, in closed form: p' = p + reach v, v' = keep v, and its noise per axis.
  struct Step {
    double dt = 0.0, keep = 1.0, reach = 0.0, position_noise = 0.0, cross_noise = 0.0, velocity_noise = 0.0;
    Step() = default;
    Step(double duration, const Parameters& parameters) : dt(duration) {
      const double tau = parameters.persistence, variance = parameters.speed * parameters.speed;
      const double lost = -std::expm1(-dt / tau);  // 1 - keep
      keep = 1.0 - lost;
      reach = tau * lost;
      velocity_noise = variance * lost * (1.0 + keep);
      cross_noise = variance * tau * lost * lost;
      position_noise = std::max(0.0, variance * tau * (2.0 * (dt - reach) - tau * lost * lost));
    }
  };

  void advance(Component& each) const {
    const Step& step = step_;
    planar::State& state = each.state;
    state.position += step.reach * state.velocity;
    state.velocity *= step.keep;
    state.position_covariance +=
        step.reach * (state.cross + state.cross.transpose()) + (step.reach * step.reach) * state.velocity_covariance;
    state.cross = step.keep * (state.cross + step.reach * state.velocity_covariance);
    state.velocity_covariance *= step.keep * step.keep;
    state.position_covariance.diagonal().array() += step.position_noise;
    state.cross.diagonal().array() += step.cross_noise;
    state.velocity_covariance.diagonal().array() += step.velocity_noise;
    each.age += step.dt;
  }

  // In view with all that one standard deviation covers, and behind nobody who is there more likely than not.
  bool looked_at(const Component& one, const View& view) const {
    const double deviation = std::sqrt(0.5 * one.state.position_covariance.trace());
    if (!view.holds(one.state.position, deviation)) return false;
    return std::none_of(begin(), end(), [&](const Component& other) {
      return &other != &one && other.weight >= 0.5 &&
             view.may_hide(other.state.position, parameters_.body_radius, one.state.position, deviation);
    });
  }

  void match(const Sighting& sighting) {
    Component* nearest = nullptr;
    double least = parameters_.gate;
    Eigen::Matrix2d inverse;
    for (int i = 0; i < count_; ++i) {
      Component& each = components_[index(i)];
      if (each.seen) continue;  // a camera sees a robot once
      const Eigen::Matrix2d spread = each.state.position_covariance + sighting.covariance;
      const Eigen::Vector2d gap = sighting.position - each.state.position;
      const double determinant = spread(0, 0) * spread(1, 1) - spread(0, 1) * spread(1, 0);
      const double distance = (spread(1, 1) * gap.x() * gap.x() - 2.0 * spread(0, 1) * gap.x() * gap.y() +
                               spread(0, 0) * gap.y() * gap.y()) /
                              determinant;
      if (distance <= least) {
        least = distance;
        nearest = &each;
        inverse << spread(1, 1) / determinant, -spread(0, 1) / determinant, -spread(0, 1) / determinant,
            spread(0, 0) / determinant;
      }
    }
    if (nearest == nullptr) return start(sighting);
    update(nearest->state, sighting.position - nearest->state.position, sighting.covariance, inverse, true);
    nearest->seen = true;
    nearest->age = 0.0;
    const double w = nearest->weight, detected = parameters_.detection_probability;
    nearest->weight =
        std::min(greatest_weight, w * detected / (w * detected + (1.0 - w) * parameters_.false_probability));
  }

  void start(const Sighting& sighting) {
    if (parameters_.birth_weight < parameters_.prune_weight) return;
    int place = count_;
    if (count_ == capacity) {  // the weakest gives way
      place = 0;
      for (int i = 1; i < count_; ++i) {
        if (components_[index(i)].weight <= components_[index(place)].weight) place = i;
      }
      if (components_[index(place)].weight >= parameters_.birth_weight) return;
    }
    const int label = fresh_label();  // before there is one more: what its place held before counts for nothing
    count_ = std::max(count_, place + 1);
    Component& fresh = components_[index(place)];
    fresh = {};
    fresh.label = label;
    fresh.state.position = sighting.position;
    fresh.state.position_covariance = sighting.covariance;
    fresh.state.velocity_covariance.diagonal().setConstant(parameters_.speed * parameters_.speed);
    fresh.weight = std::min(parameters_.birth_weight, greatest_weight);
    fresh.seen = true;
  }

  // Near ones become one, under the older label. Two that were seen at once are two.
  void merge() {
    const double limit = parameters_.merge_distance * parameters_.merge_distance;
    for (int i = 0; i < count_; ++i) {
      for (int j = i + 1; j < count_;) {
        Component &a = components_[index(i)], &b = components_[index(j)];
        if (!(a.seen && b.seen) && (a.state.position - b.state.position).squaredNorm() < limit) {
          combine(a, b);
          remove(j);
          j = i + 1;  // the merged one has moved
        } else {
          ++j;
        }
      }
    }
  }

  // Mean and covariance of the two as a mixture. It is rare, and kept out of the loop over pairs, which it would slow.
  [[gnu::cold]] static void combine(Component& a, const Component& b) {
    mix(a.state, b.state, b.weight / (a.weight + b.weight));
    a.label = std::min(a.label, b.label);
    a.seen = a.seen || b.seen;
    a.weight = std::min(greatest_weight, a.weight + b.weight - a.weight * b.weight);
    a.age = std::min(a.age, b.age);
  }

  void remove(int place) {
    for (int i = place + 1; i < count_; ++i) components_[index(i - 1)] = components_[index(i)];
    --count_;
  }

  template <class Condition>
  void drop(const Condition& condition) {
    int kept = 0;
    for (int i = 0; i < count_; ++i) {
      if (condition(components_[index(i)])) continue;
      if (kept != i) components_[index(kept)] = components_[index(i)];
      ++kept;
    }
    count_ = kept;
  }

  bool taken(int label) const {
    return std::any_of(begin(), end(), [label](const Component& each) { return each.label == label; });
  }

  int fresh_label() {
    int label;
    do {
      label = next_label_;
      next_label_ = label == std::numeric_limits<int>::max() ? 1 : label + 1;
    } while (taken(label));
    return label;
  }

  Parameters parameters_;
  std::array<Component, capacity> components_;
  int count_ = 0, next_label_ = 1;
  Step step_;
};

}  // namespace gaussian_mixture
