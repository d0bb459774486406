// SPDX-License-Identifier: MIT
// Sensing simulates what one robot measures and sees at a decision, from the truth at that moment. The camera sees a
// sector up to a range for each kind of object; robots hide objects; the camera misses objects, adds noise and sees
// false balls. The odometry drifts. Disturbances (see disturbances.hpp) act as follows:
// - Pose bias: the robot sees landmarks as from the biased pose. Percepts::placed first gives the biased pose, so the
//   robot's localisation adopts this pose in one step. At the end of the bias Percepts::placed gives the true pose.
// - Mirror flip: Percepts::placed once gives the true pose rotated by half a turn about the field's centre. Landmarks
//   look the same from the two poses. The robot gets its true pose at the end of the flip, or when it is put down.
// - Ghost ball: the camera sees or misses a ghost ball like a real ball. Blind camera: the camera recognises nothing.
//
// Sightings are sorted by measured distance, so that their order does not identify robots or landmarks. In the names of
// random streams, `object` is a robot's id, the index of a landmark or ghost ball, or 0 for the ball.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "config/robot.hpp"
#include "config/rules.hpp"
#include "match/chance.hpp"
#include "match/disturbances.hpp"
#include "match/physics_world.hpp"
#include "match/side.hpp"
#include "mind/percepts.hpp"

namespace regista::match {

// The landmarks of a field, with the squared range and the probability at which one camera recognises each landmark.
struct Marks {
  Marks(const config::FieldSize& field, const config::Camera& camera);
  Points points;
  std::array<int, most_points> kind;  // REGISTA_LANDMARK_*
  std::array<float, most_points> squared_range;
  std::array<double, most_points> probability;
};

class Sensing {
 public:
  // The caller owns the first three arguments, which must outlive this. robot_radius: of robots that hide objects, m.
  Sensing(const config::Robot& profile, const Disturbances& trouble, const Marks& marks, Roster roster, int id,
          std::uint64_t seed, double robot_radius);

  // A person has put the robot down at `world`, which the next percepts contain. direction: attack direction, +1 or -1.
  void put_down(const mind::Pose& world, double direction, std::uint32_t tick);

  void look(double yaw);  // The head begins to turn to `yaw` (rad, relative to the body).

  struct Truth {
    BodyState own;
    Vector ball;
    const Points& robots;  // by id; robots out of play have the coordinate `nowhere`
  };
  // Fills odometry, placed, camera, view, balls, robots, landmarks of `out`. able: the robot stands and is in play.
  void sense(const Truth& truth, double time, std::uint32_t tick, bool able, mind::Percepts& out);

 private:
  // Objects that the camera may see: ball, ghost balls, robots, landmarks. x, y: offset from the robot, world frame.
  struct Candidates {
    std::array<Draw, most_draws> draws;
    std::array<float, most_draws> x, y;
    std::array<double, most_draws> probability;
    std::size_t count = 0;
    void add(Purpose purpose, std::size_t object, float offset_x, float offset_y, double seen);
  };
  void tell_pose(const mind::Pose& world, Purpose purpose, std::uint32_t tick);
  void be_misled(const BodyState& own, std::uint32_t tick);
  void measure_motion(const BodyState& own, std::uint32_t tick, mind::Percepts& out);
  void turn_head(double time);
  const Points& landmarks(const BodyState& own);
  void find_candidates(const Truth& truth);
  void see_ball(Purpose purpose, std::size_t object, Vector ball);
  void see(const Truth& truth, std::uint32_t tick, mind::Percepts& out);
  bool blinded(std::uint32_t tick) const;
  void imagine_ball(std::uint32_t tick, mind::Percepts& out) const;  // adds a false ball

  const config::Robot& profile_;
  const Disturbances& trouble_;
  const Marks& marks_;
  Roster roster_;
  std::uint64_t seed_;
  Side side_;
  int number_;
  float squared_radius_, squared_ball_range_;
  std::array<float, most_points> squared_robot_range_;
  double scale_ = 1.0;  // distance factor of this robot's odometry in this match

  Vector last_position_;
  double last_heading_ = 0.0, last_cosine_ = 1.0, last_sine_ = 0.0;
  std::optional<mind::PlacedPose> placed_;
  bool lifted_ = true;      // a person has put the robot down since the last decision; the next odometry is zero
  double direction_ = 1.0;  // +1 or -1, attack direction of the robot's side
  // State at the last decision:
  mind::Pose bias_;
  int flips_ = 0;
  bool mirrored_ = false;   // a mirror flip is in force
  bool biased_ = false;     // a pose bias is in force
  Points misplaced_marks_;  // landmarks as seen with the pose bias

  double head_ = 0.0, wanted_head_ = 0.0, head_time_ = 0.0;  // yaw, wanted yaw (rad); time of the last update, s
  double head_cosine_ = 1.0, head_sine_ = 0.0;
  // State at the current decision:
  Sector sector_;
  Offsets robots_;
  Candidates candidates_;
};

}  // namespace regista::match
