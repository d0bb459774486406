// SPDX-License-Identifier: MIT
#include "cli/command_line.hpp"

#include <fmt/format.h>
#include <regista/abi.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <filesystem>
#include <memory>
#include <system_error>
#include <utility>

#include "campaign/fork_server.hpp"
#include "campaign/play_job.hpp"
#include "campaign/worker.hpp"
#include "command/options_declared.hpp"
#include "output/replaced_file.hpp"
#include "texts/message.hpp"

namespace regista::cli {
namespace {

constexpr auto command_line_examples = R"(Examples:
  regista match paper fixed_rate --seed 1
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
  regista config diff paper spqr2023
  regista config show configs/teams/fixed_rate.yaml
  regista config schema team > team.schema.json)";

constexpr auto completion_examples = R"(Examples:
  regista completion bash > ~/.local/share/bash-completion/completions/regista
  regista completion zsh > ~/.zfunc/_regista
  regista completion fish > ~/.config/fish/completions/regista.fish

bash reads the first file when the package bash-completion is installed, in the next shell; without that package, add the line
  source ~/.local/share/bash-completion/completions/regista
to ~/.bashrc. zsh reads the second one when ~/.zshrc has the lines
  fpath+=(~/.zfunc)
  autoload -U compinit && compinit)";

// Runs `regista play-one` or `regista fork-server` and ends the process, if `name` is one of these hidden commands. A
// campaign starts the program with these commands (campaign/play_job.hpp, campaign/fork_server.hpp).
void run_for_campaign(const std::string& name, const Invocation& invocation) {
  constexpr const char* this_program = "regista " REGISTA_VERSION;
  if (name == campaign::worker_command) {
    const campaign::Surroundings surroundings{this_program, [&invocation](const std::vector<std::string>& folders) {
                                                return open_plugins(folders, invocation);
                                              }};
    _exit(campaign::play_one(surroundings) ? exit_done : exit_no);
  }
  if (name == campaign::server_command) {
    campaign::serve_matches(this_program);
    _exit(exit_done);
  }
}

// Throws BadInput if the working folder was deleted or may not be entered, because no relative name works then.
void require_working_folder() {
  std::error_code error;
  if (std::filesystem::current_path(error).empty())
    throw BadInput("the working folder is no longer there, or may not be entered");
}

int run(const Invocation& invocation) {
  // This call comes first, because workers start in large numbers, and adding the other commands would slow them down.
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
  if (!typed.command->hidden) require_working_folder();  // hidden commands need no working folder
  return typed.command->run();
}

}  // namespace

// `regista completion SHELL`: prints a script with which the shell completes commands.
void add_completion(Command& program, const Invocation& /*invocation*/) {
  Command& command = program.add("completion", "write a script by which a shell completes commands and options");
  using Script = std::string(const command::CommandDeclaration& program);
  static constexpr std::array<std::pair<const char*, Script*>, 3> scripts{
      {{"bash", command::bash_completion}, {"zsh", command::zsh_completion}, {"fish", command::fish_completion}}};
  const auto shell = std::make_shared<std::string>();
  const auto shells = texts::names_of(scripts, [](const auto& each) { return each.first; });
  command.choose("shell", *shell, shells, "that reads the script");
  command.notes(completion_examples);
  command.run = [shell, shells, &program] {
    if (shell->empty()) throw BadInput("completion: which shell? There are: " + texts::join(shells));
    const auto found = std::ranges::find(shells, *shell);
    if (found == shells.end()) throw BadInput("completion: " + texts::unknown("shell", *shell, "", shells));
    output::print(scripts[static_cast<std::size_t>(found - shells.begin())].second(program.declaration()));
    return exit_done;
  };
}

void add_commands(Command& program, const Invocation& invocation) {
  for (AddCommand* const add : {add_match, add_view, add_tournament, add_experiment, add_tune, add_run, add_resume,
                                add_report, add_results, add_gather, add_status, add_stop, add_cluster_task, add_power,
                                add_sprt, add_rank, add_evaluate_predictor, add_metrics, add_completion})
    add(program, invocation);
  Command& plugin = program.add("plugin", "plugins: list, explain, make and check them");
  plugin.notes(plugin_examples);
  for (AddCommand* const add :
       {add_plugin_list, add_plugin_info, add_plugin_new, add_plugin_check, add_plugin_reference})
    add(plugin, invocation);
  Command& config = program.add("config", "documents: rules, robots, disturbances, openings, teams, studies");
  config.notes(config_examples);
  for (AddCommand* const add : {add_config_check, add_config_show, add_config_diff, add_config_schema,
                                add_config_reference, add_config_draw, add_config_copy})
    add(config, invocation);
}

int run(int argc, char** argv, std::span<const results::StudyKind> studies) {
  output::occupy_standard_streams();
  // If the reader of a pipe has ended, a write fails with an error and sends no signal.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);  // a limit on file sizes becomes a write error
  std::signal(SIGCHLD, SIG_DFL);  // a parent may have set SIG_IGN, which hides when children end
  try {
    std::error_code unknown;
    return run({{argv, argv + argc}, std::filesystem::read_symlink("/proc/self/exe", unknown), studies});
  } catch (...) {
    return explain_current_exception();
  }
}

}  // namespace regista::cli
