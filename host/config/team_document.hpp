// SPDX-License-Identifier: MIT
// The document of a team as it is written, key by key. config/team.cpp makes the struct Team from this document: in
// Team, the `use:` of each context has been laid over the team's values.
#pragma once

#include <string>
#include <vector>

#include "config/declaration.hpp"
#include "config/node.hpp"
#include "config/team.hpp"

namespace regista::config {

// A context as it is written: `use:` is not laid over the team's values yet.
struct ContextPage {
  Context context;  // without role list, targets and the values of Coordination
  Node use;
};

// The target of a role (the rule for its place on the field) while a context holds: `use: {targets: {ROLE: ...}}`.
struct RoleTarget {
  std::string name;  // name of the role
  TargetRule target;
};

struct TeamDocument {
  Team team;  // without contexts, file, places and the default of the title
  std::vector<ContextPage> contexts;
  Coordination coordination;
};

Map declare(TeamDocument& page);
Map declare(Coordination& coordination);
Map declare(std::vector<RoleTarget>& targets);

// Returns the keys with which a path in `use:` may begin.
const std::vector<std::string>& usable_keys();

// Returns the document's positioner, tasks, utility, assigner and sender, with the `use` of a context laid over them.
Node in_context(const Node& document, const Node& use);

// Returns the targets in `use` as a map from roles to targets; absent if `use` has no targets. `use` may hold the
// targets as a map or as dotted paths. Throws Error at a path to a value that does not exist.
Node targets_of(const Node& use);

// Reads and checks a team's document. A role without a behaviour in the document gets the default of Role::behaviour.
TeamDocument read_team_document(const Node& document, Mistakes& mistakes);

// Returns a section with exactly the keys `plugin`, `file` and `params`. kind: kind of the plugin, such as "predictor".
Field plugin_field(std::string key, PluginUse& use, std::string kind, std::string doc);

}  // namespace regista::config
