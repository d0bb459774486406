// SPDX-License-Identifier: MIT
// Completion of what is typed in a shell, from the declarations of the commands: a script that the shell reads.
#pragma once

#include <string>

#include "command/declaration.hpp"

namespace regista::command {

// For bash 4 and newer; needs nothing of the package bash-completion.
std::string bash_completion(const CommandDeclaration& program);

// For zsh, as a file _NAME in a folder of its $fpath.
std::string zsh_completion(const CommandDeclaration& program);

}  // namespace regista::command
