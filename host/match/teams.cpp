// SPDX-License-Identifier: MIT
#include "match/teams.hpp"

#include <Random123/philox.h>
#include <regista/abi.h>

namespace regista::match {

mind::Mind mind(const mind::TeamPlan& plan, Side side, int number, std::uint64_t seed, plugin::CallTracing tracing,
                const mind::MindOptions& options) {
  tracing.side = static_cast<std::int32_t>(index(side));
  return {plan, number, r123::Philox2x64()({{index(side), 0}}, {{seed}})[0], tracing, options};
}

std::vector<mind::Mind> minds(const mind::TeamPlan& plan, Side side, std::uint64_t seed, plugin::CallTracing tracing,
                              const mind::MindOptions& options) {
  std::vector<mind::Mind> out;
  for (int number = 1; number <= plan.rules().team_size; ++number) {
    out.push_back(mind(plan, side, number, seed, tracing, options));
  }
  return out;
}

std::vector<Role> roles(const mind::TeamPlan& plan) {
  std::vector<Role> out;
  for (std::size_t i = 0; i < plan.roles().size(); ++i) {
    const mind::RoleRow& row = plan.roles()[i];
    const auto& list = plan.team().role_lists[static_cast<std::size_t>(row.list)];
    out.push_back({row.role->name, list.name, row.priority, row.role->robots, row.role->least_in_play,
                   (plan.purposes(static_cast<int>(i)) & REGISTA_BEHAVIOUR_PLAYS_BALL) != 0});
  }
  return out;
}

Result play(Setup setup, const std::array<const mind::TeamPlan*, 2>& teams, const Observer* observer,
            const AfterDecision& after, plugin::CallTracing tracing) {
  std::array<std::vector<mind::Mind>, 2> all;
  std::array<std::vector<mind::Think>, 2> think;
  Observer both = observer != nullptr ? *observer : Observer{};
  const mind::MindOptions options{.whole_frame = after && !both.outcomes_alone,
                                  .segments = both.segments,
                                  .drawings = both.drawings,
                                  .log = both.log};
  for (const Side side : both_sides) {
    const mind::TeamPlan& plan = *teams[index(side)];
    setup.roles[index(side)] = roles(plan);
    setup.reasons[index(side)] = plan.reasons();
    setup.plugin_metrics[index(side)] = plan.metrics();
    all[index(side)] = minds(plan, side, setup.seed, tracing, options);
    for (mind::Mind& each : all[index(side)]) {
      think[index(side)].push_back(std::bind_front(&mind::Mind::think, &each));
    }
  }
  const Beliefs beliefs = [&all](Side side, int number, Belief& out) {
    belief_of(all[index(side)][at(number - 1)], out);
  };
  if (after) {
    both.decision = [&all, &after, first = both.decision](const Decision& decision) {
      if (first) first(decision);
      after(all[index(decision.side)][at(decision.number - 1)], decision);
    };
  }
  return play(setup, think[0], think[1], &both, beliefs);
}

void belief_of(const mind::Mind& mind, Belief& out) {
  const mind::WorldModel& model = mind.world();
  const mind::DistributedWorldModel& world = model.mine();
  const regista_track& self = model.local().self();
  const auto estimate = [](bool known, const double* at, const double* covariance) {
    return Estimate{known, {at[0], at[1]}, covariance[0], covariance[1], covariance[2]};
  };
  out.self = {true, {self.x, self.y}, self.covariance[0], self.covariance[1], self.covariance[2]};
  const regista_ball& ball = world.ball_state;
  out.ball = estimate(world.ball_known() && !model.ball_refuted(), ball.position, ball.covariance);
  out.teammates.clear();
  for (const regista_robot& robot : world.robots) {
    out.teammates.push_back(estimate((robot.flags & REGISTA_ROBOT_ACTIVE) != 0, robot.pose, robot.covariance));
  }
  out.opponents.clear();
  for (const regista_opponent& opponent : world.opponents) {
    out.opponents.push_back({opponent.position[0], opponent.position[1]});
  }
}

}  // namespace regista::match
