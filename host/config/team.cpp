// SPDX-License-Identifier: MIT
#include "config/team.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "config/documents.hpp"
#include "config/overlay.hpp"
#include "config/read.hpp"
#include "config/team_page.hpp"
#include "config/text.hpp"

namespace regista::config {
namespace {

bool same_place(const Place& a, const Place& b) { return a.anchor == b.anchor && a.point == b.point; }

void check_target(const TargetRule& target, const Node& node, const std::string& what) {
  if (target.within) {
    const auto& [least_x, largest_x, least_y, largest_y] = *target.within;
    if (least_x > largest_x || least_y > largest_y) {
      throw Error(node["within"].where(),
                  what + ".within: [least x, largest x, least y, largest y] is wanted, in order");
    }
  }
  if (target.on_line && same_place(target.on_line->from, target.on_line->to)) {
    throw Error(node["on_line"].where(), what + ".on_line: both ends are the same place");
  }
  if (target.on_circle && same_place(target.on_circle->from, target.on_circle->towards)) {
    throw Error(node["on_circle"].where(), what + ".on_circle: from and towards are the same place");
  }
}

// The behaviour of a role that does not name one.
Behaviour usual_behaviour(const Role& role) {
  const TargetRule& target = role.target;
  const bool moved = target.shift != std::array<double, 2>{} || target.across;
  if (target.at && target.at->anchor == Anchor::ball && !moved) return Behaviour::play_ball;
  return role.name == "goalkeeper" ? Behaviour::keep_goal : Behaviour::support;
}

void check_roles(TeamPage& page, const Node& document) {
  for (RoleList& list : page.role_lists) {
    const Node roles = document["roles"][list.name];
    for (std::size_t i = 0; i < list.roles.size(); ++i) {
      const Node node = roles.elements()[i];
      check_target(list.roles[i].target, node["target"], fmt::format("roles.{}.{}.target", list.name, i));
      if (!node["behaviour"]) list.roles[i].behaviour = usual_behaviour(list.roles[i]);
    }
  }
}

void check_priorities(const TeamPage& page, const Node& document) {
  const std::vector<ContextPage>& contexts = page.contexts;
  for (std::size_t i = 0; i < contexts.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (contexts[i].priority != contexts[j].priority) continue;
      const Node element = document["contexts"].elements()[i];
      const Node priority = element["priority"];
      throw Error(priority ? priority.where() : element.where(),
                  fmt::format("contexts {} and {} have the same priority {}", contexts[j].name, contexts[i].name,
                              contexts[i].priority));
    }
  }
}

// The part of a document that `use:` can change.
Node coordination_of(const Node& document) {
  std::vector<Node::Entry> entries;
  for (const Node::Entry& entry : document.entries()) {
    const bool usable = entry.key != "roles" && std::count(usable_keys().begin(), usable_keys().end(), entry.key) > 0;
    if (usable) entries.push_back(entry);
  }
  return Node::map(std::move(entries), document.where());
}

int role_list_named(const Node& value, const TeamPage& page, const std::string& what) {
  std::vector<std::string> names;
  for (const RoleList& list : page.role_lists) names.push_back(list.name);
  if (value.kind() != Node::Kind::scalar) throw Error(value.where(), what + ": the name of a list of roles is wanted");
  const auto found = std::find(names.begin(), names.end(), value.text());
  if (found == names.end()) throw Error(value.where(), unknown("list of roles", value.text(), "", names));
  return static_cast<int>(found - names.begin());
}

Context resolved(const ContextPage& written, const Node& document, const TeamPage& page, const std::string& what) {
  Context context;
  for (const Node::Entry& entry : written.use.entries()) {
    const std::string first = entry.key.substr(0, entry.key.find('.'));
    if (std::count(usable_keys().begin(), usable_keys().end(), first) == 0) {
      throw Error(entry.key_where, unknown("key", first, what, usable_keys()));
    }
    if (entry.key == "roles") {
      context.role_list = role_list_named(entry.value, page, what + ".roles");
    } else if (first == "roles") {
      throw Error(entry.key_where, what + ": roles takes the name of a list and has no parts");
    }
  }
  Coordination coordination;
  read(declare(coordination), in_context(document, written.use));
  context.name = written.name;
  context.priority = written.priority;
  context.use = written.plugin;
  context.use.where = written.where;
  context.where = written.where;
  context.positioner = std::move(coordination.positioner);
  context.tasks = coordination.tasks;
  context.utility_knowledge = coordination.utility_knowledge;
  context.terms = std::move(coordination.terms);
  context.assigner = std::move(coordination.assigner);
  context.sender = std::move(coordination.sender);
  return context;
}

}  // namespace

Node in_context(const Node& document, const Node& use) {
  Node values = coordination_of(document);
  for (const Node::Entry& entry : use.entries()) {
    if (entry.key != "roles") values = with(values, entry.key, entry.value, entry.key_where);
  }
  return values;
}

TeamPage read_team_page(const Node& document) {
  TeamPage page;
  read(declare(page), document);
  check_roles(page, document);
  check_priorities(page, document);
  return page;
}

Team read_team(const Node& document) {
  require_kind(document, DocumentKind::team);
  TeamPage page = read_team_page(document);
  Team team;
  for (std::size_t i = 0; i < page.contexts.size(); ++i) {
    team.contexts.push_back(resolved(page.contexts[i], document, page, fmt::format("contexts.{}.use", i)));
  }
  std::stable_sort(team.contexts.begin(), team.contexts.end(),
                   [](const Context& a, const Context& b) { return a.priority > b.priority; });
  team.name = page.name;
  team.file = document.where().file;
  team.self = std::move(page.predictors.self);
  team.ball = std::move(page.predictors.ball);
  team.opponents = std::move(page.predictors.opponents);
  team.teammates = std::move(page.predictors.teammates);
  team.forget_teammate_after = page.forget_teammate_after;
  team.role_lists = std::move(page.role_lists);
  team.where = document.where();
  return team;
}

}  // namespace regista::config
