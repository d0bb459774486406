// SPDX-License-Identifier: MIT
#include "match/teams.hpp"

#include <Random123/philox.h>

#include <utility>

#include "match/mind_belief.hpp"

namespace regista::match {

mind::Mind mind(const mind::TeamPlan& plan, Side side, int number, std::uint64_t seed, plugin::Noting noting,
                const mind::Telling& telling) {
  const r123::Philox2x64 philox;
  const auto words = philox({{static_cast<std::uint64_t>(index(side)), 0}}, {{seed}});
  noting.side = static_cast<std::int32_t>(index(side));
  return {plan, number, words[0], noting, telling};
}

std::vector<mind::Mind> minds(const mind::TeamPlan& plan, Side side, std::uint64_t seed, plugin::Noting noting,
                              const mind::Telling& telling) {
  std::vector<mind::Mind> out;
  for (int number = 1; number <= plan.rules().team_size; ++number) {
    out.push_back(mind(plan, side, number, seed, noting, telling));
  }
  return out;
}

std::vector<Role> roles(const mind::TeamPlan& plan) {
  std::vector<Role> out;
  for (std::size_t i = 0; i < plan.roles().size(); ++i) {
    const mind::RoleRow& row = plan.roles()[i];
    const auto& list = plan.team().role_lists[static_cast<std::size_t>(row.list)];
    out.push_back({row.role->name, list.name, row.priority, row.role->robot,
                   (plan.purposes(static_cast<int>(i)) & REGISTA_BEHAVIOUR_PLAYS_BALL) != 0});
  }
  return out;
}

Result play(Setup setup, const std::array<const mind::TeamPlan*, 2>& teams, const Observer* observer,
            const AfterDecision& after, plugin::Noting noting) {
  std::array<std::vector<mind::Mind>, 2> all;
  std::array<std::vector<mind::Think>, 2> think;
  mind::Telling telling{.whole_frame = static_cast<bool>(after)};
  if (observer != nullptr) {
    telling.segments = observer->segments;
    telling.drawings = observer->drawings;
    telling.log = observer->log;
    if (observer->outcomes_alone) telling.whole_frame = false;
  }
  for (const Side side : both_sides) {
    const mind::TeamPlan& plan = *teams[index(side)];
    setup.roles[index(side)] = roles(plan);
    setup.reasons[index(side)] = plan.reasons();
    setup.plugin_metrics[index(side)] = plan.metrics();
    all[index(side)] = minds(plan, side, setup.seed, noting, telling);
    for (mind::Mind& each : all[index(side)]) {
      think[index(side)].push_back([&each](const mind::Percepts& percepts, std::span<const mind::HeardPacket> heard,
                                           mind::Outcome& out) { each.think(percepts, heard, out); });
    }
  }
  const Beliefs beliefs = [&all](Side side, int number, Belief& out) {
    belief_of(all[index(side)][static_cast<std::size_t>(number - 1)], out);
  };
  if (!after) return play(setup, think[0], think[1], observer, beliefs);
  Observer both = observer != nullptr ? *observer : Observer{};
  both.decision = [&all, &after, observer](const Decision& decision) {
    if (observer != nullptr && observer->decision) observer->decision(decision);
    after(all[index(decision.side)][static_cast<std::size_t>(decision.number - 1)], decision);
  };
  return play(setup, think[0], think[1], &both, beliefs);
}

}  // namespace regista::match
