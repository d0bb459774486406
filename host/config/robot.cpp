// SPDX-License-Identifier: MIT
#include "config/robot.hpp"

#include "config/profiles.hpp"

namespace regista::config {

static Map declare(Body& body) {
  return {{
      real("radius", body.radius, {0.02, 2}, "m", "torso against torso"),
      real("mass", body.mass, {0.1, 500}, "kg", "of the robot"),
      real("reach", body.reach, {0.02, 3}, "m", "centre of the robot to centre of the ball, to kick it"),
      degrees("reach_angle_deg", body.reach_angle, {1, 180}, "deg", "to either side of the heading, to kick the ball"),
      real("get_up", body.get_up, {0, 120}, "s", "an attempt to get up from the ground"),
      real("get_up_failure", body.get_up_failure, {0, 0.95}, "1", "probability that an attempt fails; another follows"),
      real("contact_felt", body.contact_felt, {0, 1}, "1", "probability per decision that it feels a robot in contact"),
      real("falls_per_contact_second", body.falls_per_contact_second, {0, 10}, "1/s", "rate while pushed"),
      real("falls_per_walking_minute", body.falls_per_walking_minute, {0, 60}, "1/min",
           "rate while walking, without anybody's help"),
  }};
}

static Map declare(Walk& walk) {
  return {{
      real("forward", walk.forward, {0.01, 10}, "m/s", "fastest"),
      real("sideways", walk.sideways, {0, 10}, "m/s", "fastest"),
      real("backward", walk.backward, {0, 10}, "m/s", "fastest"),
      degrees("turn_deg", walk.turn, {1, 3600}, "deg/s", "fastest"),
      real("acceleration", walk.acceleration, {0.01, 100}, "m/s^2", "largest"),
      degrees("turn_acceleration_deg", walk.turn_acceleration, {1, 100000}, "deg/s^2", "largest"),
      real("step_period", walk.step_period, {0.02, 5}, "s", "a new command takes effect at the next step"),
  }};
}

static Map declare(Kick& kick) {
  return {{
      required(name("name", kick.name, "of the kick")),
      real("minimum_distance", kick.minimum_distance, {0.01, 100}, "m", "that the ball rolls"),
      real("maximum_distance", kick.maximum_distance, {0.01, 100}, "m", "that the ball rolls"),
      real("duration", kick.duration, {0, 30}, "s", "the robot stands"),
      real("impact", kick.impact, {0, 30}, "s", "from the beginning until the ball leaves"),
      real("distance_noise", kick.distance_noise, {0, 1}, "1", "half width of a triangular law, relative"),
      degrees("direction_noise_deg", kick.direction_noise, {0, 180}, "deg", "standard deviation"),
  }};
}

static Map declare(Camera& camera) {
  return {{
      degrees("half_angle_deg", camera.half_angle, {1, 180}, "deg", "half of the horizontal field of view"),
      degrees("head_yaw_deg", camera.head_yaw, {0, 180}, "deg", "the head turns up to this to either side"),
      degrees("head_speed_deg", camera.head_speed, {0, 3600}, "deg/s", "of the head"),
      real("ball_range", camera.ball_range, {0, 200}, "m", "farthest ball that is seen"),
      real("ball_probability", camera.ball_probability, {0, 1}, "1", "per frame, in range and in view"),
      real("robot_range", camera.robot_range, {0, 200}, "m", "farthest robot that is seen"),
      real("robot_probability", camera.robot_probability, {0, 1}, "1", "per frame, in range and in view"),
      real("landmark_range", camera.landmark_range, {0, 200}, "m", "farthest goal post that is seen"),
      real("landmark_probability", camera.landmark_probability, {0, 1}, "1", "per frame, in range and in view"),
      real("line_range", camera.line_range, {0, 200}, "m", "farthest line that is seen"),
      real("line_probability", camera.line_probability, {0, 1}, "1", "per frame, in range and in view"),
      real("false_balls_per_frame", camera.false_balls_per_frame, {0, 1}, "1", "balls that are not there"),
      real("distance_noise", camera.distance_noise, {0, 1}, "1", "standard deviation, relative to the distance"),
      degrees("bearing_noise_deg", camera.bearing_noise, {0, 180}, "deg", "standard deviation"),
  }};
}

static Map declare(Odometry& odometry) {
  return {{
      real("distance_noise", odometry.distance_noise, {0, 1}, "1", "relative, of the way walked between decisions"),
      real("turn_noise", odometry.turn_noise, {0, 1}, "1", "relative, of the angle turned between decisions"),
      real("scale_bias", odometry.scale_bias, {0, 1}, "1", "of a scale error drawn once per robot and match"),
      real("placing_noise", odometry.placing_noise, {0, 10}, "m", "how well it knows where it was put down"),
      degrees("placing_turn_noise_deg", odometry.placing_turn_noise, {0, 180}, "deg", "the same for its direction"),
  }};
}

static Map declare(Radio& radio) {
  return {{
      real("delay", radio.delay, {0, 60}, "s", "least delay of a packet"),
      real("jitter", radio.jitter, {0, 60}, "s", "width of a uniform law on top"),
      real("loss", radio.loss, {0, 1}, "1", "probability per packet and receiver"),
  }};
}

static Map declare(Hearing& hearing) {
  return {{
      real("whistle_probability", hearing.whistle_probability, {0, 1}, "1", "per robot and whistle"),
  }};
}

Map declare(Robot& robot) {
  return {{
      required(name("robot", robot.name, "name of this type of robot")),
      section("body", robot.body, "what bumps into others"),
      section("walk", robot.walk, "how it moves"),
      list("kicks", robot.kicks, 1, 16, "kinds of kick it can choose from"),
      section("camera", robot.camera, "what it sees"),
      section("odometry", robot.odometry, "how well it knows its own way; standard deviations"),
      section("radio", robot.radio, "how packets travel"),
      section("hearing", robot.hearing, "what it hears"),
      real("decision_period", robot.decision_period, {0.02, 2}, "s", "between two decisions of a robot"),
  }};
}

}  // namespace regista::config
