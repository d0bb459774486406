// SPDX-License-Identifier: MIT
// The declaration of a command as plain data. The program uses declarations to read the typed words, and to write
// --help texts and shell completion scripts.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "output/output_files.hpp"

namespace regista::command {

struct OptionDeclaration {
  std::vector<std::string> names;    // {"-o", "--output"}; for words without an option one name: {"teams"}
  std::string type;                  // name of the value in help: "FILE"; empty: a flag
  std::string help;                  // one line
  std::vector<std::string> choices;  // the allowed values; empty: any value
  output::FileUse use;               // use of the file that the value names
  bool is_list = false;              // takes more than one value

  const std::string& name() const { return names.back(); }  // the long form: "--output"
  bool is_positional() const { return !names.back().starts_with('-'); }
  bool is_flag() const { return type.empty(); }
};

struct CommandDeclaration {
  std::string name;       // "info"
  std::string full_name;  // "regista plugin info"
  std::string about;      // one line
  std::string notes;      // paragraphs and examples; see filled()
  std::vector<OptionDeclaration> options;
  std::vector<CommandDeclaration> commands;  // commands that users may type

  std::vector<std::string> option_names() const;  // --help, then the long forms of the other options
  std::vector<std::string> command_names() const;
};

// Returns the command that the words name, starting at `program`. Throws BadInput for an unknown word.
const CommandDeclaration& named(const CommandDeclaration& program, const std::vector<std::string>& words);

// --- The --help text of a command: usage, options and notes.

// Returns lines of at most `width` columns with line ends. Longer words and examples are not broken.
std::string help_text(const CommandDeclaration& command, std::size_t width);

// Breaks the notes into lines of at most `width` columns. An empty line separates paragraphs. Lines that begin with a
// space are examples and stay unchanged. A line that ends with a colon is not joined with the next line.
std::string filled(std::string_view notes, std::size_t width);

// --- Shell completion: scripts from the declarations of the commands.

// For bash 4 and newer. The script does not need the package bash-completion.
std::string bash_completion(const CommandDeclaration& program);

// For zsh, as a file _NAME in a folder of $fpath.
std::string zsh_completion(const CommandDeclaration& program);

// For fish 3.4 and newer, as a file NAME.fish in a folder of $fish_complete_path.
std::string fish_completion(const CommandDeclaration& program);

}  // namespace regista::command
