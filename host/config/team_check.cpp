// SPDX-License-Identifier: MIT
#include "config/team_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>

#include "config/read.hpp"
#include "config/team_document.hpp"
#include "texts/message.hpp"

namespace regista::config {
namespace {

// Lists the robots that are not in `certain`, for a message: "robots 3, 6 and 7"
std::string those_left(const std::set<int>& certain, int team_size) {
  std::vector<std::string> numbers;
  for (int number = 1; number <= team_size; ++number) {
    if (!certain.contains(number)) numbers.push_back(fmt::format("{}", number));
  }
  if (numbers.size() == 1) return "robot " + numbers.front();
  const std::string last = numbers.back();
  numbers.pop_back();
  return fmt::format("robots {} and {}", texts::join(numbers), last);
}

std::string contexts_that_play(const Team& team, std::size_t list) {
  std::vector<std::string> names;
  for (const Context& context : team.contexts) {
    if (static_cast<std::size_t>(context.role_list) == list) names.push_back(context.name);
  }
  return names.empty() ? "" : fmt::format("{} {}", names.size() == 1 ? "context" : "contexts", texts::join(names));
}

Location key_of(const Node& roles, const std::string& name) {
  const auto found = std::ranges::find(roles.entries(), name, &Node::Entry::key);
  return found == roles.entries().end() ? roles.where() : found->key_where;
}

// Returns whether a role of the list uses one of these plugins, or a plugin that is not shipped and may act like one.
bool may_act_by(const Team& team, const RoleList& list, std::initializer_list<std::string_view> plugins) {
  constexpr std::array<std::string_view, 4> shipped{"keep_goal", "play_ball", "support", "search"};
  return std::ranges::any_of(list.roles, [&](const Role& role) {
    const std::string plugin = team.behaviour_named(role.behaviour, role.behaviour_where).plugin;
    return std::ranges::count(plugins, plugin) > 0 || std::ranges::count(shipped, plugin) == 0;
  });
}

// "[-42, 0]"
std::string text_of(const std::array<double, 2>& point) { return fmt::format("[{}, {}]", point[0], point[1]); }

// Returns the place of a role whose target is a fixed point; nothing if the place depends on the match.
std::optional<std::array<double, 2>> fixed_point(const TargetRule& target) {
  if (!target.at || target.at->anchor != Anchor::point || target.lateral) return std::nullopt;
  std::array<double, 2> out{target.at->point[0] + target.shift[0], target.at->point[1] + target.shift[1]};
  if (target.within) {
    const auto& [x_least, x_most, y_least, y_most] = *target.within;
    out = {std::clamp(out[0], x_least, x_most), std::clamp(out[1], y_least, y_most)};
  }
  return out;
}

// Warns of a robot that does not exist and would take the role after another one. (A first one is refused.)
void warn_of_missing_robots(const RoleList& list, const Node& roles, const Rules& rules, std::vector<Warning>& out) {
  for (std::size_t i = 0; i < list.roles.size(); ++i) {
    const std::vector<int>& robots = list.roles[i].robots;
    const auto missing = std::ranges::find_if(robots, [&](int each) { return each > rules.team_size; });
    if (missing == robots.end() || missing == robots.begin()) continue;
    out.push_back(
        {roles.elements()[i]["robot"].where(),
         fmt::format("roles.{}.{}: is also for robot {}, a team has {} by the rules {}", list.name, list.roles[i].name,
                     *missing, texts::plural(static_cast<std::uint64_t>(rules.team_size), "robot", "robots"),
                     rules.name)});
  }
}

void warn_of_shared_robots(const RoleList& list, const Node& roles, std::vector<Warning>& out) {
  for (std::size_t i = 0; i < list.roles.size(); ++i) {
    const std::vector<int>& robots = list.roles[i].robots;
    const auto first = std::ranges::find_if(list.roles, [&](const Role& each) {
      return !robots.empty() && !each.robots.empty() && each.robots.front() == robots.front();
    });
    if (robots.empty() || first == list.roles.begin() + static_cast<std::ptrdiff_t>(i)) continue;
    out.push_back({roles.elements()[i]["robot"].where(),
                   fmt::format("roles.{}: {} and {} are both for robot {}, which takes one role at a time", list.name,
                               first->name, list.roles[i].name, robots.front())});
  }
}

// Warns if a list has more groups of roles than the team has robots. Then some groups always lack a robot.
void warn_of_groups(const RoleList& list, const Node& roles, int team_size, std::vector<Warning>& out) {
  std::set<int> groups;
  for (std::size_t i = 0; i < list.roles.size(); ++i) {
    const Role& role = list.roles[i];
    if (role.group < 0 || !groups.insert(role.group).second) continue;
    if (static_cast<int>(groups.size()) != team_size + 1) continue;
    out.push_back({roles.elements()[i]["group"].where(),
                   fmt::format("roles.{}.{}: group {} makes {} groups for {} robots: some group always goes without",
                               list.name, role.name, role.group, groups.size(), team_size)});
  }
}

void warn_of_contexts_below(const Team& team, std::vector<Warning>& out) {
  const auto always = std::ranges::find_if(team.contexts, always_holds);
  if (always == team.contexts.end()) return;
  for (auto below = always + 1; below != team.contexts.end(); ++below) {
    out.push_back(
        {below->where, fmt::format("contexts.{}: never in force, for {} ({}), which comes first, always holds",
                                   below->name, always->name, to_string(always->where))});
  }
}

// Warns of each key of a target whose place is off the carpet wherever the ball is.
void warn_of_target(const TargetRule& target, const Node& written, const std::string& path, const Carpet& carpet,
                    std::vector<Warning>& out) {
  const auto warn = [&](const char* key, const std::string& says) {
    out.push_back({written[key].where(), fmt::format("{}.{}: {} {}", path, key, says, carpet.off())});
  };
  const auto point = fixed_point(target);
  const bool off = point && !carpet.holds(*point);
  if (off) warn("at", text_of(*point) + " is");
  if (target.within) {
    const auto& [x_least, x_most, y_least, y_most] = *target.within;
    const bool outside = x_least > carpet.x || x_most < -carpet.x || y_least > carpet.y || y_most < -carpet.y;
    if (outside && !off) warn("within", "all of the rectangle is");
  } else if (target.lateral && std::abs(*target.lateral) > carpet.y) {
    warn("lateral", fmt::format("{} is", *target.lateral));
  }
  if (target.without_ball && target.without_ball->anchor == Anchor::point &&
      !carpet.holds(target.without_ball->point)) {
    warn("without_ball", text_of(target.without_ball->point) + " is");
  }
}

void warn_of_targets(const RoleList& list, const Node& roles, const Carpet& carpet, std::vector<Warning>& out) {
  for (std::size_t i = 0; i < list.roles.size(); ++i) {
    warn_of_target(list.roles[i].target, roles.elements()[i]["target"],
                   fmt::format("roles.{}.{}.target", list.name, list.roles[i].name), carpet, out);
  }
}

void warn_of_targets(const Team& team, const Context& context, const Node& use, const Carpet& carpet,
                     std::vector<Warning>& out) {
  const RoleList& list = team.role_lists[static_cast<std::size_t>(context.role_list)];
  const Node targets = targets_of(use);
  for (std::size_t i = 0; i < context.targets.size(); ++i) {
    if (!context.targets[i]) continue;
    const std::string& role = list.roles[i].name;
    warn_of_target(*context.targets[i], targets[role], fmt::format("contexts.{}.use.targets.{}", context.name, role),
                   carpet, out);
  }
}

}  // namespace

std::string Carpet::off() const {
  return fmt::format("off the field, which with its border reaches from {} to {} m in x and from {} to {} m in y", -x,
                     x, -y, y);
}

void check(const Team& team, const Rules& rules, const Node& document, Mistakes& mistakes) {
  const Refusals wrong(document, mistakes);
  for (const RoleList& list : team.role_lists) {
    for (std::size_t i = 0; i < list.roles.size(); ++i) {
      const Role& role = list.roles[i];
      // Only the role's first robot must exist. The others may be missing, so that a team of one robot can play the
      // document of a team of seven.
      if (role.robots.empty() || role.robots.front() <= rules.team_size) continue;
      const std::string path = fmt::format("roles.{}.{}.robot", list.name, i);
      wrong({path}, "{}: the role {} is for robot {}, a team has {} by the rules {}", path, role.name,
            role.robots.front(), texts::plural(static_cast<std::uint64_t>(rules.team_size), "robot", "robots"),
            rules.name);
    }
  }
}

void check(const Team& team, const Rules& rules, const Node& document) {
  Mistakes first(Mistakes::After::stop);
  check(team, rules, document, first);
}

std::string to_string(const Warning& warning) {
  return texts::one_line(fmt::format("{}: warning: {}", to_string(warning.where), warning.message));
}

bool always_holds(const Context& context) { return context.use.plugin == "always" && context.use.file.empty(); }

std::vector<Warning> warnings(const Team& team, const Rules& rules, const Node& document) {
  const Carpet carpet(rules.field);
  std::vector<Warning> out;
  warn_of_contexts_below(team, out);
  for (std::size_t i = 0; i < team.role_lists.size(); ++i) {
    const RoleList& list = team.role_lists[i];
    const std::string contexts = contexts_that_play(team, i);
    const Node roles = document["roles"][list.name];
    const auto warn = [&](const std::string& what) {
      out.push_back({key_of(document["roles"], list.name), fmt::format("roles.{}: {}", list.name, what)});
    };
    if (contexts.empty()) {
      warn(fmt::format("no context plays this list: add use: {{roles: {}}} to one", list.name));
      continue;
    }
    if (!may_act_by(team, list, {"play_ball", "search"})) {
      warn(fmt::format("in {} no role plays the ball: one has target {{at: ball}}, or behaviour: play_ball", contexts));
    }
    if (!may_act_by(team, list, {"keep_goal"})) {
      warn(fmt::format("in {} no role keeps the goal: one has the name goalkeeper, or behaviour: keep_goal", contexts));
    }
    warn_of_missing_robots(list, roles, rules, out);
    warn_of_shared_robots(list, roles, out);
    warn_of_groups(list, roles, rules.team_size, out);
    warn_of_targets(list, roles, carpet, out);
    std::set<int> certain;  // robots that certainly have a role
    int for_all = 0;        // roles that any robot may take
    for (const Role& role : list.roles) {
      if (role.least_in_play > rules.team_size) continue;
      if (role.robots.empty())
        ++for_all;
      else if (role.robots.front() <= rules.team_size)
        certain.insert(role.robots.front());
    }
    const int played = static_cast<int>(certain.size()) + for_all, left = rules.team_size - played;
    if (left <= 0) continue;
    const std::string who = for_all == 0 ? those_left(certain, rules.team_size)
                                         : texts::plural(static_cast<std::uint64_t>(left), "robot", "robots");
    warn(fmt::format("role{} for {} of {} robots in {}: {} will stand", played == 1 ? "" : "s", played, rules.team_size,
                     contexts, who));
  }
  for (const Context& context : team.contexts) {
    const Node pages = document["contexts"];
    const auto named = [](const Node& each) { return each["name"].text(); };
    const auto page = std::ranges::find(pages.elements(), context.name, named);
    if (page != pages.elements().end()) warn_of_targets(team, context, (*page)["use"], carpet, out);
  }
  return out;
}

}  // namespace regista::config
