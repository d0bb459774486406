// SPDX-License-Identifier: MIT
// `regista plugin new KIND NAME`: a folder with a plugin of this kind that builds at once, with its tests and a team
// that uses it.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include <regista/abi.h>

#include "cli/commands.hpp"
#include "cli/plugin_folders.hpp"
#include "config/flow.hpp"
#include "output/new_plugin.hpp"
#include "output/output.hpp"
#include "plugin/descriptor.hpp"
#include "texts/message.hpp"

namespace regista::cli {
namespace {

namespace fs = std::filesystem;

constexpr auto plugin_new_examples = R"(Examples:
  regista plugin new predictor my_ball
  regista plugin new assigner my_auction --lang c
  regista plugin new utility my_term -o ~/plugins

It makes the folder NAME with the plugin's source, a build for CMake, a unit test, a contract test, a team that uses the plugin, and a
README with the next commands. Nothing is written over. What the plugin does is small and works: change it.)";

// In the order of a decision.
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

// Both would install the same file, and a team could not say which one it means.
void refuse_name_in_use(const std::string& name, const Invocation& invocation) {
  const plugin::Catalogue catalogue = open_plugins({}, invocation);
  for (const plugin::Found& found : catalogue.plugins()) {
    if (found.descriptor->id != name) continue;
    throw BadInput(
        fmt::format("plugin new: there is a plugin {} already, in {}; choose another name", name, found.file.string()));
  }
}

std::string in_shell(const std::string& word) {
  constexpr std::string_view plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+./,:=@%";
  if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) return word;
  std::string out = "'";
  for (const char c : word) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + '\'';
}

// A quoted argument of CMake.
std::string in_cmake(const std::string& word) {
  std::string out = "\"";
  for (const char c : word) {
    if (c == '"' || c == '\\' || c == '$') out += '\\';
    out += c;
  }
  return out + '"';
}

// Where CMake finds the SDK that belongs to this program, and what has to be typed for it.
struct Sdk {
  std::string hints;     // of find_package()
  std::string commands;  // before and in the first call of cmake
};

Sdk sdk_of(const Invocation& invocation) {
  std::error_code none;
  const fs::path prefix = invocation.own(".").lexically_normal();
  const std::string configure = "cmake -B build";
  if (!fs::exists(invocation.own("lib/cmake/regista/regista-config.cmake"), none)) {
    // The program of a build folder: its SDK has to be installed.
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
  for (std::size_t at = 0; at < commands.size();) {
    const std::size_t end = std::min(commands.find('\n', at), commands.size());
    out += fmt::format("  {}\n", std::string_view(commands).substr(at, end - at));
    at = end + 1;
  }
  output::print(out);
  return exit_done;
}

}  // namespace

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

}  // namespace regista::cli
