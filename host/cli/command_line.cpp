// SPDX-License-Identifier: MIT
#include "cli/command_line.hpp"

#include <fmt/format.h>
#include <regista/abi.h>

#include <CLI/CLI.hpp>
#include <csignal>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

#include "cli/command.hpp"
#include "cli/end_of_program.hpp"
#include "cli/output.hpp"
#include "cli/study_kinds.hpp"
#include "config/text.hpp"

namespace regista::cli {
namespace {

constexpr auto examples = R"(Examples:
  regista match configs/teams/paper.yaml configs/teams/fixed_rate.yaml --seed 1
  regista tournament --team configs/teams/paper.yaml --team configs/teams/fixed_rate.yaml --pairs 100
  regista experiment configs/studies/role_overlap.yaml
  regista tune configs/studies/tune_paper.yaml
  regista plugin list
  regista config check configs/teams/paper.yaml

Each command explains itself: regista match --help)";

Invocation invocation_of(int argc, char** argv) {
  std::error_code error;
  return {{argv, argv + argc}, std::filesystem::read_symlink("/proc/self/exe", error)};
}

// The innermost command that was named.
const CLI::App& chosen(const CLI::App& app) {
  const std::vector<CLI::App*> named = app.get_subcommands();
  return named.empty() ? app : chosen(*named.front());
}

// "regista plugin info"
std::string full_name(const CLI::App& app) {
  return app.get_parent() == nullptr ? app.get_name() : full_name(*app.get_parent()) + ' ' + app.get_name();
}

std::vector<std::string> names_of_commands(const CLI::App& app) {
  std::vector<std::string> names;
  // One without a group is hidden.
  for (const CLI::App* each : app.get_subcommands([](const CLI::App* all) { return !all->get_group().empty(); })) {
    names.push_back(each->get_name());
  }
  return names;
}

std::vector<std::string> names_of_options(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* each : app.get_options([](const CLI::Option* option) { return option->nonpositional(); })) {
    names.push_back(each->get_name());
  }
  return names;
}

// The line for a word that nothing takes.
std::string not_expected(const CLI::App& root) {
  const CLI::App& app = chosen(root);
  const std::vector<std::string> left = root.remaining(true);
  const std::string& word = left.front();
  if (word.size() > 1 && word.front() == '-') {
    const std::string option = word.substr(0, word.find('='));
    return config::unknown("option", option, full_name(app), names_of_options(app));
  }
  const std::vector<std::string> commands = names_of_commands(app);
  if (!commands.empty()) return config::unknown("command", word, full_name(app), commands);
  return fmt::format("{} is one word too many for {}", config::in_quotes(word), full_name(app));
}

// Every option of ours takes one value or none.
std::string wrong_count(const CLI::ArgumentMismatch& error) {
  const std::string text = error.what(), option = text.substr(0, text.find_first_of(": "));
  if (text.find("flag override") != std::string::npos) return "--" + option + " takes no value";
  return option + (text.ends_with("missing") ? " needs a value" : " is given more than once");
}

// An empty value is most often a variable of a script that was not set; a value that looks like an option is one whose
// own value was forgotten.
void refuse_missing_values(const CLI::App& app) {
  for (const CLI::Option* option : app.get_options([](const CLI::Option* each) { return each->count() > 0; })) {
    if (option->get_expected_max() == 0) continue;  // a flag
    for (const std::string& value : option->results()) {
      if (value.empty()) throw BadInput(fmt::format("{} needs a value", option->get_name()));
      if (value.starts_with("--")) {
        throw BadInput(
            fmt::format("{} needs a value, and {} is an option", option->get_name(), config::in_quotes(value)));
      }
    }
  }
}

[[noreturn]] void no_command(const CLI::App& app) {
  throw BadInput(fmt::format("which command? There are: {}; see: {} --help", config::join(names_of_commands(app)),
                             full_name(app)));
}

// Relative names would lead nowhere, and the system tells no command what its folder is called.
void require_working_folder() {
  std::error_code error;
  if (std::filesystem::current_path(error).empty())
    throw BadInput("the working folder is no longer there, or may not be entered");
}

int run_chosen(CLI::App& root, const std::vector<Command>& commands, const std::vector<std::string>& arguments) {
  try {
    // CLI11 wants the words without the program's name, last one first.
    root.parse(std::vector<std::string>(arguments.rbegin(), arguments.rend() - 1));
  } catch (const CLI::CallForHelp&) {
    print(root.help());
    return exit_done;
  } catch (const CLI::CallForVersion& version) {
    print(std::string(version.what()) + '\n');
    return exit_done;
  } catch (const CLI::ExtrasError&) {
    throw BadInput(not_expected(root));
  } catch (const CLI::ArgumentMismatch& error) {
    throw BadInput(wrong_count(error));
  } catch (const CLI::ParseError& error) {
    throw BadInput(error.what());
  }
  const CLI::App& app = chosen(root);
  refuse_missing_values(app);
  for (const Command& command : commands) {
    if (command.app != &app) continue;
    if (!app.get_group().empty()) require_working_folder();  // the hidden one is told all by the program itself
    return command.run();
  }
  no_command(app);
}

}  // namespace

std::vector<Command> add_commands(CLI::App& root, const Invocation& invocation) {
  // At most one command, so that what follows it is never taken for another.
  root.require_subcommand(0, 1);
  std::vector<Command> commands{add_match(root, invocation),
                                add_view(root, invocation),
                                add_tournament(root, invocation),
                                add_experiment(root, invocation),
                                add_tune(root, invocation),
                                add_report(root, invocation),
                                add_sprt(root, invocation),
                                add_evaluate_predictor(root, invocation),
                                add_metrics(root),
                                add_play_one(root, invocation)};
  CLI::App& plugin = *root.add_subcommand("plugin", "the plugins that there are");
  plugin.require_subcommand(0, 1);
  commands.push_back(add_plugin_list(plugin, invocation));
  commands.push_back(add_plugin_info(plugin, invocation));
  commands.push_back(add_plugin_reference(plugin, invocation));
  CLI::App& config = *root.add_subcommand("config", "documents: rules, robots, disturbances, openings, teams, studies");
  config.require_subcommand(0, 1);
  commands.push_back(add_config_check(config, invocation));
  commands.push_back(add_config_show(config, invocation));
  commands.push_back(add_config_schema(config, invocation));
  return commands;
}

namespace {

int run(const Invocation& invocation, const Addition* addition) {
  CLI::App root("Regista: research on team strategy for robot soccer", "regista");
  root.set_version_flag("--version", fmt::format("regista {} (plugin interface {}.{}, {})", REGISTA_VERSION,
                                                 REGISTA_ABI_MAJOR, REGISTA_ABI_MINOR, REGISTA_BUILD));
  root.footer(examples);
  std::vector<Command> commands = add_commands(root, invocation);
  if (addition != nullptr) commands.push_back(addition->command(root, invocation));
  return run_chosen(root, commands, invocation.arguments);
}

}  // namespace

int run(int argc, char** argv, const Addition* addition) {
  occupy_standard_streams();
  // A reader who goes away is an error of writing, which is told, not a signal.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);  // a limit on file sizes is an error of writing like any other
  try {
    Invocation invocation = invocation_of(argc, argv);
    invocation.studies = addition == nullptr ? study_kinds() : addition->studies;
    return run(invocation, addition);
  } catch (...) {
    return explain_current_exception();
  }
}

}  // namespace regista::cli
