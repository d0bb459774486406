// SPDX-License-Identifier: MIT
// Everything stays where it was last measured or said to be; only the uncertainty grows. A function of the last news
// and the time since, and of nothing else, so that all robots that heard the same agree. No filter and no lesson from
// misses: the floor that any other predictor must beat.
//
// Source: the released code of SPQR, which leaves silent teammates where they last said to be (the "hold last" row of
// studies of prediction). Growth: a constant velocity that is not known, zero in the mean.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>

namespace hold_last {

struct Parameters {
  double speed = 0.3;           // m/s: deviation of each component of the unknown velocity
  double turn_rate = 0.2;       // rad/s: the same of the heading
  double match_distance = 1.0;  // m: a sighting farther from all that is held is somebody else
  double forget_after = 8.0;    // s without news; infinite: never
};

struct Sighting {
  Eigen::Vector2d position;
  Eigen::Matrix2d covariance;
};

// As last measured or told.
struct Held {
  int label = 0;
  Eigen::Vector2d position = Eigen::Vector2d::Zero();
  double heading = 0.0;
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();  // of position
  double heading_variance = 0.0;
  bool has_target = false;
  Eigen::Vector2d target = Eigen::Vector2d::Zero();
  double weight = 1.0;
  double age_then = 0.0;  // s, of the news at `elapsed` = 0
  double elapsed = 0.0;   // s since

  double age() const { return age_then + elapsed; }
};

// What the time since the news adds to the covariance of (place, velocity), per axis, and to the heading's variance.
struct Growth {
  double position, cross, velocity, heading;
  Growth(const Held& held, const Parameters& parameters) {
    velocity = parameters.speed * parameters.speed;
    cross = velocity * held.elapsed;
    position = cross * held.elapsed;
    const double turned = parameters.turn_rate * held.elapsed;
    heading = turned * turned;
  }
};

class Memory {
 public:
  static constexpr int capacity = 32;

  Memory() : Memory(Parameters{}) {}
  explicit Memory(const Parameters& parameters) : parameters_(parameters) {}

  void reset() {
    count_ = 0;
    next_label_ = 1;
  }
  void clear() { count_ = 0; }

  void predict(double dt) {
    for (int i = 0; i < count_; ++i) at(i).elapsed += dt;
    forget();
  }

  // One thing of which there is only one: of several sightings that nearest to where it is held; the first sighting
  // when it is not held.
  template <class Sightings>
  void see_the_one(const Sightings& sightings) {
    const Sighting* best = nullptr;
    double least = std::numeric_limits<double>::infinity();
    for (const Sighting& each : sightings) {
      const double squared = count_ == 0 ? 0.0 : (each.position - at(0).position).squaredNorm();
      if (squared < least) {
        least = squared;
        best = &each;
      }
    }
    if (best == nullptr) return;
    Held fresh;
    fresh.label = 1;
    put(fresh, *best);
    held_[0] = fresh;
    count_ = 1;
  }

  // Any number of things without names: nearest pairs first, each thing seen once. `sightings`: random access, at most
  // 64 are looked at.
  template <class Sightings>
  void see_many(const Sightings& sightings) {
    const int seen = std::min(static_cast<int>(std::size(sightings)), 64);
    std::uint64_t used = 0;
    std::uint32_t matched = 0;
    for (;;) {
      int thing = -1, sighting = -1;
      double least = parameters_.match_distance * parameters_.match_distance;
      for (int i = 0; i < count_; ++i) {
        if ((matched >> i & 1u) != 0) continue;
        for (int j = 0; j < seen; ++j) {
          if ((used >> j & 1u) != 0) continue;
          const double squared = (sightings[static_cast<std::size_t>(j)].position - at(i).position).squaredNorm();
          if (squared <= least) {
            least = squared;
            thing = i;
            sighting = j;
          }
        }
      }
      if (thing < 0) break;
      put(at(thing), sightings[static_cast<std::size_t>(sighting)]);
      matched |= std::uint32_t{1} << thing;
      used |= std::uint64_t{1} << sighting;
    }
    for (int j = 0; j < seen; ++j) {
      if ((used >> j & 1u) != 0) continue;
      Held fresh;
      fresh.label = fresh_label();
      put(fresh, sightings[static_cast<std::size_t>(j)]);
      add(fresh);
    }
  }

  // What a packet said of the thing with this label, in place of what was held of it; kept by ascending label. A label
  // that is not positive gets a fresh one. `told.elapsed`: the packet's age.
  void hear(Held told) {
    if (told.label <= 0) told.label = fresh_label();
    int place = 0;
    while (place < count_ && at(place).label < told.label) ++place;
    if (place < count_ && at(place).label == told.label) {
      at(place) = told;
    } else if (count_ < capacity) {
      for (int i = count_; i > place; --i) at(i) = at(i - 1);
      at(place) = told;
      ++count_;
    }
    if (told.label >= next_label_) next_label_ = told.label == std::numeric_limits<int>::max() ? 1 : told.label + 1;
    forget();
  }

  const Held* begin() const { return held_.data(); }
  const Held* end() const { return held_.data() + count_; }
  const Parameters& parameters() const { return parameters_; }

 private:
  Held& at(int i) { return held_[static_cast<std::size_t>(i)]; }

  static void put(Held& held, const Sighting& sighting) {
    held.position = sighting.position;
    held.covariance = sighting.covariance;
    held.weight = 1.0;
    held.age_then = held.elapsed = 0.0;
  }

  // The one longest without news gives way when there is no room.
  void add(const Held& fresh) {
    if (count_ < capacity) {
      at(count_++) = fresh;
      return;
    }
    Held* oldest = held_.data();
    for (int i = 1; i < count_; ++i) {
      if (at(i).age() > oldest->age()) oldest = &at(i);
    }
    *oldest = fresh;
  }

  void forget() {
    int kept = 0;
    for (int i = 0; i < count_; ++i) {
      if (at(i).age() > parameters_.forget_after) continue;
      if (kept != i) at(kept) = at(i);
      ++kept;
    }
    count_ = kept;
  }

  int fresh_label() {
    int label;
    do {
      label = next_label_;
      next_label_ = label == std::numeric_limits<int>::max() ? 1 : label + 1;
    } while (std::any_of(begin(), end(), [label](const Held& each) { return each.label == label; }));
    return label;
  }

  Parameters parameters_;
  std::array<Held, capacity> held_;
  int count_ = 0, next_label_ = 1;
};

}  // namespace hold_last
