// SPDX-License-Identifier: MIT
// `regista completion SHELL`: a script by which the shell completes what is typed.
#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "command/completion.hpp"
#include "output/output.hpp"
#include "texts/message.hpp"

namespace regista::cli {
namespace {

constexpr auto completion_examples = R"(Examples:
  regista completion bash > ~/.local/share/bash-completion/completions/regista
  regista completion zsh > ~/.zfunc/_regista

bash reads the first file when the package bash-completion is installed, in the next shell; without that package, add the line
  source ~/.local/share/bash-completion/completions/regista
to ~/.bashrc. zsh reads the second one when ~/.zshrc has the lines
  fpath+=(~/.zfunc)
  autoload -U compinit && compinit)";

int write(const std::string& shell, const command::CommandDeclaration& program) {
  if (shell.empty()) throw BadInput("completion: which shell? There are: bash, zsh");
  if (shell == "bash") {
    output::print(command::bash_completion(program));
  } else if (shell == "zsh") {
    output::print(command::zsh_completion(program));
  } else {
    throw BadInput("completion: " + texts::unknown("shell", shell, "", std::vector<std::string>{"bash", "zsh"}));
  }
  return exit_done;
}

}  // namespace

void add_completion(Command& program) {
  Command& command = program.add("completion", "write a script by which a shell completes commands and options");
  const auto shell = std::make_shared<std::string>();
  command.choose("shell", *shell, {"bash", "zsh"}, "that reads the script");
  command.notes(completion_examples);
  command.run = [shell, &program] { return write(*shell, program.declaration()); };
}

}  // namespace regista::cli
