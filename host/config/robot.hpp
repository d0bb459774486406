// SPDX-License-Identifier: MIT
// The robot profile: body, walk, kicks, camera, odometry, radio of one type of robot. SI units, radians in memory
// (degrees in YAML, where a person reads them, in keys that end in _deg). Sources: configs/robots/nao.yaml.
#pragma once

#include <numbers>
#include <string>
#include <vector>

namespace regista::config {

inline constexpr double radians_per_degree = std::numbers::pi / 180.0;

// The match advances by this, so every robot decides after a whole number of it. s
inline constexpr double physics_step = 0.02;

struct Walk {
  double forward = 0.25, sideways = 0.18, backward = 0.20;  // m/s
  double turn = 90.0 * radians_per_degree;                  // rad/s
  double acceleration = 0.5;                                // m/s^2
  double turn_acceleration = 340.0 * radians_per_degree;    // rad/s^2
  double step_period = 0.25;                                // a new command takes effect at the next step
};

// One kind of kick. The ball leaves `impact` s after the beginning, and the robot stands until `duration` is over.
struct Kick {
  std::string name;
  double minimum_distance = 1.6, maximum_distance = 4.5;  // that the ball rolls, m
  double duration = 1.6, impact = 0.65;                   // s
  double distance_noise = 0.07;                           // half width of a triangular law, relative
  double direction_noise = 7.0 * radians_per_degree;      // standard deviation, rad
};

struct Body {
  double radius = 0.15;                            // torso against torso
  double mass = 5.4;                               // kg
  double reach = 0.22;                             // centre to ball centre within which it can kick, m
  double reach_angle = 60.0 * radians_per_degree;  // to either side of the heading, within which it can kick, rad
  double get_up = 5.0;                             // s
  double get_up_failure = 0.1;                     // probability that an attempt fails and another follows; assumption
  double falls_per_contact_second = 0.02;          // assumption: no published rate
  double falls_per_walking_minute = 0.05;          // without anybody's help; assumption: no published rate
  double contact_felt = 0.8;                       // probability per decision that it feels a robot in contact
};

struct Camera {
  double half_angle = 27.35 * radians_per_degree;  // of the horizontal field of view, rad
  double head_yaw = 90.0 * radians_per_degree;     // head turns up to this to either side, rad
  double head_speed = 115.0 * radians_per_degree;  // rad/s
  double ball_range = 5.0, ball_probability = 0.9;
  double robot_range = 4.0, robot_probability = 0.6;
  double landmark_range = 8.0, landmark_probability = 0.9;  // goal posts; lines: line_range
  double line_range = 3.0, line_probability = 0.6;
  double false_balls_per_frame = 0.0005;
  double distance_noise = 0.05;                      // standard deviation, relative to the distance
  double bearing_noise = 1.15 * radians_per_degree;  // standard deviation, rad
};

struct Odometry {
  double distance_noise = 0.05;  // relative standard deviation of the distance walked, per step of decision
  double turn_noise = 0.05;      // relative standard deviation of the angle turned
  double scale_bias = 0.03;      // standard deviation of a scale error drawn once per robot and match
  double placing_noise = 0.05;   // m: how well a robot knows where it was put down
  double placing_turn_noise = 3.0 * radians_per_degree;  // rad
};

struct Radio {
  double delay = 0.05, jitter = 0.05;  // s: fixed part, and width of a uniform law on top
  double loss = 0.0;                   // probability per packet and receiver
};

struct Hearing {
  double whistle_probability = 0.9;
};

struct Robot {
  std::string name = "nao";
  Body body;
  Walk walk;
  // At least one; these where a profile says nothing.
  std::vector<Kick> kicks{{.name = "fast"}, {"long", 5.4, 5.4, 1.65, 0.65}, {"in_walk", 0.4, 1.0, 0.5, 0.25}};
  Camera camera;
  Odometry odometry;
  Radio radio;
  Hearing hearing;
  double decision_period = 0.1;  // s
};

}  // namespace regista::config
