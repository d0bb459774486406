// SPDX-License-Identifier: MIT
// The commands `regista plugin list`, `info`, `reference`, `new` and `check`.
#include <fmt/format.h>
#include <regista/abi.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <sstream>
#include <system_error>

#include "check/perturbed_rerun.hpp"
#include "check/plugin_check.hpp"
#include "cli/common_options.hpp"
#include "config/errors.hpp"
#include "config/node.hpp"
#include "config/scalar.hpp"
#include "output/new_plugin.hpp"
#include "output/replaced_file.hpp"
#include "plugin/description.hpp"
#include "plugin/info.hpp"
#include "process/child.hpp"
#include "report/metric_reference.hpp"
#include "report/number.hpp"
#include "texts/json.hpp"
#include "texts/message.hpp"

namespace regista::cli {
namespace {

using report::Json;

// --- `regista plugin list`: lists the plugins, the refused files and the searched folders.

constexpr auto plugin_list_examples = R"(Examples:
  regista plugin list
  regista plugin list --plugins ~/my_plugins --json)";

std::string list_json(const plugin::Catalogue& catalogue) {
  Json plugins = Json::array(), refused = Json::array();
  for (const plugin::Found& found : catalogue.plugins()) plugins.push_back(report::plugin_json(found));
  for (const plugin::Refused& each : catalogue.refused()) {
    refused.push_back({{"file", each.file.string()}, {"reason", each.reason}});
  }
  return report::text_of({{"plugins", plugins}, {"refused", refused}, {"searched", folders_of(catalogue)}});
}

// --- `regista plugin info ID`: prints the declaration of a plugin, its parameters first.

constexpr auto plugin_info_examples = R"(Examples:
  regista plugin info greedy
  regista plugin info voronoi --json)";

// Returns all plugins with this id. There may be several, because two folders may hold two builds of a plugin.
std::vector<const plugin::Found*> find(const plugin::Catalogue& catalogue, const std::string& id) {
  std::vector<const plugin::Found*> found;
  for (const plugin::Found& plugin : catalogue.plugins()) {
    if (plugin.descriptor->id == id) found.push_back(&plugin);
  }
  if (!found.empty()) return found;
  const auto known = texts::names_of(catalogue.plugins(), [](const auto& each) { return each.descriptor->id; });
  throw BadInput(fmt::format("plugin info: {}; searched: {}", texts::unknown("plugin", id, "", known),
                             texts::join(folders_of(catalogue))));
}

int describe(const PlainOptions& options, const Invocation& invocation) {
  const std::string& id =
      the_only(options.words, "plugin info: expected one id of a plugin", "; see: regista plugin list");
  const plugin::Catalogue catalogue = open_plugins(options.plugins, invocation);
  std::string out;
  auto json = Json::array();
  for (const plugin::Found* plugin : find(catalogue, id)) {
    if (!out.empty()) out += '\n';
    out += plugin::info_text(*plugin);
    json.push_back(report::plugin_json(*plugin));
  }
  output::print(options.json ? report::text_of(json) : out);
  return exit_done;
}

// --- `regista plugin reference`: prints a Markdown text about all plugins.

constexpr auto plugin_reference_examples = R"(Examples:
  regista plugin reference > docs/plugin-reference.md
  regista plugin reference --plugins ~/my_plugins)";

// --- `regista plugin new KIND NAME`: writes a folder with a new plugin, tests and a team, ready to build.

namespace fs = std::filesystem;

constexpr auto plugin_new_examples = R"(Examples:
  regista plugin new predictor my_ball
  regista plugin new assigner my_auction --lang c
  regista plugin new utility my_term -o ~/plugins

It makes the folder NAME with the plugin's source, a build for CMake, a unit test, a contract test, a team that uses the plugin, and a
README with the next commands. Nothing is written over. What the plugin does is small and works: change it.)";

// The kinds of plugins, in the order of the steps of a decision.
const std::vector<std::string> kinds{"predictor", "context",   "positioner", "utility",
                                     "assigner",  "behaviour", "sender"};
const std::vector<std::string> languages{"c++", "c"};

struct PluginNewOptions {
  std::string kind, name, language = "c++", folder;
};

void refuse_unknown(std::string_view what, const std::string& asked, const std::vector<std::string>& known) {
  if (std::ranges::find(known, asked) != known.end()) return;
  throw BadInput("plugin new: " + texts::unknown(what, asked, "", known));
}

// Refuses the name of an existing plugin, because both would install one file, so a team could not choose between them.
void refuse_name_in_use(const std::string& name, const Invocation& invocation) {
  const plugin::Catalogue catalogue = open_plugins({}, invocation);
  for (const plugin::Found& found : catalogue.plugins()) {
    if (found.descriptor->id != name) continue;
    throw BadInput(
        fmt::format("plugin new: there is a plugin {} already, in {}; choose another name", name, found.file.string()));
  }
}

std::string in_shell(const std::string& word) { return process::shell_line({word}); }

// Returns the word as a quoted argument of CMake.
std::string in_cmake(const std::string& word) { return '"' + texts::with_backslashes(word, "\"\\$") + '"'; }

// How CMake finds the program's SDK.
struct Sdk {
  std::string hints;     // hints of find_package()
  std::string commands;  // shell commands up to and with `cmake -B build`
};

Sdk sdk_of(const Invocation& invocation) {
  std::error_code none;
  const fs::path prefix = invocation.own(".").lexically_normal();
  const std::string configure = "cmake -B build";
  if (!fs::exists(invocation.own("lib/cmake/regista/regista-config.cmake"), none)) {
    // The program is in a build folder, so the user must first install the SDK.
    return {"",
            fmt::format("cmake --install {} --prefix ~/regista --component sdk\n{} -DCMAKE_PREFIX_PATH=$HOME/regista",
                        in_shell(prefix.parent_path().string()), configure)};
  }
  return {" HINTS " + in_cmake(prefix.parent_path().string()), configure};
}

int make(const PluginNewOptions& options, const Invocation& invocation) {
  if (options.kind.empty()) throw BadInput("plugin new: which kind? There are: " + texts::join(kinds));
  refuse_unknown("kind", options.kind, kinds);
  refuse_unknown("language", options.language, languages);
  if (const std::string wrong = output::wrong_with_new_name(options.name); !wrong.empty())
    throw BadInput("plugin new: " + wrong);
  refuse_name_in_use(options.name, invocation);

  const fs::path templates = invocation.own("share/regista/templates");
  const fs::path paper = invocation.own("share/regista/configs/teams/paper.yaml");
  std::error_code none;
  for (const fs::path& needed : {templates, paper}) {
    if (fs::exists(needed, none)) continue;
    throw BadInput(fmt::format("plugin new: {} is missing: Regista's SDK and program have to be installed in one place",
                               needed.string()));
  }

  const Sdk sdk = sdk_of(invocation);
  const std::string commands = fmt::format(
      "{} && cmake --build build\nctest --test-dir build --output-on-failure\n"
      "regista match team.yaml {} --plugins build",
      sdk.commands, in_shell(paper.string()));
  const std::vector<output::NewFile> files =
      output::files_from_template(templates, options.kind, options.language,
                                  {{"NAME", options.name},
                                   {"KIND", options.kind},
                                   {"PLUGIN", config::flow_text(options.name, false)},
                                   {"PAPER", config::flow_text(paper.string(), true)},
                                   {"HINTS", sdk.hints},
                                   {"INTERFACE", fmt::format("{}.{}", REGISTA_ABI_MAJOR, REGISTA_ABI_MINOR)},
                                   {"COMMANDS", commands}});
  const fs::path folder = fs::path(options.folder) / options.name;
  output::write_new_folder(folder, files);

  std::string out = fmt::format("made {}:\n", folder.string());
  for (const output::NewFile& file : files) out += fmt::format("  {}\n", file.name);
  out += fmt::format("\nnext:\n  cd {}\n", in_shell(folder.string()));
  std::istringstream lines(commands);
  for (std::string line; std::getline(lines, line);) out += fmt::format("  {}\n", line);
  output::print(out);
  return exit_done;
}

// --- `regista plugin check FILE.so`: checks the promises that a plugin must keep.

constexpr auto plugin_check_examples = R"(Examples:
  regista plugin check build/my_assigner.so
  regista plugin check build/my_assigner.so --only promises --only imports
  regista plugin check build/my_assigner.so --may-idle --set at_least=0.3
  regista plugin check build/*.so --json
  gdb --args regista plugin check build/my_assigner.so --only assigner.promises --in-process

The file may be of any language. First it is looked at without running it; then each check opens it in a process of its own, so
that a plugin that crashes, hangs or leaves threads behind is named and the other checks go on. The checks of a kind
are those of the testkit: empty teams, one robot, robots in one place, many tasks and few, the ends of all ranges of
parameters, structs and arrays that have grown, what is not declared to be read.

pass: sound; warn: may be meant, and may go wrong elsewhere; fail: breaks a promise of <regista/abi.h>; crash: the process of
the check died or had to be ended; skip: nothing to check.)";

struct PluginCheckOptions {
  std::vector<std::string> files, only, plugins, parameters;
  std::string processor_seconds = "10", seed = "0";
  bool may_idle = false, in_process = false, json = false;
};

constexpr auto perturbed_command = "check-elsewhere";

check::Options options_of(const PluginCheckOptions& options, const Invocation& invocation) {
  check::Options out;
  out.perturbed = {"regista", "plugin", perturbed_command};
  out.visitors = invocation.own("lib/regista/plugins");
  out.only = options.only;
  out.plugins = options.plugins;
  out.may_idle = options.may_idle;
  out.in_process = options.in_process;
  out.seed = static_cast<std::uint64_t>(config::parse_whole("--seed", options.seed, 0, 1'000'000'000));
  out.deadline.processor_seconds =
      static_cast<int>(config::parse_whole("--processor-seconds", options.processor_seconds, 1, 1'000'000));
  for (const std::string& each : options.parameters) {
    const std::size_t sign = each.find('=');
    if (sign == std::string::npos || sign == 0) {
      throw BadInput(fmt::format("--set {}: expected NAME=VALUE", texts::in_quotes(each)));
    }
    out.parameters.emplace_back(each.substr(0, sign), each.substr(sign + 1));
  }
  return out;
}

std::string text_of(const check::Verdict& verdict) {
  std::string out = fmt::format("  {:<5}  {:<24}  {}\n", check::word(verdict.status), verdict.check, verdict.promise);
  for (const std::string& line : verdict.lines) out += fmt::format("           {}\n", line);
  return out;
}

std::string summary_of(const check::Report& report) {
  std::string out = fmt::format("{}: {}", report.file, texts::plural(report.verdicts.size(), "check", "checks"));
  for (const check::Status status :
       {check::Status::pass, check::Status::warn, check::Status::fail, check::Status::crash, check::Status::skip}) {
    const auto count = std::ranges::count(report.verdicts, status, &check::Verdict::status);
    if (count > 0) out += fmt::format(", {} {}", count, check::word(status));
  }
  return out + '\n';
}

Json json_of(const check::Report& report) {
  Json checks = Json::array();
  for (const check::Verdict& each : report.verdicts) {
    checks.push_back({{"plugin", each.plugin.empty() ? Json(nullptr) : Json(each.plugin)},
                      {"check", each.check},
                      {"status", check::word(each.status)},
                      {"promise", each.promise},
                      {"lines", each.lines},
                      {"seconds", each.seconds}});
  }
  return {{"file", report.file}, {"passed", report.passed()}, {"checks", checks}};
}

int run(const PluginCheckOptions& options, const Invocation& invocation) {
  if (options.files.empty())
    throw BadInput("plugin check: which file? Name a shared object, such as build/my_plugin.so");
  const check::Options wanted = options_of(options, invocation);
  check::Listener listener;
  std::string plugin = "none yet";
  if (!options.json) {
    listener.verdict = [&](const std::string& file, const check::Verdict& verdict) {
      if (verdict.plugin != plugin) output::print((verdict.plugin.empty() ? file : verdict.plugin) + '\n');
      plugin = verdict.plugin;
      output::print(text_of(verdict));
    };
    listener.report = [&](const check::Report& report) {
      output::print(summary_of(report));
      plugin = "none yet";
    };
  }
  const std::vector<check::Report> reports =
      check::check_files({options.files.begin(), options.files.end()}, wanted, listener);
  if (options.json) {
    auto json = Json::array();
    for (const check::Report& each : reports) json.push_back(json_of(each));
    output::print(report::text_of(json, 2));
  }
  return std::ranges::all_of(reports, &check::Report::passed) ? exit_done : exit_no;
}

// Adds the hidden command with which the check `elsewhere` starts the program again.
void add_perturbed(Command& parent) {
  Command& command = parent.add(perturbed_command, "a course of a plugin that is checked");
  command.hidden = true;
  const auto words = std::make_shared<std::vector<std::string>>();
  command.take("words", *words, "WORD", "what to play, and where to tell it", Reads::data);
  command.run = [words]() -> int {
    if (words->size() < 2) throw BadInput("this command is for the program itself");
    const std::string note = std::move(words->back());
    words->pop_back();
    const std::string answer = std::move(words->back());
    words->pop_back();
    const check::Elsewhere what = check::Elsewhere::of(*words);
    check::answer_as_a_child(answer, note,
                             [&](check::Underway& shared) { return check::play_perturbed(what, shared); });
  };
}

}  // namespace

void add_plugin_list(Command& parent, const Invocation& invocation) {
  Command& command = parent.add("list", "list the plugins that a team can name");
  const auto options = std::make_shared<PlainOptions>();
  add_plugin_folders(command, options->plugins);
  command.flag("--json", options->json, "write JSON");
  command.notes(plugin_list_examples);
  command.run = [options, &invocation] {
    const plugin::Catalogue catalogue = open_plugins(options->plugins, invocation);
    output::print(options->json ? list_json(catalogue) : plugin::list_text(catalogue));
    return exit_done;
  };
}

void add_plugin_info(Command& parent, const Invocation& invocation) {
  Command& command = parent.add("info", "describe a plugin and its parameters");
  const auto options = std::make_shared<PlainOptions>();
  command.take("id", options->words, "ID", "name of the plugin, as teams use it");
  add_plugin_folders(command, options->plugins);
  command.flag("--json", options->json, "write JSON: a list, with one element for each build of the plugin");
  command.notes(plugin_info_examples);
  command.run = [options, &invocation] { return describe(*options, invocation); };
}

void add_plugin_reference(Command& parent, const Invocation& invocation) {
  Command& command = parent.add("reference", "write the reference of all plugins as Markdown");
  const auto folders = std::make_shared<std::vector<std::string>>();
  add_plugin_folders(command, *folders);
  command.notes(plugin_reference_examples);
  command.run = [folders, &invocation] {
    output::print(plugin::reference_text(open_plugins(*folders, invocation)));
    return exit_done;
  };
}

void add_plugin_new(Command& parent, const Invocation& invocation) {
  Command& command = parent.add("new", "make the folder of a new plugin, which builds at once");
  const auto options = std::make_shared<PluginNewOptions>();
  command.choose("kind", options->kind, kinds, texts::join(kinds));
  command.take("name", options->name, "NAME", "of the plugin: lower-case letters, digits and underscores");
  command.choose("--lang", options->language, languages, "language of the source; default: c++");
  command.take("-o,--output", options->folder, "FOLDER", "make it in this folder; default: here", Writes::sources);
  command.notes(plugin_new_examples);
  command.run = [options, &invocation] { return make(*options, invocation); };
}

void add_plugin_check(Command& parent, const Invocation& invocation) {
  add_perturbed(parent);
  Command& command = parent.add("check", "see whether a plugin keeps the promises of the interface");
  const auto options = std::make_shared<PluginCheckOptions>();
  command.take("files", options->files, "FILE.so", "shared objects", Reads::data);
  command.take("--only", options->only, "CHECK",
               "this check alone, or all of a kind or a name (assigner, promises); may be repeated");
  command.take("--plugin", options->plugins, "ID", "this plugin of the file alone; may be repeated");
  command.take("--set", options->parameters, "NAME=VALUE", "a parameter of the plugin; may be repeated");
  command.flag("--may-idle", options->may_idle, "an assigner may leave a robot without a task that it could do");
  command.take("--processor-seconds", options->processor_seconds, "SECONDS", "processor time of one check; default 10");
  command.take("--seed", options->seed, "N", "other scenes, utilities, messages and losses by chance; default 0");
  command.flag("--in-process", options->in_process,
               "all checks in the program's own process, for a debugger: what ends it is not explained");
  command.flag("--json", options->json, "write JSON: a list, with one element for each file");
  command.notes(plugin_check_examples, "0 no check failed or crashed; 1 one did");
  command.run = [options, &invocation] { return run(*options, invocation); };
}

}  // namespace regista::cli
