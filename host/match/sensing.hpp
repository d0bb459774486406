// SPDX-License-Identifier: MIT
// What one robot's body measures and its camera sees, made from the truth at the instant of a decision: a sector with
// ranges, occlusion by robots in between, misses, noise, false balls, odometry that drifts.
//
// Sightings are sorted by measured distance, so that their order tells nothing about who or which they are.
// Objects are numbered for the streams of chance: robots by id, landmarks by their place in the list, the ball 0.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "config/disturbance.hpp"
#include "config/robot.hpp"
#include "config/rules.hpp"
#include "match/arena.hpp"
#include "match/noise.hpp"
#include "match/sector.hpp"
#include "match/side.hpp"
#include "mind/percepts.hpp"

namespace regista::match {

// The landmarks of a field with the squared range and the probability with which one camera recognises each.
struct Marks {
  Marks(const config::FieldSize& field, const config::Camera& camera);
  Points points;
  std::array<int, most_points> kind;  // REGISTA_LANDMARK_*
  std::array<float, most_points> squared_range;
  std::array<double, most_points> probability;
};

class Sensing {
 public:
  // Profiles and marks are the caller's and must live as long. robot_radius: that hides what is behind.
  Sensing(const config::Robot& profile, const config::Disturbance& disturbance, const Marks& marks, Roster roster,
          int id, std::uint64_t seed, double robot_radius);

  // The robot has been put down at `world`; `direction`: the way its side attacks. Told with the next percepts.
  void put_down(const mind::Pose& world, double direction, std::uint32_t tick);

  // The head begins to turn to this yaw, rad.
  void look(double yaw);

  struct Truth {
    BodyState own;
    Vector ball;
    const Points& robots;  // by id; those out of play are nowhere
  };
  // Fills odometry, placed, camera, view, balls, robots and landmarks of `out`. able: it can see (stands, in play).
  void sense(const Truth& truth, double time, std::uint32_t tick, bool able, mind::Percepts& out);

 private:
  // Offsets in the world frame. One ball, the other robots and the marks always fit.
  struct Candidates {
    std::array<Draw, most_draws> draws;
    std::array<float, most_draws> x, y;
    std::array<double, most_draws> probability;
    std::size_t count = 0;
    void add(Purpose purpose, std::size_t object, float offset_x, float offset_y, double seen);
  };
  void measure_motion(const BodyState& own, std::uint32_t tick, mind::Percepts& out);
  void turn_head(double time);
  void find_candidates(const Truth& truth);
  void see(const Truth& truth, std::uint32_t tick, mind::Percepts& out);
  bool blinded(std::uint32_t tick) const;
  void imagine_ball(std::uint32_t tick, mind::Percepts& out) const;

  const config::Robot& profile_;
  const config::Disturbance& disturbance_;
  const Marks& marks_;
  Roster roster_;
  std::uint64_t seed_;
  Side side_;
  int number_;
  float squared_radius_, squared_ball_range_;
  std::array<float, most_points> squared_robot_range_;
  double scale_ = 1.0;  // of this robot's odometry in this match

  Vector last_position_;
  double last_heading_ = 0.0, last_cosine_ = 1.0, last_sine_ = 0.0;
  std::optional<mind::PlacedPose> placed_;
  bool lifted_ = true;  // put down since the last decision: no odometry

  double head_ = 0.0, wanted_head_ = 0.0, head_time_ = 0.0;
  double head_cosine_ = 1.0, head_sine_ = 0.0;
  // Of the present instant:
  Sector sector_;
  Offsets robots_;
  Candidates candidates_;
};

}  // namespace regista::match
