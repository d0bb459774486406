// SPDX-License-Identifier: MIT
// A team page key by key, as it is written; Team is what comes of it once every context's `use:` has been laid over the
// team's own values.
#pragma once

#include <string>
#include <vector>

#include "config/declaration.hpp"
#include "config/node.hpp"
#include "config/team.hpp"

namespace regista::config {

struct Predictors {
  PluginUse self, ball, opponents, teammates;
};

// What a context may change: the keys that `use:` can name, besides `roles`.
struct Coordination {
  PluginUse positioner;  // no plugin: no waypoints
  TaskRules tasks;
  Knowledge utility_knowledge = Knowledge::mine;
  std::vector<UtilityTerm> terms;
  PluginUse assigner, sender;
};

struct ContextPage {
  std::string name;
  int priority = 0;
  PluginUse plugin;
  Knowledge knowledge = Knowledge::mine;
  Node use;
  Location where;
};

// Where a context has a role played, in `use: {targets: {ROLE: ...}}`.
struct RoleTarget {
  std::string name;  // of the role
  TargetRule target;
};

struct TeamPage {
  std::string name;
  Predictors predictors;
  std::vector<ContextPage> contexts;
  Coordination coordination;
  std::vector<RoleList> role_lists;
  std::vector<Behaviour> behaviours;
  std::string behaviour_without_role = Team{}.behaviour_without_role;
  double forget_teammate_after = Team{}.forget_teammate_after;
};

Map declare(TeamPage& page);
Map declare(Coordination& coordination);
Map declare(std::vector<RoleTarget>& targets);

// The keys that may begin a path of `use:`.
const std::vector<std::string>& usable_keys();

// The values that a context's `use:` leaves in force: positioner, tasks, utility, assigner and sender of a document,
// with those of `use` laid over.
Node in_context(const Node& document, const Node& use);

// The targets of a context's `use`, a map from roles to them, however their paths are written; absent without any.
// Throws Error at a path that leads nowhere.
Node targets_of(const Node& use);

// Reads and checks a page, and fills in what follows from other values (the behaviours of roles).
TeamPage read_team_page(const Node& document);
TeamPage read_team_page(const Node& document, Mistakes& mistakes);

}  // namespace regista::config
