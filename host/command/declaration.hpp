// SPDX-License-Identifier: MIT
// What a command takes and says of itself, as plain data: help and completion are written from it, and the words that
// were typed are read by it.
#pragma once

#include <string>
#include <vector>

#include "output/file_use.hpp"

namespace regista::command {

struct OptionDeclaration {
  std::vector<std::string> names;    // {"-o", "--output"}; of words that belong to no option one name: {"teams"}
  std::string type;                  // what help calls the value: "FILE"; empty: a flag
  std::string help;                  // one line
  std::vector<std::string> choices;  // the values there are; empty: others than these
  output::FileUse use;               // of the file that the value names
  bool is_list = false;              // takes more than one value

  const std::string& name() const { return names.back(); }  // the long form
  bool is_positional() const { return !names.back().starts_with('-'); }
  bool is_flag() const { return type.empty(); }
};

struct CommandDeclaration {
  std::string name;       // "info"
  std::string full_name;  // "regista plugin info"
  std::string about;      // one line
  std::string notes;      // paragraphs and examples; see help_text.hpp
  std::vector<OptionDeclaration> options;
  std::vector<CommandDeclaration> commands;  // those that users may type
};

// The command that the words name, from `program` on. Throws BadInput for a word that names none.
const CommandDeclaration& named(const CommandDeclaration& program, const std::vector<std::string>& words);

}  // namespace regista::command
