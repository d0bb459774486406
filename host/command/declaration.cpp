// SPDX-License-Identifier: MIT
#include "command/declaration.hpp"

#include <algorithm>

#include "config/bad_input.hpp"
#include "texts/message.hpp"

namespace regista::command {

const CommandDeclaration& named(const CommandDeclaration& program, const std::vector<std::string>& words) {
  const CommandDeclaration* command = &program;
  for (const std::string& word : words) {
    const auto found = std::ranges::find(command->commands, word, &CommandDeclaration::name);
    if (found == command->commands.end()) {
      std::vector<std::string> names;
      for (const CommandDeclaration& each : command->commands) names.push_back(each.name);
      if (names.empty()) throw config::BadInput(command->full_name + " has no commands of its own");
      throw config::BadInput(texts::unknown("command", word, command->full_name, names));
    }
    command = &*found;
  }
  return *command;
}

}  // namespace regista::command
