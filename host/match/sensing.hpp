// SPDX-License-Identifier: MIT
// What one robot's body measures and its camera sees, made from the truth at the instant of a decision: a sector with
// ranges, occlusion by robots in between, misses, noise, false balls, odometry that drifts; and what its troubles make
// of that (see trouble.hpp):
// - Pose bias: landmarks are seen from the biased pose, and the robot is told that it stands there as if it had been
// put
//   down by hand, so that its localisation settles there at once. Told again when the bias ends.
// - Mirror flip: told once that it stands at the pose turned by half a turn around the centre. Landmarks stay as they
//   are, for the field looks the same from there. Who is put down by hand knows better; else it is told at the end.
// - Ghost balls are seen, missed and hidden like the ball. A blind camera gives images in which nothing is recognised.
//
// Sightings are sorted by measured distance, so that their order tells nothing about who or which they are.
// Objects are numbered for the streams of chance: robots by id, landmarks by their place in the list, the ball 0.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "config/robot.hpp"
#include "config/rules.hpp"
#include "match/arena.hpp"
#include "match/noise.hpp"
#include "match/sector.hpp"
#include "match/side.hpp"
#include "match/trouble.hpp"
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
  // Profile, trouble of its side and marks are the caller's and must live as long. robot_radius: that hides what is
  // behind.
  Sensing(const config::Robot& profile, const Trouble& trouble, const Marks& marks, Roster roster, int id,
          std::uint64_t seed, double robot_radius);

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
  void tell_pose(const mind::Pose& world, Purpose purpose, std::uint32_t tick);
  void be_misled(const BodyState& own, std::uint32_t tick);
  void measure_motion(const BodyState& own, std::uint32_t tick, mind::Percepts& out);
  void turn_head(double time);
  const Points& landmarks(const BodyState& own);
  void find_candidates(const Truth& truth);
  void see_ball(Purpose purpose, std::size_t object, Vector ball);
  void see(const Truth& truth, std::uint32_t tick, mind::Percepts& out);
  bool blinded(std::uint32_t tick) const;
  void imagine_ball(std::uint32_t tick, mind::Percepts& out) const;

  const config::Robot& profile_;
  const Trouble& trouble_;
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
  bool lifted_ = true;      // put down since the last decision: no odometry
  double direction_ = 1.0;  // the way its side attacks
  // As they were at the last decision:
  mind::Pose bias_;
  int flips_ = 0;
  bool mirrored_ = false;  // by a flip, since when nobody has put it down
  bool biased_ = false;
  Points misplaced_marks_;

  double head_ = 0.0, wanted_head_ = 0.0, head_time_ = 0.0;
  double head_cosine_ = 1.0, head_sine_ = 0.0;
  // Of the present instant:
  Sector sector_;
  Offsets robots_;
  Candidates candidates_;
};

}  // namespace regista::match
