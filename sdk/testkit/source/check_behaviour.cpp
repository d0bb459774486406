// SPDX-License-Identifier: MIT
// Bodies in every state, in every state of the game, and what an action must be like.
#include <regista/testkit/kind_checks.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <regista/behaviour.hpp>
#include <regista/testkit/scenario.hpp>
#include <regista/testkit/scenes.hpp>

namespace regista::testkit {

namespace {

constexpr double pi = std::numbers::pi;
constexpr std::size_t body_variants = 12;

// The own body in a scene. task: whether it has one, where there are any.
BodyBuilder body_for(const Scene& scene, std::size_t variant, bool task) {
  const SceneData& data = scene.data();
  const regista_robot& self = data.mine.robots[static_cast<std::size_t>(data.own_number - 1)];
  const regista_ball& ball = data.mine.ball;
  BodyBuilder body;
  body.at(self.pose[0], self.pose[1]).heading(self.pose[2]).head_yaw(0.3).moved(0.02, 0.0, -0.05);
  if (task && !data.tasks.empty()) body.task(static_cast<int>(data.tick % data.tasks.size()));
  // So near to the ball that it can kick, and looking where it would.
  const auto at_ball = [&](double from, double off) -> BodyBuilder& {
    const double ahead = std::atan2(-ball.position[1], 4.5 - ball.position[0]) + from;
    body.at(ball.position[0] - 0.2 * std::cos(ahead), ball.position[1] - 0.2 * std::sin(ahead));
    return body.heading(std::remainder(ahead + off, 2.0 * pi)).sees_ball();
  };
  switch (variant) {
    case 0:
      return body.sees_ball();
    case 1:
      return body;
    case 2:
      return body.ball_refuted();
    case 3:
      return body.fallen(3.0);
    case 4:
      return body.penalised();
    case 5:
      return body.sees_ball().kicking();
    case 6:
      return body.touched(-2.0).robot_near(self.pose[0] + 0.3, self.pose[1]);
    case 7:
      for (int k = 0; k < 12; ++k) {
        const double angle = 0.5 * k;
        body.robot_near(self.pose[0] + 0.4 * std::cos(angle), self.pose[1] + 0.4 * std::sin(angle));
      }
      return body.sees_ball();
    case 8:
      return at_ball(0.0, 0.0);
    case 9:
      return at_ball(-0.4, 0.1);
    case 10:
      return at_ball(pi, pi);
    default:
      return body.at(ball.position[0], ball.position[1]).heading(pi).sees_ball();
  }
}

void check_kick(const regista_action& action, const std::vector<regista_kick>& kicks, Findings& findings) {
  if (action.kick == REGISTA_NO_KICK) return;
  if (action.kick < 0 || action.kick >= static_cast<std::int32_t>(kicks.size())) {
    return findings.say("act: kick ", action.kick, " of ", kicks.size());
  }
  const regista_kick& kick = kicks[static_cast<std::size_t>(action.kick)];
  constexpr double rounding = 1e-9;
  if (!(action.kick_distance >= kick.minimum_distance - rounding &&
        action.kick_distance <= kick.maximum_distance + rounding)) {
    findings.say("act: the distance of a kick is ", action.kick_distance, ", outside of that of \"", kick.name, "\", [",
                 kick.minimum_distance, ", ", kick.maximum_distance, "]");
  }
  if (!(std::abs(action.kick_direction) <= pi)) {
    findings.say("act: the direction of a kick is ", action.kick_direction, ", outside [-pi, pi]");
  }
}

void check_action(const regista_action& action, const std::vector<regista_kick>& kicks, Findings& findings) {
  const auto finite = [](std::span<const double> values) {
    return std::all_of(values.begin(), values.end(), [](double value) { return std::isfinite(value); });
  };
  if (action.motion < REGISTA_MOTION_STAND || action.motion > REGISTA_MOTION_WALK_TO) {
    findings.say("act: the motion ", action.motion, " does not exist");
  }
  if ((action.walk & ~std::uint32_t{REGISTA_WALK_BRISK | REGISTA_WALK_STRAIGHT | REGISTA_WALK_CREEP}) != 0) {
    findings.say("act: the walk ", action.walk, " has flags that do not exist");
  }
  if ((action.flags & ~std::uint32_t{REGISTA_ACTION_TARGET}) != 0) {
    findings.say("act: the flags ", action.flags, " do not all exist");
  }
  if (!finite(action.velocity)) findings.say("act: a velocity is not finite");
  constexpr double far = 1e4;  // m
  if (!finite(action.pose) || std::abs(action.pose[0]) > far || std::abs(action.pose[1]) > far) {
    findings.say("act: the pose (", action.pose[0], ", ", action.pose[1], ", ", action.pose[2], ") is nowhere");
  }
  if (!(std::abs(action.gaze) <= pi)) findings.say("act: the gaze is ", action.gaze, ", outside [-pi, pi]");
  check_kick(action, kicks, findings);
  if ((action.flags & REGISTA_ACTION_TARGET) != 0 && !finite(action.target)) {
    findings.say("act: the target is not finite");
  }
  if (action.avoid_count > REGISTA_MOST_AVOIDED) {
    return findings.say("act: avoids ", action.avoid_count, " discs of at most ", REGISTA_MOST_AVOIDED);
  }
  for (std::uint32_t i = 0; i < action.avoid_count; ++i) {
    const regista_disc& disc = action.avoid[i];
    if (!std::isfinite(disc.x) || !std::isfinite(disc.y) || !(disc.radius >= 0.0) || !std::isfinite(disc.radius)) {
      findings.say("act: avoids no disc at (", disc.x, ", ", disc.y, ") of radius ", disc.radius);
    }
  }
}

// A scene, and who acts in it.
struct ScenesWithBodies {
  std::vector<Scene> scenes;
  std::vector<BodyBuilder> bodies;

  void add(SceneData data, std::size_t variant, bool task) {
    data.tick = scenes.size();
    data.time = 0.1 * static_cast<double>(data.tick);
    if (data.tick % 3 == 0) {
      for (regista_task& each : data.tasks) each.flags |= REGISTA_TASK_ALONG_EDGES;
    }
    scenes.emplace_back(std::move(data));
    bodies.push_back(body_for(scenes.back(), variant, task));
  }
};

// Every scene with and without a task and, by turns, every body; then every state of the game.
ScenesWithBodies scenario_for(int team_size, std::uint64_t seed) {
  ScenesWithBodies out;
  const std::vector<Scene> usual = scenes(team_size, seed);
  std::size_t turn = 0;
  for (const Scene& scene : usual) {
    out.add(scene.data(), 0, true);
    out.add(scene.data(), 1, false);
    out.add(scene.data(), turn++ % body_variants, true);
  }
  for (std::size_t variant = 0; variant < body_variants; ++variant) out.add(usual.front().data(), variant, true);
  for (int phase = REGISTA_PHASE_INITIAL; phase <= REGISTA_PHASE_FINISHED; ++phase) {
    for (int play = REGISTA_SET_PLAY_NONE; play <= REGISTA_SET_PLAY_PENALTY_KICK; ++play) {
      for (const int own : {0, 1}) {
        SceneData data = usual.front().data();
        for (regista_game* game : {&data.mine.game, &data.common.game}) {
          game->phase = phase;
          game->set_play = play;
          game->own_kick = own;
        }
        out.add(data, 0, true);
        out.add(std::move(data), turn++ % body_variants, own == 0);
      }
    }
  }
  return out;
}

Scenario scenario_with(int team_size, std::uint64_t seed, const EnvironmentBuilder& environment) {
  ScenesWithBodies scenario = scenario_for(team_size, seed);
  std::vector<regista_kick> kicks;
  const Setting setting = environment.build();
  for (const Kick& kick : setting.environment().kicks()) kicks.push_back(kick);
  // `setting` is kept for the kicks' names.
  const auto play = [bodies = std::move(scenario.bodies), kicks, setting](
                        Instance& instance, const Scene& scene, std::size_t i, Findings& findings, Trail& trail) {
    const regista_action action = instance.act(scene, bodies[i]);
    trail.add_all(std::vector<regista_action>{action});
    check_action(action, kicks, findings);
  };
  Scenario out = scenario_of_scenes(team_size, "act", scenario.scenes, play);
  out.environment = environment;
  return out;
}

}  // namespace

std::vector<Scenario> behaviour_scenarios(const Options& options) {
  std::vector<Scenario> out;
  const auto robot_of = [](int size) {
    return EnvironmentBuilder{}.team_size(static_cast<unsigned>(size)).own(own_number(size));
  };
  for (const int size : team_sizes) out.push_back(scenario_with(size, options.seed, robot_of(size)));
  constexpr int few = team_sizes[0];
  out.push_back(scenario_with(few, options.seed, robot_of(few).no_kicks()));
  out.push_back(scenario_with(few, options.seed, robot_of(few).no_kicks().kick("weak", 0.05, 0.1, 0.5, 0.25)));
  return out;
}

}  // namespace regista::testkit
