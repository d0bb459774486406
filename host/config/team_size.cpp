// SPDX-License-Identifier: MIT
#include "config/team_size.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "config/read.hpp"
#include "config/text.hpp"

namespace regista::config {
namespace {

// The roles of a list, by who may take them.
struct Takers {
  std::set<int> certain;  // robots that have a role of their own
  int for_all = 0;        // roles that any robot may take
};

Takers takers(const RoleList& list, int team_size) {
  Takers out;
  for (const Role& role : list.roles) {
    if (role.robot == 0) ++out.for_all;
    if (role.robot > 0 && role.robot <= team_size) out.certain.insert(role.robot);
  }
  return out;
}

// "robots 3, 6 and 7"
std::string those_left(const std::set<int>& certain, int team_size) {
  std::vector<std::string> numbers;
  for (int number = 1; number <= team_size; ++number) {
    if (!certain.contains(number)) numbers.push_back(fmt::format("{}", number));
  }
  if (numbers.size() == 1) return "robot " + numbers.front();
  const std::string last = numbers.back();
  numbers.pop_back();
  return fmt::format("robots {} and {}", join(numbers), last);
}

std::string contexts_that_play(const Team& team, std::size_t list) {
  std::vector<std::string> names;
  for (const Context& context : team.contexts) {
    if (static_cast<std::size_t>(context.role_list) == list) names.push_back(context.name);
  }
  return names.empty() ? "" : fmt::format("{} {}", names.size() == 1 ? "context" : "contexts", join(names));
}

Location key_of(const Node& roles, const std::string& name) {
  for (const Node::Entry& entry : roles.entries()) {
    if (entry.key == name) return entry.key_where;
  }
  return roles.where();
}

bool has(const RoleList& list, Behaviour behaviour) {
  return std::ranges::any_of(list.roles, [&](const Role& role) { return role.behaviour == behaviour; });
}

// What nobody does in the list though a game needs it.
std::vector<std::string> missing_behaviours(const RoleList& list) {
  std::vector<std::string> out;
  if (!has(list, Behaviour::play_ball) && !has(list, Behaviour::search)) {
    out.emplace_back("no role plays the ball: one has target {at: ball}, or behaviour: play_ball");
  }
  if (!has(list, Behaviour::keep_goal)) {
    out.emplace_back("no role keeps the goal: one has the name goalkeeper, or behaviour: keep_goal");
  }
  return out;
}

}  // namespace

void check(const Team& team, const Rules& rules, const Node& document, Mistakes& mistakes) {
  for (const RoleList& list : team.role_lists) {
    for (std::size_t i = 0; i < list.roles.size(); ++i) {
      const Role& role = list.roles[i];
      if (role.robot <= rules.team_size) continue;
      const std::string path = fmt::format("roles.{}.{}.robot", list.name, i);
      refuse(document, {path},
             fmt::format("{}: the role {} is for robot {}, a team has {} by the rules {}", path, role.name, role.robot,
                         counted(static_cast<std::uint64_t>(rules.team_size), "robot", "robots"), rules.name),
             mistakes);
    }
  }
}

void check(const Team& team, const Rules& rules, const Node& document) {
  Mistakes first(Mistakes::After::stop);
  check(team, rules, document, first);
}

std::string to_string(const Warning& warning) {
  return one_line(fmt::format("{}: warning: {}", to_string(warning.where), warning.message));
}

std::vector<Warning> warnings(const Team& team, const Rules& rules, const Node& document) {
  std::vector<Warning> out;
  for (std::size_t i = 0; i < team.role_lists.size(); ++i) {
    const RoleList& list = team.role_lists[i];
    const std::string contexts = contexts_that_play(team, i);
    if (contexts.empty()) continue;
    for (const std::string& each : missing_behaviours(list)) {
      out.push_back(
          {key_of(document["roles"], list.name), fmt::format("roles.{}: in {} {}", list.name, contexts, each)});
    }
    const Takers roles = takers(list, rules.team_size);
    const int certain = static_cast<int>(roles.certain.size()), played = certain + roles.for_all;
    if (played >= rules.team_size) continue;
    const int left = rules.team_size - played;
    const std::string who = roles.for_all == 0 ? those_left(roles.certain, rules.team_size)
                                               : counted(static_cast<std::uint64_t>(left), "robot", "robots");
    out.push_back({key_of(document["roles"], list.name),
                   fmt::format("roles.{}: role{} for {} of {} robots in {}: {} will stand", list.name,
                               played == 1 ? "" : "s", played, rules.team_size, contexts, who)});
  }
  return out;
}

}  // namespace regista::config
