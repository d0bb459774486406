// SPDX-License-Identifier: MIT
// Opponents by the Gaussian mixture PHD filter: a mixture whose weights add up to the expected number of robots, also
// in every part of the field, without deciding which sighting belongs to which robot.
//
// Sources: Vo and Ma, "The Gaussian Mixture Probability Hypothesis Density Filter" (IEEE Trans. Signal Processing 54,
// 2006): prediction, correction and reduction (tables I and II). Ristic, Clark, Vo and Vo, "Adaptive target birth
// intensity for PHD and CPHD filters" (IEEE Trans. AES 48, 2012): robots appear where something is seen, and compete
// there with clutter and with those that are known. Panta, Clark and Vo, "Data association and track management for the
// Gaussian mixture PHD filter" (IEEE Trans. AES 45, 2009): labels that components hand on to what becomes of them.
//
// What is particular here:
// - The probability of detection is 0 outside the visible area (view.hpp), so what is not looked at is not forgotten.
//   A sighting, on the other hand, proves that its robot was in view, wherever the borders were thought to be: its term
//   has the full probability, and what is left of its component is a miss.
// - Two components with different labels become one only while together they stand for hardly more than one robot;
//   else two robots that have not been seen for a while would become one as their covariances grow.
// - Occlusion by other robots is not modelled; a smaller probability of detection stands for it.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "component.hpp"
#include "view.hpp"

namespace gm_phd {

struct Parameters {
  double speed = 0.2;             // m/s, standard deviation of each component of the velocity
  double persistence = 0.8;       // s
  double survival = 0.99;         // per second
  double detection = 0.98;        // probability that a robot in the visible area is seen
  double clutter_density = 5e-4;  // false sightings per m^2 of view and image
  double birth_density = 1e-3;    // robots that appear per m^2 of view and image
  double gate = 18.42068074;      // squared Mahalanobis distance
  double prune_weight = 1e-5;
  double merge_distance = 4.0;  // squared Mahalanobis distance
  double confirm_weight = 0.5;  // a component that has weighed so much is told,
  double told_weight = 1e-3;    // until it weighs less than this
};

class Filter {
 public:
  static constexpr std::size_t capacity = 100;       // components between two images
  static constexpr std::size_t work_capacity = 256;  // while an image is taken in

  Filter() : Filter(Parameters{}) {}
  explicit Filter(const Parameters& parameters) : parameters_(parameters) {}

  void reset() {
    count_ = 0;
    next_label_ = 1;
    step_ = {};
  }

  void predict(double dt) {
    if (count_ == 0) return;
    if (dt != step_.dt) step_ = Step(dt, parameters_.speed, parameters_.persistence, parameters_.survival);
    std::size_t kept = 0;
    for (std::size_t i = 0; i < count_; ++i) {
      advance(components_[i], step_);
      if (components_[i].weight < parameters_.prune_weight) continue;
      if (kept != i) components_[kept] = components_[i];
      ++kept;
    }
    count_ = kept;
  }

  // One image. `sightings`: a range of Sighting.
  template <class Sightings>
  void correct(const Sightings& sightings, const View& view) {
    const std::size_t known = count_;
    for (std::size_t i = 0; i < known; ++i) {
      const Component& each = components_[i];
      prior_[i] = each.weight;
      explained_[i] = 0.0;
      places_[i] = {each.x, each.y, parameters_.gate * (each.pxx + each.pyy)};
      components_[i].seen = false;
    }
    for (const Sighting& sighting : sightings) explain(sighting, known);
    for (std::size_t i = 0; i < known; ++i) {
      // At least so much of a robot was in view as was seen.
      const double inside =
          std::max(view.share(components_[i]), std::min(1.0, explained_[i] / std::min(1.0, prior_[i])));
      components_[i].weight = prior_[i] * (1.0 - parameters_.detection * inside);
    }
    reduce();
  }

  // Replacing the whole model by what a packet said: clear, add each, then predict(age).
  void clear() { count_ = 0; }
  // label <= 0 or taken: a fresh one. Ignored when there is no room or the weight is below what is kept.
  void add(const Component& told) {
    if (count_ == capacity || told.weight < parameters_.prune_weight) return;
    Component& added = components_[count_];
    added = told;
    added.confirmed = told.weight >= parameters_.confirm_weight;
    if (told.label <= 0 || taken(told.label, components_.data(), count_)) {
      added.label = fresh_label();
    } else if (told.label >= next_label_ && told.label < std::numeric_limits<int>::max()) {
      next_label_ = told.label + 1;
    }
    ++count_;
  }

  // After an image the heaviest first.
  const Component* begin() const { return components_.data(); }
  const Component* end() const { return components_.data() + count_; }
  bool told(const Component& each) const { return each.confirmed && each.weight >= parameters_.told_weight; }
  // The sightings have told more than half of what there was to know of the velocity.
  bool velocity_believed(const Component& each) const {
    return each.vxx + each.vyy < parameters_.speed * parameters_.speed;
  }

 private:
  struct Candidate {
    std::size_t index;
    double likelihood;
    Fit fit;
  };

  // What the many comparisons that come to nothing need, side by side.
  struct Place {
    double x, y;
    double reach;  // m^2: whatever is farther away by the square is out of the question
    double squared_distance(double px, double py) const { return (px - x) * (px - x) + (py - y) * (py - y); }
  };
  struct Rank {
    double weight;
    std::size_t index;
  };

  // What explains a sighting less than this times as well as the best explanation does is credited to the best: it
  // would be merged into it at once, and change nothing but the sum.
  static constexpr double negligible = 0.01;
  // Components with different labels that stand for more robots than this together are not merged.
  static constexpr double one_robot = 1.5;

  // The terms of one sighting: each of the `known` components that may have caused it, corrected by it, and a newborn,
  // all over what could have caused it altogether.
  void explain(const Sighting& sighting, std::size_t known) {
    constexpr double two_pi = 6.28318530717958648;
    const double noise = parameters_.gate * (sighting.xx + sighting.yy);
    double total = 0.0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < known; ++i) {
      // No eigenvalue of the innovation's covariance exceeds its trace.
      if (places_[i].squared_distance(sighting.x, sighting.y) > places_[i].reach + noise) continue;
      Candidate& candidate = candidates_[count];
      candidate.fit = compare(components_[i], sighting);
      if (!(candidate.fit.distance <= parameters_.gate)) continue;
      candidate.index = i;
      candidate.likelihood = prior_[i] * parameters_.detection * std::exp(-0.5 * candidate.fit.distance) /
                             (two_pi * std::sqrt(candidate.fit.determinant));
      total += candidate.likelihood;
      ++count;
    }
    total += parameters_.clutter_density + parameters_.birth_density;
    if (!(total > 0.0)) return;
    const Candidate* best = nullptr;
    for (std::size_t k = 0; k < count; ++k) {
      const Candidate& candidate = candidates_[k];
      explained_[candidate.index] += candidate.likelihood / total;
      if (best == nullptr || candidate.likelihood > best->likelihood) best = &candidate;
    }
    double credited = 0.0;
    for (std::size_t k = 0; k < count; ++k) {
      const Candidate& candidate = candidates_[k];
      const double weight = candidate.likelihood / total;
      if (candidate.likelihood < negligible * best->likelihood) {
        credited += weight;
      } else if (&candidate != best) {
        correct(candidate, sighting, weight);
      }
    }
    const double weight = parameters_.birth_density / total;
    const bool swallowed = best != nullptr && parameters_.birth_density < negligible * best->likelihood;
    if (best != nullptr) {
      correct(*best, sighting, best->likelihood / total + credited + (swallowed ? weight : 0.0));
    }
    if (!swallowed && weight >= parameters_.prune_weight && count_ < work_capacity) {
      Component& newborn = components_[count_++];
      newborn = {};
      newborn.x = sighting.x;
      newborn.y = sighting.y;
      newborn.pxx = sighting.xx;
      newborn.pxy = sighting.xy;
      newborn.pyy = sighting.yy;
      newborn.vxx = newborn.vyy = parameters_.speed * parameters_.speed;
      newborn.weight = weight;
      newborn.seen = true;
    }
  }

  // Adds what a known component becomes when the sighting is of its robot.
  void correct(const Candidate& candidate, const Sighting& sighting, double weight) {
    if (weight < parameters_.prune_weight || count_ == work_capacity) return;
    Component& corrected = components_[count_++];
    corrected = components_[candidate.index];
    take(corrected, sighting, candidate.fit);
    corrected.weight = weight;
  }

  // Prune, merge around the heaviest, keep at most `capacity`.
  void reduce() {
    std::size_t ranked = 0;
    for (std::size_t i = 0; i < count_; ++i) {
      if (components_[i].weight >= parameters_.prune_weight) ranks_[ranked++] = {components_[i].weight, i};
    }
    std::sort(ranks_.begin(), ranks_.begin() + static_cast<std::ptrdiff_t>(ranked), [](const Rank& a, const Rank& b) {
      return a.weight != b.weight ? a.weight > b.weight : a.index < b.index;
    });
    for (std::size_t k = 0; k < ranked; ++k) {
      const Component& each = components_[ranks_[k].index];
      places_[k] = {each.x, each.y, parameters_.merge_distance * (each.pxx + each.pyy)};
      merged_[k] = false;
    }
    std::size_t kept = 0;
    for (std::size_t k = 0; k < ranked && kept < capacity; ++k) {
      if (merged_[k]) continue;
      const Component& centre = components_[ranks_[k].index];
      Component& blob = reduced_[kept];
      blob = centre;
      for (std::size_t m = k + 1; m < ranked; ++m) {
        if (merged_[m] || places_[m].squared_distance(centre.x, centre.y) > places_[m].reach) continue;
        const Component& other = components_[ranks_[m].index];
        if (!mergeable(centre, other, blob.weight)) continue;
        combine(blob, other);
        merged_[m] = true;
        if (blob.label == 0) {
          blob.label = other.label;
          blob.confirmed = other.confirmed;
        }
      }
      if (blob.label == 0 || taken(blob.label, reduced_.data(), kept)) {
        blob.label = fresh_label();
        blob.confirmed = false;
      }
      blob.confirmed = blob.confirmed || blob.weight >= parameters_.confirm_weight;
      ++kept;
    }
    std::copy_n(reduced_.begin(), kept, components_.begin());
    count_ = kept;
  }

  bool mergeable(const Component& centre, const Component& other, double weight) const {
    const bool left_over = other.label == centre.label && centre.label != 0 && !(other.seen && centre.seen);
    return (left_over || weight + other.weight <= one_robot) &&
           distance(centre, other, parameters_.merge_distance) <= parameters_.merge_distance;
  }

  static bool taken(int label, const Component* among, std::size_t count) {
    return std::any_of(among, among + count, [label](const Component& each) { return each.label == label; });
  }

  int fresh_label() {
    int label;
    do {
      label = next_label_;
      next_label_ = label == std::numeric_limits<int>::max() ? 1 : label + 1;
    } while (taken(label, components_.data(), count_));
    return label;
  }

  Parameters parameters_;
  std::array<Component, work_capacity> components_;
  std::array<Component, capacity> reduced_;
  std::array<Candidate, capacity> candidates_;
  std::array<double, capacity> prior_;      // weights before the image
  std::array<double, capacity> explained_;  // robots of each that were seen in it
  std::array<Place, work_capacity> places_;
  std::array<Rank, work_capacity> ranks_;
  std::array<bool, work_capacity> merged_;
  std::size_t count_ = 0;
  int next_label_ = 1;
  Step step_;
};

}  // namespace gm_phd
