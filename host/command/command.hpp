// SPDX-License-Identifier: MIT
// A command of the program and what it takes: declared here, read from the words that were typed. Only command.cpp
// knows CLI11, whose headers cost the compiler four seconds in each file that includes them.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "command/declaration.hpp"
#include "output/file_use.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace regista::command {

class Command {
 public:
  // The program itself.
  Command(const std::string& name, const std::string& about);
  ~Command();
  Command(const Command&) = delete;
  Command& operator=(const Command&) = delete;

  // --- Declaring. What is taken is written to the variable when words are read; it must live until then. -----------

  // A command of this one, which owns it. A command that has commands does nothing itself.
  Command& add(const std::string& name, const std::string& about);
  void hide();                                   // from --help and from advice: it is for the program itself
  void answer_version(const std::string& text);  // --version

  // name: "--seed", "-o,--output", or "teams" for words that belong to no option. type: what --help calls the value.
  // A list takes one word each time the option is given, or all words that belong to no option.
  void take(const std::string& name, std::string& into, const std::string& type, const std::string& help,
            output::FileUse use = {});
  void take(const std::string& name, std::vector<std::string>& into, const std::string& type, const std::string& help,
            output::FileUse use = {});
  // The same of a value for which there are only these choices; which it is, the command itself has to look at.
  void choose(const std::string& name, std::string& into, std::vector<std::string> choices, const std::string& help);
  void choose(const std::string& name, std::vector<std::string>& into, std::vector<std::string> choices,
              const std::string& help);
  void flag(const std::string& name, bool& into, const std::string& help);
  void notes(const std::string& text);  // at the end of --help: examples, exit codes; form: help_text.hpp

  // What the command does. Returns an exit code; throws what end_of_program.hpp knows to explain.
  std::function<int()> run;

  // --- Reading -------------------------------------------------------------------------------------------------------

  // The command that the words name, or what --help and --version answer.
  struct Typed {
    const Command* command = nullptr;
    std::string answer;  // empty: the command is to be run
  };
  // words: without the program's name. width: of help, in columns. Only once, and by the program itself. Throws
  // BadInput.
  Typed read(const std::vector<std::string>& words, std::size_t width);

  // --- Looking -------------------------------------------------------------------------------------------------------

  std::vector<output::GivenOption> given() const;
  CommandDeclaration declaration() const;  // with the commands that are not hidden
  bool is_hidden() const { return hidden_; }

 private:
  Command(CLI::App& app, const Command& parent, const std::string& name, const std::string& about);
  void declare(CLI::Option& option, OptionDeclaration declared);
  const Command& chosen() const;
  std::string not_expected(const std::string& word) const;
  std::string elsewhere(const std::string& word) const;
  void refuse_missing_values() const;
  std::vector<std::string> names_of_commands() const;

  std::unique_ptr<CLI::App> program_;  // of the program itself
  CLI::App& app_;
  CommandDeclaration declared_;  // but for its commands
  bool hidden_ = false;
  std::vector<std::unique_ptr<Command>> commands_;
  std::vector<CLI::Option*> options_;  // as declared_.options
};

}  // namespace regista::command
