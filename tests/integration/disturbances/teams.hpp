// SPDX-License-Identifier: MIT
// Shipped teams for the tests of this folder, and what their robots believe of their own poses beside the truth.
#pragma once

#include <cmath>
#include <filesystem>
#include <functional>
#include <memory>
#include <numbers>
#include <string>
#include <vector>

#include "config/documents.hpp"
#include "match/teams.hpp"

namespace regista::shipped {

inline plugin::Catalogue& catalogue() {
  static plugin::Catalogue all(std::vector<std::filesystem::path>{REGISTA_PLUGINS});
  return all;
}

inline std::unique_ptr<const mind::TeamPlan> plan(const std::string& name, const config::Rules& rules = {},
                                                  const config::Robot& robot = {}) {
  const auto file = std::filesystem::path(REGISTA_CONFIGS) / "teams" / (name + ".yaml");
  return std::make_unique<const mind::TeamPlan>(config::read_document<config::Team>(file), rules, robot, catalogue());
}

// A decision of a robot: what it believes of its pose, and where it is. Field frame of its team.
struct Believed {
  double time;
  match::Side side;
  int number;
  mind::Pose belief, truth;
  const mind::Percepts& percepts;

  double error() const { return std::hypot(belief.x - truth.x, belief.y - truth.y); }
  double heading_error() const { return std::fabs(mind::wrap(belief.heading - truth.heading)); }
  // Distance to where it would be mirrored.
  double mirrored_error() const { return std::hypot(belief.x + truth.x, belief.y + truth.y); }
  double mirrored_heading_error() const {
    return std::fabs(mind::wrap(belief.heading - truth.heading - std::numbers::pi));
  }
};

inline match::Result play(const match::Setup& setup, const std::array<const mind::TeamPlan*, 2>& teams,
                          const std::function<void(const Believed&)>& each) {
  std::vector<match::BodyState> bodies;
  int half = 1;
  match::Observer observer;
  observer.step = [&](const match::Snapshot& now) {
    bodies.assign(now.bodies.begin(), now.bodies.end());
    half = now.state.half;
  };
  const match::Roster roster{setup.rules.team_size};
  return match::play(setup, teams, &observer, [&](const mind::Mind& mind, const match::Decision& decision) {
    if (bodies.empty()) return;
    const match::Side side = decision.side;
    const auto& body = bodies[static_cast<std::size_t>(roster.id(side, mind.number()))];
    const mind::Pose truth = match::in_field_frame({body.x, body.y, body.heading}, match::attack(side, half));
    each({decision.time, side, mind.number(), mind.world().local().pose(), truth, decision.percepts});
  });
}

}  // namespace regista::shipped
