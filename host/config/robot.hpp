// SPDX-License-Identifier: MIT
// The robot profile: body, walk, kicks, camera, odometry, radio of one type of robot. SI units, radians in memory
// (degrees in YAML, in keys that end in _deg). The comments of configs/robots/nao.yaml name the sources of the values.
#pragma once

#include <numbers>
#include <string>
#include <vector>

#include "config/rules.hpp"

namespace regista::config {

inline constexpr double radians_per_degree = std::numbers::pi / 180.0;

// Step of the match simulation, s. The decision period of every robot is a whole number of steps.
inline constexpr double physics_step = 0.02;

struct Walk {
  double forward = 0.25, sideways = 0.18, backward = 0.20;  // m/s
  double turn = 90.0 * radians_per_degree;                  // rad/s
  double acceleration = 0.5;                                // m/s^2
  double turn_acceleration = 340.0 * radians_per_degree;    // rad/s^2
  double step_period = 0.25;                                // s; a new command takes effect at the next step
};

// A kind of kick. The ball leaves `impact` s after the kick begins. The robot stands still for `duration` s.
struct Kick {
  std::string name;
  double minimum_distance = 1.6, maximum_distance = 4.5;  // rolling distance of the ball, m
  double duration = 1.6, impact = 0.65;                   // s
  double distance_noise = 0.07;                           // half width of a triangular distribution, relative
  double direction_noise = 7.0 * radians_per_degree;      // standard deviation, rad
};

struct Body {
  double radius = 0.15;                            // m; two torsos touch at the sum of their radii
  double mass = 5.4;                               // kg
  double reach = 0.22;                             // largest distance for a kick, from robot centre to ball centre, m
  double reach_angle = 60.0 * radians_per_degree;  // largest angle for a kick, to either side of the heading, rad
  double get_up = 5.0;                             // s for one attempt to get up
  double get_up_failure = 0.1;  // probability that an attempt to get up fails; then another attempt follows; assumption
  double falls_per_contact_second = 0.02;  // falls per second while pushed; assumption: no published rate
  double falls_per_walking_minute = 0.05;  // falls per minute of walking without contact; assumption: no published rate
  double contact_felt = 0.8;               // probability that a robot in contact notices the contact, per decision
};

struct Camera {
  double half_angle = 27.35 * radians_per_degree;           // half of the horizontal field of view, rad
  double head_yaw = 90.0 * radians_per_degree;              // largest turn of the head to either side, rad
  double head_speed = 115.0 * radians_per_degree;           // rad/s
  double ball_range = 5.0, ball_probability = 0.9;          // range, m; probability of detection per frame
  double robot_range = 4.0, robot_probability = 0.6;        // range, m; probability of detection per frame
  double landmark_range = 8.0, landmark_probability = 0.9;  // goal posts are landmarks; lines have line_range
  double line_range = 3.0, line_probability = 0.6;
  double false_balls_per_frame = 0.0005;
  double distance_noise = 0.05;                      // standard deviation of a measured distance, relative to it
  double bearing_noise = 1.15 * radians_per_degree;  // standard deviation of a measured bearing, rad
};

struct Odometry {
  double distance_noise = 0.05;  // relative standard deviation of the walked distance, per decision period
  double turn_noise = 0.05;      // relative standard deviation of the turned angle, per decision period
  double scale_bias = 0.03;      // standard deviation of a scale error that is drawn once per robot and match
  double placing_noise = 0.05;   // standard deviation of a robot's known place after people have placed the robot, m
  double placing_turn_noise = 3.0 * radians_per_degree;  // standard deviation of the known heading after placement, rad
};

struct Radio {
  double delay = 0.05, jitter = 0.05;  // fixed delay, and width of a uniform distribution that is added, s
  double loss = 0.0;                   // probability that a receiver loses a packet
};

struct Hearing {
  double whistle_probability = 0.9;
};

struct Robot {
  std::string name = "nao";
  Body body;
  Walk walk;
  // At least one kick. A profile without the key `kicks` has these kicks.
  std::vector<Kick> kicks{{.name = "fast"}, {"long", 5.4, 5.4, 1.65, 0.65}, {"in_walk", 0.4, 1.0, 0.5, 0.25}};
  Camera camera;
  Odometry odometry;
  Radio radio;
  Hearing hearing;
  double decision_period = 0.1;  // s
};

Map declare(Robot& robot);

// Reports values of the document that contradict each other, with the reason.
void check(const Robot& robot, const Node& document, Mistakes& mistakes);

// Throws Error at the first value of the robot's document that contradicts the rules.
void check(const Robot& robot, const Rules& rules, const Node& document);

}  // namespace regista::config
