// SPDX-License-Identifier: MIT
// Measures two rows of docs/realism.md: where a kicked ball comes to rest that nothing touches, and how often a ball or
// a robot is recognised that is in the field of view and not hidden, by its distance.
//
//     build/release/bin/benchmark_senses
//
// Kicks: one robot and a lone ball on the field of the rules, body and physics as in a match, the default robot
// profile. Detection: all camera frames of a whole match between two shipped teams, beside the truth of the same
// instant; what is in view and hidden is judged here anew, from places alone.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "match/body.hpp"
#include "match/teams.hpp"
#include "teams.hpp"

namespace regista {
namespace {

using match::Vector;

constexpr double degrees = 180.0 / std::numbers::pi;

double mean(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

double deviation(const std::vector<double>& values) {
  const double middle = mean(values);
  double sum = 0.0;
  for (const double value : values) sum += (value - middle) * (value - middle);
  return std::sqrt(sum / static_cast<double>(values.size()));
}

// Where the ball lies when it has come to rest, from where it was kicked.
Vector kicked(int kind, double distance, std::uint64_t seed) {
  const config::Rules rules;
  const config::Robot robot;
  match::PhysicsWorld arena(rules.field, rules.ball, std::array{robot.body});
  match::Body body(robot, rules.ball.rolling_deceleration, seed, match::Side::home, 1);
  const Vector from{-0.5 * distance, 0.0};
  arena.place(0, {from.x - robot.body.reach, 0.0, 0.0});
  arena.place_ball(from);
  mind::Command command;
  command.kick = mind::KickRequest{kind, 0.0, distance};
  body.command(command, 0.0, robot.body.reach);
  for (std::uint32_t tick = 0; tick < 60u * match::physics_steps_per_second; ++tick) {
    const auto motion = body.move(tick * match::physics_step, tick, robot.body.reach);
    arena.drive(0, {}, 0.0, robot.walk.acceleration, robot.walk.turn_acceleration);
    if (motion.ball_velocity) arena.kick(*motion.ball_velocity);
    arena.step();
  }
  return arena.ball_position() - from;
}

void measure_kicks() {
  constexpr int kicks = 500;
  const config::Robot robot;
  for (std::size_t kind = 0; kind < robot.kicks.size(); ++kind) {
    const config::Kick& kick = robot.kicks[kind];
    for (const double asked : {kick.minimum_distance, kick.maximum_distance}) {
      std::vector<double> distances, directions;
      for (std::uint64_t seed = 1; seed <= kicks; ++seed) {
        const Vector way = kicked(static_cast<int>(kind), asked, seed);
        distances.push_back(match::length(way));
        directions.push_back(std::atan2(way.y, way.x));
      }
      std::ranges::sort(distances);
      fmt::print(
          "kick {:8s} asked {:.1f} m: rolls {:.2f} m (5 to 95 %: {:.2f} to {:.2f}), direction {:+.1f} +- {:.1f} deg\n",
          kick.name, asked, mean(distances), distances[kicks / 20], distances[kicks - kicks / 20],
          mean(directions) * degrees, deviation(directions) * degrees);
      if (kick.minimum_distance == kick.maximum_distance) break;
    }
  }
}

struct Share {
  long frames = 0, seen = 0;
};
constexpr std::size_t metres = 9;  // bins of one metre

class Detection {
 public:
  explicit Detection(const match::Setup& setup) : setup_(setup), roster_{setup.rules.team_size} {
    observer.step = [this](const match::Snapshot& now) {
      bodies_.assign(now.bodies.begin(), now.bodies.end());
      penalised_ = now.state.penalised;
    };
    observer.decision = [this](const match::Decision& decision) { look(decision); };
  }
  match::Observer observer;
  std::array<Share, metres> balls, robots;
  long frames = 0, false_balls = 0;

 private:
  bool gone(int id) const { return (penalised_[match::index(roster_.side(id))] >> (roster_.number(id) - 1) & 1u) != 0; }

  // Robot frame of `own`.
  static Vector from(const match::BodyState& own, const match::BodyState& other) {
    return match::turned({other.x - own.x, other.y - own.y}, own.cosine, -own.sine);
  }

  // Another robot's disc lies across the line of sight.
  bool hidden(int observer_id, int target, Vector way) const {
    const double distance = match::length(way), radius = setup_.robots[0].body.radius;
    for (int id = 0; id < roster_.count(); ++id) {
      if (id == observer_id || id == target || gone(id)) continue;
      const Vector other = from(bodies_[static_cast<std::size_t>(observer_id)], bodies_[static_cast<std::size_t>(id)]);
      const double along = (other.x * way.x + other.y * way.y) / distance;
      const double across = (other.x * way.y - other.y * way.x) / distance;
      if (along > 0.0 && along < distance && std::fabs(across) < radius) return true;
    }
    return false;
  }

  template <class List>
  static bool seen(const List& list, Vector way) {
    const double near = 0.2 + 0.25 * match::length(way);
    return std::ranges::any_of(list, [&](const auto& each) {
      return match::length(Vector{each.position.x(), each.position.y()} - way) < near;
    });
  }

  void count(std::array<Share, metres>& bins, Vector way, bool was_seen) {
    const auto bin = static_cast<std::size_t>(match::length(way));
    if (bin >= metres) return;
    ++bins[bin].frames;
    bins[bin].seen += was_seen ? 1 : 0;
  }

  void look(const match::Decision& decision) {
    const mind::Percepts& percepts = decision.percepts;
    if (!percepts.camera || bodies_.empty()) return;
    ++frames;
    const int own = roster_.id(decision.side, decision.number);
    for (int id = 0; id <= roster_.count(); ++id) {
      if (id == own || (id < roster_.count() && gone(id))) continue;
      const Vector way = from(bodies_[static_cast<std::size_t>(own)], bodies_[static_cast<std::size_t>(id)]);
      const double bearing = mind::wrap(std::atan2(way.y, way.x) - percepts.view.heading);
      if (std::fabs(bearing) > percepts.view.half_angle || hidden(own, id, way)) continue;
      if (id < roster_.count()) {
        count(robots, way, seen(percepts.robots, way));
      } else {
        count(balls, way, seen(percepts.balls, way));
      }
    }
    const Vector ball = from(bodies_[static_cast<std::size_t>(own)], bodies_.back());
    for (const mind::BallSighting& each : percepts.balls) {
      const Vector place{each.position.x(), each.position.y()};
      if (match::length(place - ball) > 0.2 + 0.25 * match::length(ball)) ++false_balls;
    }
  }

  const match::Setup& setup_;
  match::Roster roster_;
  std::vector<match::BodyState> bodies_;
  std::array<std::uint32_t, 2> penalised_{};
};

void print(const char* what, const std::array<Share, metres>& bins) {
  for (std::size_t i = 0; i < metres; ++i) {
    if (bins[i].frames == 0) continue;
    fmt::print("{} {} to {} m: seen in {:.3f} of {} frames\n", what, i, i + 1,
               static_cast<double>(bins[i].seen) / static_cast<double>(bins[i].frames), bins[i].frames);
  }
}

void measure_detection() {
  const Teams teams;
  Detection detection(teams.setup);
  match::play(teams.setup, {&teams.paper, &teams.fixed_rate}, &detection.observer);
  print("ball ", detection.balls);
  print("robot", detection.robots);
  fmt::print("false balls: {:.5f} a frame, of {} frames\n",
             static_cast<double>(detection.false_balls) / static_cast<double>(detection.frames), detection.frames);
}

}  // namespace
}  // namespace regista

int main() {
  regista::measure_kicks();
  regista::measure_detection();
}
