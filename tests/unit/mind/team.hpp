// SPDX-License-Identifier: MIT
// A team of stub plugins for tests, and percepts for it.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "in_process.hpp"
#include "mind/mind.hpp"
#include "mind/team_plan.hpp"
#include "plugins/stubs.hpp"

namespace regista::mind {

inline config::PluginUse use(std::string id, std::vector<std::pair<std::string, std::string>> parameters = {}) {
  std::vector<config::Node::Entry> entries;
  for (auto& [key, value] : parameters) {
    entries.push_back({std::move(key), {}, config::Node::scalar(std::move(value), false, {})});
  }
  return {std::move(id), "", entries.empty() ? config::Node{} : config::Node::map(std::move(entries), {}), {}};
}

inline config::Place place(config::Anchor anchor) { return {anchor, {}}; }
inline config::Place place(double x, double y) { return {config::Anchor::point, {x, y}}; }

inline config::Role role(std::string name, config::Place at) {
  config::Role out;
  out.name = std::move(name);
  out.target.at = at;
  out.behaviour = "walks";
  return out;
}

// Ten roles for seven robots: a goalkeeper bound to robot 1, a striker that is required, and eight places.
inline config::RoleList playing() {
  config::RoleList list{"playing", {}};
  list.roles.push_back(role("goalkeeper", place(-4.0, 0.0)));
  list.roles.back().robots = {1};
  list.roles.push_back(role("striker", place(config::Anchor::ball)));
  list.roles.back().required = true;
  for (int i = 0; i < 8; ++i) {
    list.roles.push_back(role("place_" + std::to_string(i), place(i - 3.5, i % 2 == 0 ? 1.5 : -1.5)));
  }
  return list;
}

inline config::Context context(std::string name, std::vector<std::pair<std::string, std::string>> window = {}) {
  config::Context out;
  out.name = std::move(name);
  out.use = use("window", std::move(window));
  out.positioner = use("triangle");
  out.terms.push_back({"nearness", use("nearness"), 0.7, {}});
  out.terms.push_back({"gossip", use("gossip"), 0.0, {}});
  out.assigner = use("in_order");
  out.sender = use("steady");
  return out;
}

inline config::Team team() {
  config::Team out;
  out.name = "stubs";
  out.behaviour_without_role = "walks";
  out.self = out.ball = out.opponents = out.teammates = use("still");
  out.role_lists.push_back(playing());
  out.contexts.push_back(context("playing"));
  return out;
}

inline const plugin::Catalogue& stub_catalogue() {
  static const plugin::Catalogue catalogue({MIND_STUBS});
  return catalogue;
}

inline std::unique_ptr<TeamPlan> plan_of(config::Team team, config::Rules rules = {}, config::Robot robot = {}) {
  return std::make_unique<TeamPlan>(std::move(team), std::move(rules), std::move(robot), stub_catalogue());
}

// Percepts of a robot in play at `time` of the match.
inline Percepts percepts(double time, Phase phase = Phase::playing) {
  Percepts out;
  out.time = time;
  out.game.phase = phase;
  out.game.phase_time = 5.0;
  out.game.half_time_left = 600.0;
  out.game.match_time_left = 1200.0 - time;
  out.game.packets_left = 1200;
  return out;
}

inline PlacedPose placed(double x, double y, double heading = 0.0) { return {{x, y, heading}, 0.05, 0.05}; }

// A world model of robot `number` whose predictors are the stubs.
inline std::unique_ptr<WorldModel> world_model(const TeamPlan& plan, int number, FrameParts made = {}) {
  const auto still = [&](unsigned subject) {
    return plugin::Predictor(in_process<stubs::Still, predictor>(plan.environment(number, subject)));
  };
  std::vector<plugin::Predictor> balls, opponents;
  for (int i = 0; i < plan.rules().team_size; ++i) {
    balls.push_back(still(REGISTA_SUBJECT_BALL));
    opponents.push_back(still(REGISTA_SUBJECT_OPPONENTS));
  }
  return std::make_unique<WorldModel>(
      plan, number,
      LocalModel(plan, still(REGISTA_SUBJECT_SELF), still(REGISTA_SUBJECT_BALL), still(REGISTA_SUBJECT_OPPONENTS),
                 still(REGISTA_SUBJECT_OPPONENTS)),
      TeamModel(plan.rules().team_size, plan.robot().camera, still(REGISTA_SUBJECT_TEAMMATES), std::move(balls),
                std::move(opponents)),
      made);
}

inline Report report(int sender, double time, double x = 0.0, double y = 0.0) {
  Report out;
  out.sender = sender;
  out.time_sent = time;
  out.pose = {x, y, 0.0};
  out.target = {x, y};
  out.position_deviation = 0.1;
  return out;
}

}  // namespace regista::mind
