// SPDX-License-Identifier: MIT
#include "config/team.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "config/documents.hpp"
#include "config/overlay.hpp"
#include "config/read.hpp"
#include "config/team_page.hpp"
#include "texts/message.hpp"

namespace regista::config {
namespace {

bool same_place(const Place& a, const Place& b) { return a.anchor == b.anchor && a.point == b.point; }

void check_target(const TargetRule& target, const Node& node, const std::string& what, Mistakes& mistakes) {
  const auto wrong = [&](const char* key, const std::string& reason) {
    const std::string path = what + '.' + key;
    if (!mistakes.doubtful(path)) mistakes.add(Error(node[key].where(), path + ": " + reason), path);
  };
  if (target.within) {
    const auto& [least_x, largest_x, least_y, largest_y] = *target.within;
    if (least_x > largest_x || least_y > largest_y) {
      wrong("within", "expected [least x, largest x, least y, largest y], in order");
    }
  }
  if (target.on_line && same_place(target.on_line->from, target.on_line->to)) {
    wrong("on_line", "both ends are the same place");
  }
  if (target.on_circle && same_place(target.on_circle->from, target.on_circle->towards)) {
    wrong("on_circle", "from and towards are the same place");
  }
}

// The behaviour of a role that does not name one.
std::string usual_behaviour(const Role& role) {
  const TargetRule& target = role.target;
  const bool moved = target.shift != std::array<double, 2>{} || target.across;
  if (target.at && target.at->anchor == Anchor::ball && !moved) return "play_ball";
  return role.name == "goalkeeper" ? "keep_goal" : "support";
}

// The worlds of waypoints and filter where the page does not say them.
void follow(TaskRules& tasks, const Node& written) {
  if (!written["waypoints_knowledge"]) tasks.waypoints_knowledge = tasks.knowledge;
  if (!written["filter_knowledge"]) tasks.filter_knowledge = tasks.knowledge;
}

// Numbers of roles are named by the role, and those of plugins begin with these words.
void check_name(const std::string& name, const Location& where, const std::string& path, Mistakes& mistakes) {
  if (name != "plugin_totals" && name != "plugin_values") return;
  mistakes.add(Error(where, fmt::format("{}: metrics of plugins are called so; choose another name", name)), path);
}

void check_roles(TeamPage& page, const Node& document, Mistakes& mistakes) {
  for (RoleList& list : page.role_lists) {
    const Node roles = document["roles"][list.name];
    check_name(list.name, roles.where(), "roles." + list.name, mistakes);
    for (std::size_t i = 0; i < list.roles.size(); ++i) {
      const Node node = roles.elements()[i];
      check_name(list.roles[i].name, node.where(), fmt::format("roles.{}.{}", list.name, i), mistakes);
      check_target(list.roles[i].target, node["target"], fmt::format("roles.{}.{}.target", list.name, i), mistakes);
      Role& role = list.roles[i];
      const Node behaviour = node["behaviour"];
      if (!behaviour) role.behaviour = usual_behaviour(role);
      role.behaviour_where = behaviour ? behaviour.where() : role.where;
    }
  }
}

void check_priorities(const TeamPage& page, const Node& document, Mistakes& mistakes) {
  const std::vector<ContextPage>& contexts = page.contexts;
  const auto path = [](std::size_t i) { return fmt::format("contexts.{}.priority", i); };
  for (std::size_t i = 0; i < contexts.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (contexts[i].priority != contexts[j].priority) continue;
      if (mistakes.mistaken(path(i)) || mistakes.mistaken(path(j))) continue;
      const Node element = document["contexts"].elements()[i];
      const Node priority = element["priority"];
      mistakes.add(Error(priority ? priority.where() : element.where(),
                         fmt::format("contexts {} and {} have the same priority {}", contexts[j].name, contexts[i].name,
                                     contexts[i].priority)),
                   path(i));
    }
  }
}

// The part of a document that `use:` can change.
Node coordination_of(const Node& document) {
  std::vector<Node::Entry> entries;
  for (const Node::Entry& entry : document.entries()) {
    const bool usable = entry.key != "roles" && entry.key != "targets" &&
                        std::count(usable_keys().begin(), usable_keys().end(), entry.key) > 0;
    if (usable) entries.push_back(entry);
  }
  return Node::map(std::move(entries), document.where());
}

int role_list_named(const Node& value, const TeamPage& page, const std::string& what) {
  std::vector<std::string> names;
  for (const RoleList& list : page.role_lists) names.push_back(list.name);
  if (value.kind() != Node::Kind::scalar) throw Error(value.where(), what + ": expected the name of a list of roles");
  const auto found = std::find(names.begin(), names.end(), value.text());
  if (found == names.end()) throw Error(value.where(), texts::unknown("list of roles", value.text(), "", names));
  return static_cast<int>(found - names.begin());
}

// A value of a term that is not there, "utility.terms.distnce.weight", in words; empty where all is well.
std::string unknown_term(std::string_view key, const Node& values) {
  constexpr std::string_view terms = "utility.terms.";
  if (!key.starts_with(terms)) return {};
  const std::string_view rest = key.substr(terms.size()), term = rest.substr(0, rest.find('.'));
  const Node known = values["utility"]["terms"];
  if (term.size() == rest.size() || known[term]) return {};
  std::vector<std::string> names;
  for (const Node::Entry& each : known.entries()) names.push_back(each.key);
  return texts::unknown("term", term, "utility.terms", names);
}

// The targets of a context, by place in its list of roles. `targets`: a map from roles to where they are played.
void read_targets(const Node& targets, const RoleList& list, const std::string& what, Context& context,
                  Mistakes& mistakes) {
  std::vector<RoleTarget> read_ones;
  read(declare(read_ones), Node::map({{"targets", targets.where(), targets}}, targets.where()), what, mistakes);
  std::vector<std::string> names;
  for (const Role& role : list.roles) names.push_back(role.name);
  context.targets.resize(list.roles.size());
  for (const RoleTarget& each : read_ones) {
    const std::string path = fmt::format("{}.targets.{}", what, each.name);
    const auto found = std::ranges::find(names, each.name);
    if (found == names.end()) {
      const auto written = std::ranges::find(targets.entries(), each.name, &Node::Entry::key);
      mistakes.add(Error(written->key_where, texts::unknown("role", each.name, list.name, names)), path);
      continue;
    }
    check_target(each.target, targets[each.name], path, mistakes);
    context.targets[static_cast<std::size_t>(found - names.begin())] = each.target;
  }
}

// `what`: the path of the context's `use:`.
Context resolved(const ContextPage& written, const Node& document, const TeamPage& page, const std::string& what,
                 Mistakes& mistakes) {
  Context context;
  Node values = coordination_of(document);
  bool list_known = !mistakes.mistaken("roles");
  for (const Node::Entry& entry : written.use.entries()) {
    const std::string first = entry.key.substr(0, entry.key.find('.'));
    mistakes.attempt(what, [&] {
      if (std::count(usable_keys().begin(), usable_keys().end(), first) == 0) {
        throw Error(entry.key_where, texts::unknown("key", first, what, usable_keys()));
      }
      if (entry.key == "roles") {
        list_known = false;
        // A list that could not be read may be the one that is meant.
        const bool all_lists =
            !mistakes.mistaken("roles") && page.role_lists.size() == document["roles"].entries().size();
        if (!all_lists && entry.value.kind() == Node::Kind::scalar) return;
        context.role_list = role_list_named(entry.value, page, what + ".roles");
        list_known = true;
      } else if (first == "roles") {
        throw Error(entry.key_where, what + ": roles takes the name of a list and has no parts");
      } else if (first == "targets") {
        // Read below, once the list of roles is known.
      } else if (const std::string term = unknown_term(entry.key, values); !term.empty()) {
        throw Error(entry.key_where, term);
      } else if (!mistakes.mistaken(entry.key.substr(0, entry.key.rfind('.'))) || first == entry.key) {
        values = with(values, entry.key, entry.value, entry.key_where);
      }
    });
  }
  mistakes.attempt(what + ".targets", [&] {
    const Node targets = targets_of(written.use);
    if (!targets || !list_known) return;
    read_targets(targets, page.role_lists[static_cast<std::size_t>(context.role_list)], what, context, mistakes);
  });
  Coordination coordination;
  read(declare(coordination), values, "", mistakes);
  follow(coordination.tasks, values["tasks"]);
  context.name = written.name;
  context.priority = written.priority;
  context.use = written.plugin;
  context.knowledge = written.knowledge;
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

Node targets_of(const Node& use) {
  Node out;
  for (const Node::Entry& entry : use.entries()) {
    if (entry.key.substr(0, entry.key.find('.')) != "targets") continue;
    out = with(out ? out : Node::map({}, entry.key_where), entry.key, entry.value, entry.key_where);
  }
  return out["targets"];
}

Node in_context(const Node& document, const Node& use) {
  Node values = coordination_of(document);
  for (const Node::Entry& entry : use.entries()) {
    const std::string_view first = std::string_view(entry.key).substr(0, entry.key.find('.'));
    if (first != "roles" && first != "targets") values = with(values, entry.key, entry.value, entry.key_where);
  }
  return values;
}

TeamPage read_team_page(const Node& document, Mistakes& mistakes) {
  TeamPage page;
  read(declare(page), document, "", mistakes);
  follow(page.coordination.tasks, document["tasks"]);
  check_roles(page, document, mistakes);
  check_priorities(page, document, mistakes);
  return page;
}

TeamPage read_team_page(const Node& document) {
  Mistakes first(Mistakes::After::stop);
  return read_team_page(document, first);
}

template <>
Team read_document<Team>(const Node& document, Mistakes& mistakes) {
  require_kind(document, DocumentKind::team);
  TeamPage page = read_team_page(document, mistakes);
  Team team;
  const Mistakes of_page = mistakes;
  for (std::size_t i = 0; i < page.contexts.size(); ++i) {
    // What one context gets wrong about a value of the team says nothing of that value in another.
    Mistakes of_context = of_page;
    team.contexts.push_back(resolved(page.contexts[i], document, page, fmt::format("contexts.{}.use", i), of_context));
    mistakes.take_over(of_context);
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
  team.behaviours = std::move(page.behaviours);
  team.behaviour_without_role = std::move(page.behaviour_without_role);
  const Node without_role = document["behaviour_without_role"];
  team.behaviour_without_role_where = without_role ? without_role.where() : document.where();
  team.where = document.where();
  return team;
}

}  // namespace regista::config
