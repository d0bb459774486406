// SPDX-License-Identifier: MIT
// `regista config draw TEAM`: a picture of where the rules of a team's roles put them, for one ball or several.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "cli/plugin_folders.hpp"
#include "config/carpet.hpp"
#include "config/documents.hpp"
#include "config/parse.hpp"
#include "config/place.hpp"
#include "config/team_page.hpp"
#include "output/output.hpp"
#include "output/output_files.hpp"
#include "output/replaced_file.hpp"
#include "recording/roles_svg.hpp"
#include "texts/message.hpp"

namespace regista::cli {
namespace {

constexpr auto config_draw_examples = R"(Examples:
  regista config draw configs/teams/paper.yaml --ball 1,1 -o roles.svg
  regista config draw configs/teams/paper.yaml --role libero --ball=-3,-1 --ball 0,0 --ball 3,2 -o libero.svg
  regista config draw configs/teams/paper.yaml --list searching --no-ball -o searching.svg
  regista config draw configs/teams/regista.yaml --context own_corner_near --ball 4.5,3 -o corner.svg

Positions are in metres from the centre of the field: x towards the opponent's goal, y to the left. Without --ball the ball lies
in the centre. It is drawn where a role goes before a task is moved towards a waypoint. With --context NAME the roles of
that context are drawn, at the targets it gives them. So no plugin is needed; --plugins may be given and changes nothing. A drawing replaces an older drawing in the same file.)";

struct ConfigDrawOptions {
  std::vector<std::string> files, overrides, roles, balls, plugins;
  std::string list, context, rules, output;
  bool no_ball = false, force = false;
};

std::array<double, 2> place(const std::string& text) {
  const config::Location where{"--ball " + text, 0, 0};
  const config::Place read = config::to_place(config::parse_value("[" + text + "]", where), "where the ball is");
  return read.point;
}

const config::RoleList& list_of(const config::TeamPage& page, const std::string& name) {
  if (name.empty()) return page.role_lists.front();
  const auto found = std::ranges::find(page.role_lists, name, &config::RoleList::name);
  if (found != page.role_lists.end()) return *found;
  std::vector<std::string> names;
  for (const config::RoleList& each : page.role_lists) names.push_back(each.name);
  throw BadInput("--list: " + texts::unknown("list of roles", name, "", names));
}

// The roles of a context, where it has them played.
config::RoleList list_in(const config::Node& document, const std::string& name) {
  const config::Team team = config::read_document<config::Team>(document);
  const auto context = std::ranges::find(team.contexts, name, &config::Context::name);
  if (context == team.contexts.end()) {
    std::vector<std::string> names;
    for (const config::Context& each : team.contexts) names.push_back(each.name);
    throw BadInput("--context: " + texts::unknown("context", name, "", names));
  }
  config::RoleList list = team.role_lists[static_cast<std::size_t>(context->role_list)];
  for (std::size_t i = 0; i < list.roles.size(); ++i) {
    list.roles[i].target = context->target_of(i, list.roles[i]);
  }
  return list;
}

bool has(const config::RoleList& list, const std::string& role) {
  return std::ranges::find(list.roles, role, &config::Role::name) != list.roles.end();
}

[[noreturn]] void refuse_role(const config::TeamPage& page, const config::RoleList& list, const std::string& role) {
  for (const config::RoleList& other : page.role_lists) {
    if (has(other, role)) {
      throw BadInput(fmt::format("--role: {0} is in the list {1}, not in {2}; add --list {1}", texts::one_line(role),
                                 other.name, list.name));
    }
  }
  std::vector<std::string> names;
  for (const config::Role& each : list.roles) names.push_back(each.name);
  throw BadInput("--role: " + texts::unknown("role", role, list.name, names));
}

std::vector<const config::Role*> roles_of(const config::TeamPage& page, const config::RoleList& list,
                                          const std::vector<std::string>& wanted) {
  for (const std::string& each : wanted) {
    if (!has(list, each)) refuse_role(page, list, each);
  }
  std::vector<const config::Role*> out;
  for (const config::Role& each : list.roles) {
    if (wanted.empty() || std::ranges::find(wanted, each.name) != wanted.end()) out.push_back(&each);
  }
  return out;
}

int draw(const ConfigDrawOptions& options, const output::OutputFiles& outputs) {
  if (options.files.size() != 1) {
    throw BadInput(fmt::format("config draw: expected one file of a team, {} given", options.files.size()));
  }
  if (options.no_ball && !options.balls.empty()) throw BadInput("--no-ball and --ball: one of them");
  if (!options.context.empty() && !options.list.empty()) throw BadInput("--context and --list: one of them");
  if (options.output.empty()) throw BadInput("config draw: where to? Say -o FILE.svg");
  const config::Node document = config::load(options.files.front(), config::typed_overrides(options.overrides));
  config::require_kind(document, config::DocumentKind::team);
  const config::TeamPage page = config::read_team_page(document);
  const config::Rules rules =
      options.rules.empty() ? config::Rules{} : config::read_document<config::Rules>(options.rules);
  const config::RoleList list =
      options.context.empty() ? list_of(page, options.list) : list_in(document, options.context);
  const std::vector<const config::Role*> roles = roles_of(page, list, options.roles);
  const std::string shown = options.context.empty() ? "the list " + list.name : "the context " + options.context;
  std::vector<std::array<double, 2>> balls;
  const config::Carpet carpet(rules.field);
  for (const std::string& each : options.balls) {
    balls.push_back(place(each));
    if (!carpet.holds(balls.back())) complain(fmt::format("warning: --ball {}: {}", each, carpet.off()));
  }
  if (balls.empty() && !options.no_ball) balls.push_back({0.0, 0.0});
  outputs.check(options.force);
  const std::string picture = recording::roles_svg({page.name, shown, roles, balls}, rules.field);
  if (options.output == "-") {
    output::print(picture);
    return exit_done;
  }
  output::write_whole(options.output, picture, output::Existing::replaced);  // what may not be was refused above
  output::print(options.output + '\n');
  return exit_done;
}

}  // namespace

void add_config_draw(Command& parent) {
  Command& command = parent.add("draw", "draw where a team's roles stand for a ball");
  const auto options = std::make_shared<ConfigDrawOptions>();
  command.take("team", options->files, "FILE", "a team's file", Reads::documents);
  command.take("--ball", options->balls, "X,Y", "where the ball is, in metres; may be repeated");
  command.flag("--no-ball", options->no_ball, "nobody knows the ball");
  command.take("--list", options->list, "NAME", "list of roles; default: the first one");
  command.take("--context", options->context, "NAME", "the roles of this context, where it has them played");
  command.take("--role", options->roles, "NAME", "this role alone, with what its rule is made of; may be repeated");
  command.take("--rules", options->rules, "FILE",
               "rules profile, for the size of the field; default: spl2023, built in", Reads::documents);
  command.take("--set", options->overrides, "PATH=VALUE", "a value laid over the team; may be repeated");
  add_plugin_folders(command, options->plugins);
  command.take("-o,--output", options->output, "FILE", "write this file, - for standard output", Writes::drawing);
  command.flag("--force", options->force, "replace a page or another picture");
  command.notes(config_draw_examples);
  command.run = [options, &command] { return draw(*options, output::OutputFiles(command.given(), "command")); };
}

}  // namespace regista::cli
