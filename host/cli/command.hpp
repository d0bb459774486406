// SPDX-License-Identifier: MIT
// A command of the program and what it takes: declared here, read from the words that were typed. Only command.cpp
// knows CLI11, whose headers cost the compiler four seconds in each file that includes them.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "output/file_use.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace regista::cli {

using output::Reads;
using output::Writes;

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
  void flag(const std::string& name, bool& into, const std::string& help);
  void notes(const std::string& text);  // at the end of --help: examples, exit codes

  // What the command does. Returns an exit code; throws what end_of_program.hpp knows to explain.
  std::function<int()> run;

  // --- Reading -------------------------------------------------------------------------------------------------------

  // The command that the words name, or what --help and --version answer.
  struct Typed {
    const Command* command = nullptr;
    std::string answer;  // empty: the command is to be run
  };
  // words: without the program's name. Only once, and by the program itself. Throws BadInput.
  Typed read(const std::vector<std::string>& words);

  // --- Looking -------------------------------------------------------------------------------------------------------

  class Option {
   public:
    std::string name() const;  // in its long form: "--output"
    std::string type() const;  // as in take(); empty: a flag
    bool is_positional() const;
    output::FileUse use() const { return use_; }
    std::vector<std::string> values() const;  // as they were typed; empty: it was not given

   private:
    friend class Command;
    Option(CLI::Option& option, output::FileUse use) : option_(&option), use_(use) {}
    CLI::Option* option_;
    output::FileUse use_;
  };
  const std::vector<Option>& options() const { return options_; }
  std::vector<output::GivenOption> given() const;
  const std::vector<std::unique_ptr<Command>>& commands() const { return commands_; }
  std::string name() const;
  std::string full_name() const;  // "regista plugin info"
  bool is_hidden() const;

 private:
  Command(CLI::App& app, const Command& parent);
  const Command& chosen() const;
  std::string not_expected(const std::string& word) const;
  void refuse_missing_values() const;
  std::vector<std::string> names_of_commands() const;

  std::unique_ptr<CLI::App> program_;  // of the program itself
  CLI::App& app_;
  const Command* parent_ = nullptr;
  std::vector<std::unique_ptr<Command>> commands_;
  std::vector<Option> options_;
};

}  // namespace regista::cli
