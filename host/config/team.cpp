// SPDX-License-Identifier: MIT
#include "config/team.hpp"

#include <fmt/format.h>

#include "config/documents.hpp"
#include "config/overlay.hpp"
#include "config/read.hpp"
#include "config/team_document.hpp"
#include "texts/message.hpp"

namespace regista::config {

std::span<const std::string> anchor_names() {
  static const std::array<std::string, static_cast<std::size_t>(Anchor::point)> names{
      "ball",           "ball_rest", "own_goal",         "opponent_goal",        "own_left_post",
      "own_right_post", "centre",    "own_penalty_mark", "opponent_penalty_mark"};
  return names;
}

Place to_place(const Node& node, std::string_view what) {
  if (node.kind() == Node::Kind::scalar) {
    const std::span<const std::string> names = anchor_names();
    const auto found = std::ranges::find(names, node.text());
    if (found != names.end()) return {static_cast<Anchor>(found - names.begin()), {}};
    throw Error(node.where(), fmt::format("{}: {}", what, texts::unknown("place", node.text(), "", names)));
  }
  constexpr std::string_view wanted = "the name of a place or [x, y]";
  if (node.kind() != Node::Kind::sequence) refuse_kind(node, what, wanted);
  if (node.elements().size() != 2) {
    throw Error(node.where(), fmt::format("{}: {} elements; expected {}", what, node.elements().size(), wanted));
  }
  Place place{Anchor::point, {}};
  for (std::size_t i = 0; i < 2; ++i) {
    place.point[i] = real_within(node.elements()[i], fmt::format("{}.{}", what, i), coordinates, "m");
  }
  return place;
}

Node written(const Place& place) {
  if (place.anchor != Anchor::point) {
    return Node::scalar(anchor_names()[static_cast<std::size_t>(place.anchor)]);
  }
  return sequence_of(place.point, [](double each) { return Node::scalar(real_text(each)); });
}

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

std::string usual_behaviour(const Role& role) {
  const TargetRule& target = role.target;
  const bool moved = target.shift != std::array<double, 2>{} || target.lateral;
  if (target.at && target.at->anchor == Anchor::ball && !moved) return "play_ball";
  return role.name == "goalkeeper" ? "keep_goal" : "support";
}

// Sets waypoints_knowledge and filter_knowledge to tasks.knowledge if the document does not have them.
void follow(TaskRules& tasks, const Node& written) {
  if (!written["waypoints_knowledge"]) tasks.waypoints_knowledge = tasks.knowledge;
  if (!written["filter_knowledge"]) tasks.filter_knowledge = tasks.knowledge;
}

// Reports a role that has one of two reserved names. The names of plugins' metrics begin with these two words, and the
// names of other metrics begin with the name of a role.
void check_name(const std::string& name, const Location& where, const std::string& path, Mistakes& mistakes) {
  if (name != "plugin_totals" && name != "plugin_values") return;
  mistakes.add(Error(where, fmt::format("{}: metrics of plugins are called so; choose another name", name)), path);
}

void check_roles(TeamDocument& page, const Node& document, Mistakes& mistakes) {
  for (RoleList& list : page.team.role_lists) {
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

void check_priorities(const TeamDocument& page, const Node& document, Mistakes& mistakes) {
  const auto context = [&page](std::size_t i) -> const Context& { return page.contexts[i].context; };
  const auto path = [](std::size_t i) { return fmt::format("contexts.{}.priority", i); };
  for (std::size_t i = 0; i < page.contexts.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (context(i).priority != context(j).priority) continue;
      if (mistakes.mistaken(path(i)) || mistakes.mistaken(path(j))) continue;
      const Node element = document["contexts"].elements()[i];
      const Node priority = element["priority"];
      mistakes.add(Error(priority ? priority.where() : element.where(),
                         fmt::format("contexts {} and {} have the same priority {}", context(j).name, context(i).name,
                                     context(i).priority)),
                   path(i));
    }
  }
}

std::string first_of(const std::string& path) { return path.substr(0, path.find('.')); }

bool is_usable(const std::string& key) { return std::ranges::find(usable_keys(), key) != usable_keys().end(); }

// Returns the part of a document that can be changed by `use:`, without `roles` and `targets`.
Node coordination_of(const Node& document) {
  std::vector<Node::Entry> entries;
  for (const Node::Entry& entry : document.entries()) {
    if (entry.key != "roles" && entry.key != "targets" && is_usable(entry.key)) entries.push_back(entry);
  }
  return Node::map(std::move(entries), document.where());
}

int role_list_named(const Node& value, const TeamDocument& page, const std::string& what) {
  const std::vector<std::string> names = texts::names_of(page.team.role_lists, &RoleList::name);
  if (value.kind() != Node::Kind::scalar) throw Error(value.where(), what + ": expected the name of a list of roles");
  const auto found = std::ranges::find(names, value.text());
  if (found == names.end()) throw Error(value.where(), texts::unknown("list of roles", value.text(), "", names));
  return static_cast<int>(found - names.begin());
}

// Returns the error text for a path to a missing term, such as "utility.terms.distnce.weight"; otherwise an empty text.
std::string unknown_term(std::string_view key, const Node& values) {
  constexpr std::string_view terms = "utility.terms.";
  if (!key.starts_with(terms)) return {};
  const std::string_view rest = key.substr(terms.size()), term = rest.substr(0, rest.find('.'));
  const Node known = values["utility"]["terms"];
  if (term.size() == rest.size() || known[term]) return {};
  return texts::unknown("term", term, "utility.terms", texts::names_of(known.entries(), &Node::Entry::key));
}

// Reads the targets of a context into context.targets, by index in `list`. `targets`: a map from roles to targets.
void read_targets(const Node& targets, const RoleList& list, const std::string& what, Context& context,
                  Mistakes& mistakes) {
  std::vector<RoleTarget> read_ones;
  read(declare(read_ones), Node::map({{"targets", targets.where(), targets}}, targets.where()), what, mistakes);
  const std::vector<std::string> names = texts::names_of(list.roles, &Role::name);
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

// Returns the context with its `use:` laid over the team's values. `what`: the path of this `use:`.
Context resolved(const ContextPage& written, const Node& document, const TeamDocument& page, const std::string& what,
                 Mistakes& mistakes) {
  Context context = written.context;
  Node values = coordination_of(document);
  bool list_known = !mistakes.mistaken("roles");
  for (const Node::Entry& entry : written.use.entries()) {
    const std::string first = first_of(entry.key);
    mistakes.attempt(what, [&] {
      if (!is_usable(first)) throw Error(entry.key_where, texts::unknown("key", first, what, usable_keys()));
      if (entry.key == "roles") {
        list_known = false;
        // If a role list could not be read, an unknown name may be the name of this list.
        const bool all_lists =
            !mistakes.mistaken("roles") && page.team.role_lists.size() == document["roles"].entries().size();
        if (!all_lists && entry.value.kind() == Node::Kind::scalar) return;
        context.role_list = role_list_named(entry.value, page, what + ".roles");
        list_known = true;
      } else if (first == "roles") {
        throw Error(entry.key_where, what + ": roles takes the name of a list and has no parts");
      } else if (first == "targets") {
        // The targets are read below, because they need the role list.
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
    read_targets(targets, page.team.role_lists[static_cast<std::size_t>(context.role_list)], what, context, mistakes);
  });
  read(declare(static_cast<Coordination&>(context)), values, "", mistakes);
  follow(context.tasks, values["tasks"]);
  context.use.where = context.where;
  return context;
}

// Returns whether the title stands in the extended document, but the name does not. The document is then another team,
// which must not have this title.
bool is_of_base(const Node& document) {
  const Location &title = document["title"].where(), &name = document["team"].where();
  return title.file != name.file && !title.is_laid();
}

}  // namespace

Node targets_of(const Node& use) {
  Node out;
  for (const Node::Entry& entry : use.entries()) {
    if (first_of(entry.key) != "targets") continue;
    out = with(out ? out : Node::map({}, entry.key_where), entry.key, entry.value, entry.key_where);
  }
  return out["targets"];
}

Node in_context(const Node& document, const Node& use) {
  Node values = coordination_of(document);
  for (const Node::Entry& entry : use.entries()) {
    const std::string first = first_of(entry.key);
    if (first != "roles" && first != "targets") values = with(values, entry.key, entry.value, entry.key_where);
  }
  return values;
}

TeamDocument read_team_document(const Node& document, Mistakes& mistakes) {
  TeamDocument page;
  read(declare(page), document, "", mistakes);
  follow(page.coordination.tasks, document["tasks"]);
  check_roles(page, document, mistakes);
  check_priorities(page, document, mistakes);
  return page;
}

template <>
Team read_document<Team>(const Node& document, Mistakes& mistakes) {
  require_kind(document, DocumentKind::team);
  TeamDocument page = read_team_document(document, mistakes);
  Team& team = page.team;
  const Mistakes of_page = mistakes;
  for (std::size_t i = 0; i < page.contexts.size(); ++i) {
    // Each context lays its `use:` over the team's values. If the value of one context is wrong, the team's value at
    // this path must not count as wrong for the other contexts. So each context has its own copy of the mistakes.
    Mistakes of_context = of_page;
    team.contexts.push_back(resolved(page.contexts[i], document, page, fmt::format("contexts.{}.use", i), of_context));
    mistakes.take_over(of_context);
  }
  std::ranges::stable_sort(team.contexts, std::ranges::greater(), &Context::priority);
  if (team.title.empty() || is_of_base(document)) team.title = team.name;
  team.file = document.where().file;
  const Node without_role = document["behaviour_without_role"];
  team.behaviour_without_role_where = without_role ? without_role.where() : document.where();
  team.where = document.where();
  return std::move(team);
}

}  // namespace regista::config
