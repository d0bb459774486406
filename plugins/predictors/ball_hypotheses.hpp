// SPDX-License-Identifier: MIT
// A handful of rival hypotheses of where the one ball is, with their probabilities and that of its being none of them:
// the bookkeeping of a Bernoulli filter (Ristic, Vo, Vo, Farina, "A Tutorial on Bernoulli Filters", IEEE Trans. Signal
// Processing 61, 2013). Shared by the predictors of the ball, whose hypotheses differ.
#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace ball {

// What is made of sightings, and of their absence.
struct Evidence {
  int measurements_for_velocity = 4;   // sightings before a velocity is believed
  double gate = 13.8155;               // squared Mahalanobis distance
  double detection_probability = 0.6;  // of a ball well inside the visible area
  double false_density = 0.01;         // false sightings per m^2 and image
  double edge_margin = 0.3;            // m: nearer to the edge of the visible area a miss says nothing
  double surprise = 0.03;              // 1/s: how often the ball is somewhere else altogether
  double prune_weight = 0.01;          // hypotheses below it are dropped
  double merge_distance = 0.1;         // m, and m/s
  double field_area = 54.0;            // m^2: where a ball can appear
};

// Hypothesis has label, sightings, weight (probability) and age (s since the last sighting behind it).
template <class Hypothesis, int capacity>
class Hypotheses {
 public:
  void reset() {
    forget();
    next_label_ = 1;
  }
  void forget() {
    count_ = 0;
    nowhere_ = 1.0;
  }

  // Probability that the ball is none of the hypotheses; `surprise` is the least at this sighting.
  double nowhere() const { return nowhere_; }
  void expect_surprise(double surprise) { nowhere_ = std::max(nowhere_, surprise); }

  // Best first, after weigh().
  Hypothesis* begin() { return all_.data(); }
  Hypothesis* end() { return all_.data() + count_; }
  const Hypothesis* begin() const { return all_.data(); }
  const Hypothesis* end() const { return all_.data() + count_; }

  // The only one from now on, labelled and weighed, to be filled in.
  Hypothesis& replace(double weight) {
    Hypothesis& only = all_[0];
    only = {};
    only.label = fresh_label();
    only.weight = weight;
    count_ = 1;
    nowhere_ = 1.0 - weight;
    return only;
  }

  // Labels `fresh` and takes it in; in the place of the weakest when there is no room, unless that weighs as much.
  void add(Hypothesis& fresh) {
    int place = count_;
    if (count_ < capacity) {
      ++count_;
    } else {
      place = 0;
      for (int i = 1; i < count_; ++i) {
        if (at(i).weight <= at(place).weight) place = i;
      }
      if (at(place).weight >= fresh.weight) return;
    }
    fresh.label = fresh_label();
    at(place) = fresh;
  }

  // Normalises with "nowhere", merges like ones into the better, drops those below `prune`; best first.
  template <class Alike>
  void weigh(double prune, const Alike& alike) {
    sort();
    double sum = nowhere_;
    for (const Hypothesis& each : *this) sum += each.weight;
    nowhere_ /= sum;
    int kept = 0;
    for (int i = 0; i < count_; ++i) {
      Hypothesis& candidate = at(i);
      candidate.weight /= sum;
      int same = 0;
      while (same < kept && !alike(at(same), candidate)) ++same;
      if (same < kept) {
        Hypothesis& other = at(same);
        other.weight += candidate.weight;
        other.sightings = std::max(other.sightings, candidate.sightings);
        other.age = std::min(other.age, candidate.age);
      } else if (candidate.weight < prune) {
        nowhere_ += candidate.weight;
      } else {
        if (kept != i) at(kept) = candidate;
        ++kept;
      }
    }
    count_ = kept;
    sort();
  }

 private:
  Hypothesis& at(int i) { return all_[static_cast<std::size_t>(i)]; }

  void sort() {
    for (int i = 1; i < count_; ++i) {
      for (int j = i; j > 0 && at(j).weight > at(j - 1).weight; --j) std::swap(at(j), at(j - 1));
    }
  }

  int fresh_label() {
    const int label = next_label_;
    next_label_ = label == std::numeric_limits<int>::max() ? 1 : label + 1;
    return label;
  }

  std::array<Hypothesis, static_cast<std::size_t>(capacity)> all_;
  int count_ = 0;
  double nowhere_ = 1.0;
  int next_label_ = 1;
};

}  // namespace ball
