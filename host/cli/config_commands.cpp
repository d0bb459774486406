// SPDX-License-Identifier: MIT
// `regista config check`, `show`, `diff`, `schema`, `reference`, `copy` and `draw`: commands for documents.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <system_error>

#include "cli/common_options.hpp"
#include "config/documents.hpp"
#include "config/parse.hpp"
#include "config/rules.hpp"
#include "config/team.hpp"
#include "config/team_check.hpp"
#include "config/team_document.hpp"
#include "output/output_files.hpp"
#include "output/replaced_file.hpp"
#include "plugin/info.hpp"
#include "recording/field_svg.hpp"
#include "report/number.hpp"
#include "study/document_check.hpp"
#include "texts/json.hpp"
#include "texts/message.hpp"

namespace regista::cli {
namespace {

// --- `regista config check FILE...`: checks documents (study/document_check.hpp).

using report::Json;

constexpr auto config_check_examples = R"(Examples:
  regista config check configs/teams/paper.yaml
  regista config check configs/*/*.yaml
  regista config check small_field/*.yaml --rules small_field.yaml
  regista config check configs/teams/*.yaml --json

Every mistake of a document is printed, in the order of its lines; of text that is not YAML, only the first.

Exit codes: 0 all are sound; 2 one is not, or there is nothing to check.)";

constexpr std::size_t most_printed = 100;  // mistakes printed per document; --json prints all that the check kept

struct ConfigCheckOptions {
  std::vector<std::string> files, plugins;
  std::string rules, robot;  // paths of files; empty: the built-in values
  bool json = false;
};

void print(const study::DocumentCheck& checked) {
  const std::size_t all = checked.mistakes.size() + checked.more,
                    printed = std::min(checked.mistakes.size(), most_printed);
  for (std::size_t i = 0; i < printed; ++i) complain(checked.mistakes[i].line);
  if (all > printed) complain(fmt::format("{}: ... and {} more", checked.file, all - printed));
  for (const config::Warning& each : checked.warnings) complain(to_string(each));
  if (all == 0) output::print(fmt::format("{}: {}, sound\n", checked.file, checked.kind));
}

Json placed(const config::Location& where, const std::string& message) {
  return {{"file", where.file}, {"line", where.line}, {"column", where.column}, {"message", message}};
}

Json as_json(const study::DocumentCheck& checked) {
  Json mistakes = Json::array(), warnings = Json::array();
  for (const study::DocumentMistake& each : checked.mistakes) mistakes.push_back(placed(each.where, each.message));
  for (const config::Warning& each : checked.warnings) warnings.push_back(placed(each.where, each.message));
  return {{"file", checked.file},
          {"kind", checked.kind.empty() ? Json() : Json(checked.kind)},
          {"sound", checked.mistakes.empty()},
          {"mistakes", mistakes},
          {"mistakes_left_out", checked.more},
          {"warnings", warnings}};
}

int check(const ConfigCheckOptions& options, const Invocation& invocation) {
  if (options.files.empty()) throw BadInput("config check: expected at least one file");
  const plugin::Catalogue catalogue = open_plugins(options.plugins, invocation);
  study::Profiles by;
  if (!options.rules.empty()) by.rules = config::read_document<config::Rules>(options.rules);
  if (!options.robot.empty()) by.robots.fill(config::read_document<config::Robot>(options.robot));
  std::vector<study::StudyCheck> studies;
  for (const results::StudyKind& kind : invocation.studies) {
    studies.push_back({kind.document, [&](const config::Node& document, config::Mistakes& mistakes) {
                         kind.plan(document, options.plugins, catalogue, mistakes);
                       }});
  }
  bool sound = true;
  Json documents = Json::array();
  for (const std::string& file : options.files) {
    const study::DocumentCheck checked = study::check_document(file, by, catalogue, studies);
    sound = sound && checked.mistakes.empty();
    if (options.json)
      documents.push_back(as_json(checked));
    else
      print(checked);
  }
  if (options.json) output::print(report::text_of({{"documents", documents}}, 2));
  return sound ? exit_done : exit_bad_input;
}

// --- `regista config show FILE`: shows a document with every value in force, its unit, meaning and origin.

constexpr auto config_show_examples = R"(Examples:
  regista config show configs/rules/spl2023.yaml
  regista config show configs/teams/paper.yaml --set sender.params.reserve=60)";

std::string shown(const config::Node& document, const config::DocumentKind& kind, const PlainOptions& options,
                  config::Remarks remarks, const Invocation& invocation) {
  std::vector<config::PluginDeclaration> plugins;  // only teams and studies name plugins
  if (kind == config::DocumentKind::team || kind == config::DocumentKind::predictor_study)
    plugins = plugin::declarations(open_plugins(options.plugins, invocation).plugins());
  return config::show(document, kind, plugins, remarks);
}

int show(const PlainOptions& options, const Invocation& invocation) {
  const std::string& file = the_only(options.words, "config show: expected one file");
  const config::Node document = config::load(file, config::typed_overrides(options.set));
  output::print(shown(document, results::kind_of(document, invocation), options, config::Remarks::with, invocation));
  return exit_done;
}

// --- `regista config diff A B`: the values in force in which two documents of one kind differ.

constexpr auto config_diff_examples = R"(Examples:
  regista config diff paper spqr2023
  regista config diff configs/rules/spl2023.yaml my_rules.yaml

A line names a value by its path, which --set takes as well, with the value of the first document and that of the second; - is
no value.

Exit codes: 0 they are equal; 1 they differ; 2 they cannot be read or compared.)";

int diff(const PlainOptions& options, const Invocation& invocation) {
  if (options.words.size() != 2)
    throw BadInput(fmt::format("config diff: expected two files, {} given", options.words.size()));
  std::array<config::Node, 2> documents, in_force;
  std::array<std::string, 2> kinds;
  for (std::size_t i = 0; i < documents.size(); ++i) {
    documents[i] = config::load(options.words[i]);
    const config::DocumentKind& kind = results::kind_of(documents[i], invocation);
    kinds[i] = kind.name;
    in_force[i] =
        config::parse_text(shown(documents[i], kind, options, config::Remarks::without, invocation), options.words[i]);
  }
  if (kinds[0] != kinds[1])
    throw BadInput(fmt::format("config diff: {} is of the kind {}, and {} is of the kind {}", options.words[0],
                               kinds[0], options.words[1], kinds[1]));
  const std::vector<config::Difference> found = config::differences(in_force[0], in_force[1]);
  Json lines = Json::array();
  const auto value = [](const std::string& text) { return text.empty() ? Json() : Json(text); };
  for (const config::Difference& each : found) {
    lines.push_back({{"path", each.path}, {"first", value(each.first)}, {"second", value(each.second)}});
    const auto in_words = [](const std::string& text) { return text.empty() ? "-" : text; };
    if (!options.json)
      output::print(fmt::format("{}: {} | {}\n", each.path, in_words(each.first), in_words(each.second)));
  }
  if (options.json) output::print(report::text_of(lines, 2));
  return found.empty() ? exit_done : exit_no;
}

// --- `regista config schema KIND`: prints the JSON Schema of a kind of document, for completion and checks in editors.

constexpr auto config_schema_examples = R"(Examples:
  regista config schema team > team.schema.json)";

int schema(const PlainOptions& options, const Invocation& invocation) {
  const std::string expected = "config schema: expected one of " + texts::join(results::kind_names(invocation));
  const config::DocumentKind kind = results::kind_named(the_only(options.words, expected), "config schema", invocation);
  const plugin::Catalogue catalogue = open_plugins(options.plugins, invocation);
  output::print(config::schema(kind, plugin::declarations(catalogue.plugins())));
  return exit_done;
}

// --- `regista config reference`: prints a Markdown text about all kinds of documents.

constexpr auto config_reference_examples = R"(Examples:
  regista config reference > docs/config-reference.md
  regista config reference team)";

// --- `regista config copy FOLDER`: copies the shipped documents for the user's own changes.

namespace fs = std::filesystem;

constexpr auto config_copy_examples = R"(Examples:
  regista config copy configs

The folder must not exist yet. It gets the teams, rules, robots, disturbances, openings, formations and studies that belong to this
program; examples of other commands name them as configs/teams/paper.yaml.)";

int copy(const std::vector<std::string>& folders, const Invocation& invocation) {
  const fs::path to = the_only(folders, "config copy: expected one folder");
  const fs::path from = invocation.own("share/regista/configs");
  std::error_code error;
  if (!fs::is_directory(from, error))
    throw BadInput(fmt::format("config copy: {} is missing: this program was not installed as a whole", from.string()));
  if (fs::exists(fs::symlink_status(to, error)))
    throw BadInput(fmt::format("config copy: {} exists already; name another folder", to.string()));
  if (!fs::create_directory(to, error))
    throw BadInput(fmt::format("config copy: cannot make {}: {}", to.string(), error.message()));
  fs::copy(from, to, fs::copy_options::recursive, error);
  if (error) {
    std::error_code none;
    fs::remove_all(to, none);
    throw output::WriteError(fmt::format("cannot write {}: {}", to.string(), error.message()));
  }
  output::print(fmt::format("made the folder {}\n", to.string()));
  return exit_done;
}

// --- `regista config draw TEAM`: draws the places of a team's roles for one or several places of the ball.

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

// Returns the thing with this name. Throws BadInput if there is none. what: the kind of thing.
template <class Thing>
const Thing& named(const std::vector<Thing>& things, const std::string& name, const char* option, const char* what) {
  const auto found = std::ranges::find(things, name, &Thing::name);
  if (found != things.end()) return *found;
  throw BadInput(option + texts::unknown(what, name, "", texts::names_of(things, &Thing::name)));
}

// Returns a context's list of roles, with the context's targets.
config::RoleList list_in(const config::Node& document, const std::string& name) {
  const config::Team team = config::read_document<config::Team>(document);
  const config::Context& context = named(team.contexts, name, "--context: ", "context");
  config::RoleList list = team.role_lists[static_cast<std::size_t>(context.role_list)];
  for (std::size_t i = 0; i < list.roles.size(); ++i) {
    list.roles[i].target = context.target_of(i, list.roles[i]);
  }
  return list;
}

bool has(const config::RoleList& list, const std::string& role) {
  return std::ranges::find(list.roles, role, &config::Role::name) != list.roles.end();
}

[[noreturn]] void refuse_role(const config::Team& team, const config::RoleList& list, const std::string& role) {
  for (const config::RoleList& other : team.role_lists) {
    if (has(other, role)) {
      throw BadInput(fmt::format("--role: {0} is in the list {1}, not in {2}; add --list {1}", texts::one_line(role),
                                 other.name, list.name));
    }
  }
  throw BadInput("--role: " +
                 texts::unknown("role", role, list.name, texts::names_of(list.roles, &config::Role::name)));
}

std::vector<const config::Role*> roles_of(const config::Team& team, const config::RoleList& list,
                                          const std::vector<std::string>& wanted) {
  for (const std::string& each : wanted) {
    if (!has(list, each)) refuse_role(team, list, each);
  }
  std::vector<const config::Role*> out;
  for (const config::Role& each : list.roles) {
    if (wanted.empty() || std::ranges::find(wanted, each.name) != wanted.end()) out.push_back(&each);
  }
  return out;
}

int draw(const ConfigDrawOptions& options, const output::OutputFiles& outputs) {
  const std::string& file = the_only(options.files, "config draw: expected one file of a team");
  if (options.no_ball && !options.balls.empty()) throw BadInput("--no-ball and --ball: one of them");
  if (!options.context.empty() && !options.list.empty()) throw BadInput("--context and --list: one of them");
  if (options.output.empty()) throw BadInput("config draw: where to? Say -o FILE.svg");
  const config::Node document = config::load(file, config::typed_overrides(options.overrides));
  if (config::kind_of(document) == config::DocumentKind::opening) {
    throw config::Error(document.where(),
                        "this is an opening, and config draw draws a team; a recording of a game that "
                        "starts from an opening draws it: see docs/openings.md");
  }
  config::require_kind(document, config::DocumentKind::team);
  config::Mistakes first(config::Mistakes::After::stop);
  const config::Team team = config::read_team_document(document, first).team;
  const config::Rules rules =
      options.rules.empty() ? config::Rules{} : config::read_document<config::Rules>(options.rules);
  const config::RoleList list = !options.context.empty() ? list_in(document, options.context)
                                : options.list.empty()
                                    ? team.role_lists.front()
                                    : named(team.role_lists, options.list, "--list: ", "list of roles");
  const std::vector<const config::Role*> roles = roles_of(team, list, options.roles);
  const std::string shown = options.context.empty() ? "the list " + list.name : "the context " + options.context;
  std::vector<std::array<double, 2>> balls;
  const config::Carpet field_margin(rules.field);
  for (const std::string& each : options.balls) {
    const config::Node place = config::parse_value("[" + each + "]", {"--ball " + each, 0, 0});
    balls.push_back(config::to_place(place, "where the ball is").point);
    if (!field_margin.holds(balls.back())) complain(fmt::format("warning: --ball {}: {}", each, field_margin.off()));
  }
  if (balls.empty() && !options.no_ball) balls.push_back({0.0, 0.0});
  outputs.check(options.force);
  const std::string picture = recording::roles_svg({team.name, shown, roles, balls}, rules.field);
  if (options.output == "-") {
    output::print(picture);
    return exit_done;
  }
  output::write_whole(options.output, picture, output::Existing::replaced);  // check() refused files of other kinds
  output::print(options.output + '\n');
  return exit_done;
}

}  // namespace

void add_config_check(Command& parent, const Invocation& invocation) {
  Command& command =
      parent.add("check", "say what is wrong with rules, robots, disturbances, openings, teams and studies");
  const auto options = std::make_shared<ConfigCheckOptions>();
  command.take("files", options->files, "FILE", "documents of any kind", Reads::documents);
  command.take("--rules", options->rules, "FILE",
               "rules that openings and teams must go with; default: spl2023, built in", Reads::documents);
  command.take("--robot", options->robot, "FILE", "robot that openings and teams must go with; default: nao, built in",
               Reads::documents);
  command.flag("--json", options->json, "every mistake and warning as JSON, on standard output");
  add_plugin_folders(command, options->plugins);
  command.notes(config_check_examples);
  command.run = [options, &invocation] { return check(*options, invocation); };
}

void add_config_show(Command& parent, const Invocation& invocation) {
  Command& command = parent.add("show", "write a document with every value that is in force");
  const auto options = std::make_shared<PlainOptions>();
  command.take("file", options->words, "FILE", "a document of any kind", Reads::documents);
  command.take("--set", options->set, "PATH=VALUE", "a value laid over the document; may be repeated");
  add_plugin_folders(command, options->plugins);
  command.notes(config_show_examples);
  command.run = [options, &invocation] { return show(*options, invocation); };
}

void add_config_diff(Command& parent, const Invocation& invocation) {
  Command& command = parent.add("diff", "list the values in force in which two documents differ");
  const auto options = std::make_shared<PlainOptions>();
  command.take("files", options->words, "A.yaml B.yaml", "two documents of one kind", Reads::documents);
  command.flag("--json", options->json, "the differences as JSON");
  add_plugin_folders(command, options->plugins);
  command.notes(config_diff_examples);
  command.run = [options, &invocation] { return diff(*options, invocation); };
}

void add_config_schema(Command& parent, const Invocation& invocation) {
  Command& command = parent.add("schema", "write the JSON Schema of a kind of document");
  const auto options = std::make_shared<PlainOptions>();
  command.choose("kind", options->words, results::kind_names(invocation), texts::join(results::kind_names(invocation)));
  add_plugin_folders(command, options->plugins);
  command.notes(config_schema_examples);
  command.run = [options, &invocation] { return schema(*options, invocation); };
}

void add_config_reference(Command& parent, const Invocation& invocation) {
  Command& command = parent.add("reference", "write the reference of all kinds of documents as Markdown");
  const auto kinds = std::make_shared<std::vector<std::string>>();
  command.choose("kind", *kinds, results::kind_names(invocation), "these kinds alone");
  command.notes(config_reference_examples);
  command.run = [kinds, &invocation] {
    std::vector<config::DocumentKind> wanted;
    for (const std::string& each : *kinds) wanted.push_back(results::kind_named(each, "config reference", invocation));
    output::print(config::reference_text(wanted.empty() ? results::document_kinds(invocation) : wanted));
    return exit_done;
  };
}

void add_config_copy(Command& parent, const Invocation& invocation) {
  Command& command = parent.add("copy", "copy the shipped documents into a folder of your own");
  const auto folders = std::make_shared<std::vector<std::string>>();
  command.take("folder", *folders, "NEW_FOLDER", "is made");
  command.notes(config_copy_examples);
  command.run = [folders, &invocation] { return copy(*folders, invocation); };
}

void add_config_draw(Command& parent, const Invocation& /*invocation*/) {
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
  command.run = [options, &command] { return draw(*options, command.outputs("command")); };
}

}  // namespace regista::cli
