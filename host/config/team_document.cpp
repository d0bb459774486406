// SPDX-License-Identifier: MIT
#include "config/team_document.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "config/read.hpp"
#include "config/scalar.hpp"

namespace regista::config {
namespace {

Field place(std::string key, Member<Place> member, std::string doc) {
  return {std::move(key), std::move(doc),
          Own{"place",
              [member](const Node& node, const std::string& what, Mistakes&) { member.get() = to_place(node, what); },
              [member] { return member.present() ? written(member.get()) : Node(); }}};
}

Field segment(std::string key, std::optional<OnLine>& line, std::string doc) {
  const auto read_line = [&line](const Node& node, const std::string& what, Mistakes& mistakes) {
    if (node.kind() != Node::Kind::sequence || node.elements().size() != 2) {
      refuse_kind(node, what, "a list of two places");
    }
    line.emplace();
    attempt_each(node, what, mistakes, [&](const Node& end, const std::string& path, std::size_t i) {
      (i == 0 ? line->from : line->to) = to_place(end, path);
    });
  };
  const auto write_line = [&line] { return line ? Node::sequence({written(line->from), written(line->to)}) : Node(); };
  return {std::move(key), std::move(doc), Own{"segment", read_line, write_line}};
}

std::vector<Field> plugin_fields(PluginUse& use) {
  return {
      required(name("plugin", use.plugin, "id")),
      file("file", use.file, "a certain shared object, instead of the one that the search finds"),
      free("params", use.params, "params", "parameters of the plugin"),
  };
}

// A nested map that needs no struct of its own. open() declares the map.
Field group(std::string key, std::function<Map()> open, std::string doc) {
  return {std::move(key), std::move(doc), Section{std::move(open), [] { return true; }}};
}

// A shirt number or a list of different ones. The number 0 gives an empty list.
Field shirt_numbers(std::string key, std::vector<int>& numbers, std::string doc) {
  const auto read_numbers = [&numbers](const Node& node, const std::string& what, Mistakes& mistakes) {
    const auto number = [](const Node& each, const std::string& path, double least) {
      return static_cast<int>(integer_within(each, path, {least, most_shirt_number}, "1"));
    };
    numbers.clear();
    if (node.kind() != Node::Kind::sequence) {
      if (const int only = number(node, what, 0); only != 0) numbers.push_back(only);
      return;
    }
    if (node.elements().empty()) throw Error(node.where(), what + ": an empty list; 0 is any robot");
    attempt_each(node, what, mistakes, [&](const Node& element, const std::string& path, std::size_t) {
      const int next = number(element, path, 1);
      if (std::ranges::find(numbers, next) != numbers.end())
        throw Error(element.where(), fmt::format("{}: robot {} is given twice", path, next));
      numbers.push_back(next);
    });
  };
  const auto write_numbers = [&numbers] {
    const auto text = [](int number) { return Node::scalar(std::to_string(number)); };
    if (numbers.size() < 2) return text(numbers.empty() ? 0 : numbers.front());
    return sequence_of(numbers, text);
  };
  return {std::move(key), std::move(doc), Own{"shirt_numbers", read_numbers, write_numbers}};
}

}  // namespace

static Map declare(TaskRules& tasks) {
  const auto offset = [&tasks] {
    return Map{{real("at_most", tasks.offset_at_most, {0, 20}, "m", "farthest move towards a waypoint; 0 is off")}};
  };
  return {{
      choice("keep", tasks.keep, {"all", "nearest_to_waypoints"}, "which of the tasks are kept for the active robots"),
      real("hysteresis", tasks.hysteresis, {0, 20}, "m",
           "a task that a robot is said to play counts as so much nearer to a waypoint"),
      group("offset", offset, "moving a kept task towards the waypoint that is matched with it"),
      choice("knowledge", tasks.knowledge, {"mine", "common"}, "world that tasks are placed in"),
      with_default_from(choice("waypoints_knowledge", tasks.waypoints_knowledge, {"mine", "common"},
                               "world that the positioner sees"),
                        "knowledge"),
      with_default_from(choice("filter_knowledge", tasks.filter_knowledge, {"mine", "common"},
                               "world in which the tasks that are kept are chosen"),
                        "knowledge"),
      boolean("along_edges", tasks.walk_along_edges, "walk to a task along the edges between waypoints"),
  }};
}

static Map declare(UtilityTerm& term) {
  return {.fields = joined(
              plugin_fields(term.use),
              {real("weight", term.weight, {0, 1e6}, "1", "of this term in the sum"),
               numbers("tune", term.tune, {0, 1e6}, "1", "range of the weight that the tuner may search", true)}),
          .where = &term.use.where,
          .plugin_kind = "utility"};
}

Map declare(Coordination& coordination) {
  const auto term = [](UtilityTerm& each) { return section(each.name, each, "term of the utility"); };
  const auto utility = [&coordination, term] {
    return Map{{
        choice("knowledge", coordination.utility_knowledge, {"mine", "common"}, "world that robots are scored in"),
        dictionary("terms", coordination.terms, term, 0, 64, "what is summed up"),
    }};
  };
  return {{
      plugin_field("positioner", coordination.positioner, "positioner",
                   "desirable points of the field; without it, none"),
      section("tasks", coordination.tasks, "from roles to tasks"),
      group("utility", utility, "how well a robot fits a task"),
      required(plugin_field("assigner", coordination.assigner, "assigner", "who does what")),
      required(plugin_field("sender", coordination.sender, "sender", "when to send a packet")),
  }};
}

static Map declare(ContextPage& page) {
  Context& context = page.context;
  return {
      .fields = joined(
          joined(
              {
                  required(name("name", context.name, "of the context")),
                  integer("priority", context.priority, {-1000000, 1000000}, "1", "the highest that holds is in force"),
              },
              plugin_fields(context.use)),
          {
              choice("knowledge", context.knowledge, {"mine", "common"}, "world that the condition is asked about"),
              free("use", page.use, "use",
                   "values of the team that are others while it holds, by their paths; targets: a map from roles "
                   "of the list to targets"),
          }),
      .where = &context.where,
      .plugin_kind = "context"};
}

static Map declare(TargetRule::OnCircle& circle) {
  return {{
      required(place("from", circle.from, "beginning of the line")),
      required(place("towards", circle.towards, "where the line goes")),
      required(place("centre", circle.centre, "of the circle")),
      bounds("radius", circle.least_radius, circle.largest_radius, {0, 100}, "m", "[least, largest]"),
      bounds("over", circle.least_distance, circle.largest_distance, {0, 200}, "m",
             "distances of `from` from the centre between which the radius grows"),
  }};
}

static Map declare(TargetRule& target) {
  const Member<double> from_goal([&target]() -> double& { return target.on_line->distance_from_to; },
                                 [&target] { return target.on_line.has_value(); });
  return {.fields =
              {
                  place("at", target.at, "begin at this place"),
                  segment("on_line", target.on_line, "begin on the segment between two places"),
                  real("from_goal", from_goal, {0, 100}, "m", "so far from the second place of on_line"),
                  section("on_circle", target.on_circle, "begin where a line enters a growing circle"),
                  numbers("shift", target.shift, coordinates, "m", "then move by [x, y]"),
                  real("lateral", target.lateral, {-100, 100}, "m",
                       "then y is this, on the side where the ball is not; below 0, on the ball's side"),
                  numbers("within", target.within, coordinates, "m",
                          "then keep inside of [least x, largest x, least y, largest y]"),
                  place("facing", target.facing, "looking at"),
                  place("without_ball", target.without_ball, "instead, while nobody knows the ball"),
              },
          .exactly_one = {"at", "on_line", "on_circle"},
          .needs = {{"from_goal", "on_line"}}};
}

Map declare(std::vector<RoleTarget>& targets) {
  const auto target = [](RoleTarget& each) { return section(each.name, each.target, "where it is played"); };
  return {{dictionary("targets", targets, target, 1, 64, "roles that are played elsewhere")}};
}

static Map declare(Role& role) {
  return {
      {
          required(name("name", role.name, "of the role")),
          shirt_numbers("robot", role.robots,
                        "shirt number that alone may take it, or a list: the first of them that is active; 0 is any"),
          integer("least_in_play", role.least_in_play, {1, 22}, "robots",
                  "nobody takes it while fewer robots of the team are in play, not penalised"),
          boolean("required", role.required, "must be taken"),
          boolean("offset", role.offset, "may be moved towards a waypoint"),
          integer("group", role.group, {-1, 99}, "1", "at most one role of a group per robot; -1 is none"),
          with_default_from(name("behaviour", role.behaviour,
                                 "how it acts: a name of `behaviours`, or a plugin; follows from target and "
                                 "name where not given"),
                            "target and name"),
          required(section("target", role.target, "where it is played")),
      },
      &role.where};
}

static Map declare(Behaviour& behaviour) {
  std::vector<Field> fields = plugin_fields(behaviour.use);
  Field& plugin = fields.front();
  plugin.required = false;
  plugin = with_default_from(std::move(plugin), "the name");
  return {.fields = std::move(fields), .where = &behaviour.use.where, .plugin_kind = "behaviour"};
}

Map declare(TeamDocument& page) {
  Team& team = page.team;
  const auto predictors = [&team] {
    return Map{{
        required(plugin_field("self", team.self, "predictor", "the own pose")),
        required(plugin_field("ball", team.ball, "predictor", "the ball")),
        required(plugin_field("opponents", team.opponents, "predictor", "the other team")),
        required(plugin_field("teammates", team.teammates, "predictor", "teammates between their packets")),
    }};
  };
  const auto roles = [](RoleList& each) { return list(each.name, each.roles, 1, 64, "roles in order of importance"); };
  const auto behaviour = [](Behaviour& each) {
    if (each.use.plugin.empty()) each.use.plugin = each.name;
    return section(each.name, each, "behaviour that roles may name");
  };
  return {
      joined(joined(
                 {
                     required(name("team", team.name, "name of this team, one word")),
                     line("title", team.title, "name of this team for people; without it, `team`"),
                     required(group("predictors", predictors, "how each part of the world is carried forward")),
                     required(list("contexts", page.contexts, 1, 64, "situations; the first that holds is in force")),
                 },
                 declare(page.coordination).fields),
             {
                 required(dictionary("roles", team.role_lists, roles, 1, 64, "lists of roles; the first is the usual")),
                 dictionary("behaviours", team.behaviours, behaviour, 0, 64,
                            "how robots act; one that is not here is the plugin of its name"),
                 name("behaviour_without_role", team.behaviour_without_role, "of robots that have no role"),
                 real("teammates_forgotten_after", team.forget_teammate_after, {0.1, 3600}, "s",
                      "silence until a teammate is given up"),
             })};
}

const std::vector<std::string>& usable_keys() {
  static const std::vector<std::string> keys{"roles",   "targets",  "positioner", "tasks",
                                             "utility", "assigner", "sender"};
  return keys;
}

Field plugin_field(std::string key, PluginUse& use, std::string kind, std::string doc) {
  return {std::move(key), std::move(doc),
          Section{[&use, kind = std::move(kind)] {
                    return Map{.fields = plugin_fields(use), .where = &use.where, .plugin_kind = kind};
                  },
                  [&use] { return !use.plugin.empty(); }}};
}

}  // namespace regista::config
