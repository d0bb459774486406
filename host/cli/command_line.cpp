// SPDX-License-Identifier: MIT
#include "cli/command_line.hpp"

#include <fmt/format.h>
#include <regista/abi.h>

#include <csignal>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

#include "cli/commands.hpp"
#include "cli/study_commands.hpp"
#include "command/terminal.hpp"
#include "output/output.hpp"
#include "results/study_kind.hpp"

namespace regista::cli {
namespace {

constexpr auto command_line_examples = R"(Examples:
  regista match configs/teams/paper.yaml configs/teams/fixed_rate.yaml --seed 1
  regista tournament --team configs/teams/paper.yaml --team configs/teams/fixed_rate.yaml --pairs 100
  regista experiment configs/studies/role_overlap.yaml
  regista tune configs/studies/tune_paper.yaml
  regista plugin list
  regista config copy configs

Each command explains itself: regista help match)";

constexpr auto plugin_examples = R"(Examples:
  regista plugin list
  regista plugin info voronoi
  regista plugin new predictor my_ball)";

constexpr auto config_examples = R"(Examples:
  regista config copy configs
  regista config check configs/teams/paper.yaml
  regista config show configs/teams/fixed_rate.yaml
  regista config schema team > team.schema.json)";

Invocation invocation_of(int argc, char** argv) {
  std::error_code error;
  return {{argv, argv + argc}, std::filesystem::read_symlink("/proc/self/exe", error)};
}

// Relative names would lead nowhere, and the system gives no command the name of its folder.
void require_working_folder() {
  std::error_code error;
  if (std::filesystem::current_path(error).empty())
    throw BadInput("the working folder is no longer there, or may not be entered");
}

int run(const Invocation& invocation) {
  // First: workers are started in numbers, and would only become slower and larger by all the other commands.
  if (invocation.arguments.size() == 2) run_for_campaign(invocation.arguments[1], invocation);
  Command program("regista", "research on team strategy for robot soccer");
  program.answer_version(fmt::format("regista {} (plugin interface {}.{}, {})", REGISTA_VERSION, REGISTA_ABI_MAJOR,
                                     REGISTA_ABI_MINOR, REGISTA_BUILD));
  program.notes(command_line_examples);
  add_commands(program, invocation);
  const Command::Typed typed =
      program.read({invocation.arguments.begin() + 1, invocation.arguments.end()}, command::columns_of_output());
  if (typed.command == nullptr) {
    output::print(typed.answer);
    return exit_done;
  }
  if (!typed.command->is_hidden()) require_working_folder();  // the hidden one is told all by the program itself
  return typed.command->run();
}

}  // namespace

void add_commands(Command& program, const Invocation& invocation) {
  add_match(program, invocation);
  add_view(program, invocation);
  add_tournament(program, invocation);
  add_experiment(program, invocation);
  add_tune(program, invocation);
  add_run(program, invocation);
  add_resume(program, invocation);
  add_report(program, invocation);
  add_results(program, invocation);
  add_gather(program, invocation);
  add_status(program);
  add_stop(program);
  add_cluster_task(program, invocation);
  add_sprt(program);
  add_rank(program);
  add_evaluate_predictor(program, invocation);
  add_metrics(program);
  add_completion(program);
  Command& plugin = program.add("plugin", "the plugins that there are");
  plugin.notes(plugin_examples);
  add_plugin_list(plugin, invocation);
  add_plugin_info(plugin, invocation);
  add_plugin_new(plugin, invocation);
  add_plugin_check(plugin, invocation);
  add_plugin_reference(plugin, invocation);
  Command& config = program.add("config", "documents: rules, robots, disturbances, openings, teams, studies");
  config.notes(config_examples);
  add_config_check(config, invocation);
  add_config_show(config, invocation);
  add_config_schema(config, invocation);
  add_config_reference(config, invocation);
  add_config_draw(config);
  add_config_copy(config, invocation);
}

int run(int argc, char** argv, std::span<const results::StudyKind> studies) {
  output::occupy_standard_streams();
  // A reader who goes away is found when something is written, not by a signal.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);  // a limit on file sizes is an error of writing like any other
  std::signal(SIGCHLD, SIG_DFL);  // who started this may have ignored it; then nobody could say how a child ended
  try {
    Invocation invocation = invocation_of(argc, argv);
    invocation.studies = studies;
    return run(invocation);
  } catch (...) {
    return explain_current_exception();
  }
}

}  // namespace regista::cli
