// SPDX-License-Identifier: MIT
// What one robot's body measures and its camera sees, made from the truth at the instant of a decision: a sector with
// ranges, occlusion by robots in between, misses, noise, false balls, odometry that drifts.
//
// Sightings are sorted by measured distance, so that their order tells nothing about who or which they are.
// Objects are numbered for the streams of chance: robots by id, landmarks by their place in the list, the ball 0.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "config/disturbance.hpp"
#include "config/robot.hpp"
#include "match/arena.hpp"
#include "match/chance.hpp"
#include "match/side.hpp"
#include "mind/percepts.hpp"

namespace regista::match {

struct Mark {
  int kind;         // REGISTA_LANDMARK_*
  Vector position;  // world frame
};

class Sensing {
 public:
  // Profiles and marks are the caller's and must live as long.
  Sensing(const config::Robot& profile, const config::Disturbance& disturbance, std::span<const Mark> marks,
          Roster roster, int id, std::uint64_t seed, double robot_radius);

  // The robot has been put down at `world`; `direction`: the way its side attacks. Told with the next percepts.
  void put_down(const mind::Pose& world, double direction, std::uint32_t tick);

  // The head begins to turn to this yaw, rad.
  void look(double yaw);

  // All robots as they are, and which are out of play (bit id).
  struct Truth {
    std::span<const BodyState> states;  // robots by id, then the ball
    std::uint32_t out_of_play = 0;
  };
  // Fills odometry, placed, camera, view, balls, robots and landmarks of `out`. able: it can see (stands, in play).
  void sense(const Truth& truth, double time, std::uint32_t tick, bool able, mind::Percepts& out);

 private:
  struct Candidate {
    Vector relative;  // robot frame
    double squared_distance;
  };
  struct Sighting {
    Vector position;
    double along, across;
  };
  void measure_motion(const BodyState& own, std::uint32_t tick, mind::Percepts& out);
  void turn_head(double time);
  bool in_sector(const Candidate& candidate, double range) const;
  bool hidden(const Candidate& candidate) const;
  Sighting measured(const Candidate& candidate, Chance& chance) const;
  void see_ball(const Truth& truth, std::uint32_t tick, mind::Percepts& out) const;
  void see_robots(std::uint32_t tick, mind::Percepts& out) const;
  void see_landmarks(const BodyState& own, std::uint32_t tick, mind::Percepts& out) const;

  const config::Robot& profile_;
  const config::Disturbance& disturbance_;
  std::span<const Mark> marks_;
  Roster roster_;
  int id_;
  std::uint64_t seed_;
  Side side_;
  int number_;
  double robot_radius_;
  double largest_range_;
  double scale_ = 1.0;  // of this robot's odometry in this match

  Vector last_position_;
  double last_heading_ = 0.0, last_cosine_ = 1.0, last_sine_ = 0.0;
  std::optional<mind::PlacedPose> placed_;
  bool lifted_ = true;  // put down since the last decision: no odometry

  double head_ = 0.0, wanted_head_ = 0.0, head_time_ = 0.0;
  // Of the present instant:
  Vector axis_;  // of the camera, robot frame
  double cosine_half_angle_;
  struct Neighbour {
    Candidate candidate;
    int id;
  };
  std::vector<Neighbour> neighbours_;  // robots ahead of the camera within the largest range
};

}  // namespace regista::match
