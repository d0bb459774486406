// SPDX-License-Identifier: MIT
// Where a silent teammate is by now: it walks from the pose it last sent straight to the target it last sent, at half
// the speed it last sent, and stands there. A function of the packet and the time since it was sent, and of nothing
// else, so that all robots that heard the packet agree, whatever steps they compute in.
//
// Source: B-Human's rule (Roefer et al., team reports 2022 and 2023).
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <vector>

namespace dead_reckoning {

struct Parameters {
  double speed_factor = 0.5;    // of the sent speed
  double position_noise = 0.1;  // m/s: the deviation of the place grows by this each second
  double heading_noise = 0.2;   // rad/s
  double walk_speed = 0.25;     // m/s: taken for sent when a packet tells no speed
};

// As sent.
struct Packet {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();
  double heading = 0.0;
  double speed = -1.0;  // m/s, negative when it was not told
  bool has_target = false;
  Eigen::Vector2d target = Eigen::Vector2d::Zero();
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();  // of position
  double heading_variance = 0.0;
  double weight = 1.0;
  double age = 0.0;  // s, of the news at the time it was sent
};

// The same now.
struct Estimate {
  Eigen::Vector2d position, velocity;
  Eigen::Matrix2d position_covariance;
  double cross, velocity_variance;  // per axis: E[dp dv], E[dv dv]
  double heading_variance, age;
};

class Teammate {
 public:
  Teammate(int number, const Packet& packet, double ago, const Parameters& parameters)
      : number_(number), packet_(packet), elapsed_(ago), parameters_(parameters) {
    if (!packet.has_target) return;
    const Eigen::Vector2d way = packet.target - packet.position;
    const double length = std::sqrt(way.squaredNorm());
    const double speed = parameters.speed_factor * (packet.speed < 0.0 ? parameters.walk_speed : packet.speed);
    if (length > 0.0 && speed > 0.0) {
      velocity_ = (speed / length) * way;
      arrival_ = length / speed;
    }
  }

  void wait(double dt) { elapsed_ += dt; }

  Estimate now() const {
    const bool walks = elapsed_ < arrival_;
    Estimate now;
    now.position = walks            ? (packet_.position + elapsed_ * velocity_).eval()
                   : arrival_ > 0.0 ? packet_.target
                                    : packet_.position;
    now.velocity = walks ? velocity_ : Eigen::Vector2d::Zero();
    // An unknown error of the velocity that stays the same: its share of the place grows with the time.
    const double variance = parameters_.position_noise * parameters_.position_noise;
    now.velocity_variance = variance;
    now.cross = variance * elapsed_;
    now.position_covariance = packet_.covariance;
    now.position_covariance.diagonal().array() += variance * elapsed_ * elapsed_;
    const double turned = parameters_.heading_noise * elapsed_;
    now.heading_variance = packet_.heading_variance + turned * turned;
    now.age = packet_.age + elapsed_;
    return now;
  }

  int number() const { return number_; }
  const Packet& packet() const { return packet_; }

 private:
  int number_;
  Packet packet_;
  double elapsed_;  // s since the packet was sent
  Parameters parameters_;
  Eigen::Vector2d velocity_ = Eigen::Vector2d::Zero();  // on the way to the target
  double arrival_ = 0.0;                                // s after the packet was sent; 0: it does not walk
};

// Those heard of, by number.
class Team {
 public:
  Team() = default;
  Team(std::size_t size, const Parameters& parameters) : parameters_(parameters) { mates_.reserve(size); }

  void reset() { mates_.clear(); }
  void predict(double dt) {
    for (Teammate& mate : mates_) mate.wait(dt);
  }
  // Replaces what was known of robot `number` by a packet sent `ago` seconds ago.
  void hear(int number, const Packet& packet, double ago) {
    const Teammate fresh(number, packet, ago, parameters_);
    const auto place = std::lower_bound(mates_.begin(), mates_.end(), number,
                                        [](const Teammate& mate, int wanted) { return mate.number() < wanted; });
    if (place != mates_.end() && place->number() == number) {
      *place = fresh;
    } else {
      mates_.insert(place, fresh);
    }
  }
  auto begin() const { return mates_.begin(); }
  auto end() const { return mates_.end(); }

 private:
  Parameters parameters_;
  std::vector<Teammate> mates_;
};

}  // namespace dead_reckoning
