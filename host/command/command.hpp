// SPDX-License-Identifier: MIT
// A command of the program: declares its options, and reads their values from the typed words. Only command.cpp
// includes CLI11, because the headers of CLI11 cost the compiler four seconds in each file.
#pragma once

#include <cctype>
#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "command/options_declared.hpp"
#include "output/output_files.hpp"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace regista::command {

inline constexpr auto interruptible = "; 130 interrupted by Ctrl-C, 143 by SIGTERM";
inline constexpr auto resumable = "; 130 interrupted by Ctrl-C, 143 by SIGTERM: regista resume goes on";

class Command {
 public:
  // Creates the program itself, the root of all commands.
  Command(const std::string& name, const std::string& about);
  ~Command();

  // --- Declarations. read() writes each value to the declared variable, which must exist until read() ends. ----------

  // Adds a subcommand, which this command owns. A command with subcommands has no action of its own.
  Command& add(const std::string& name, const std::string& about);
  bool hidden = false;  // true: leaves the command out of --help and advice, because users do not type it
  void answer_version(const std::string& text);  // declares --version, which prints `text`

  // name: "--seed", "-o,--output", or "teams" for words without an option. type: the name of the value in --help. A
  // list gets one value each time the user gives the option; a list without an option gets all words.
  void take(const std::string& name, std::string& into, const std::string& type, const std::string& help,
            output::FileUse use = {});
  void take(const std::string& name, std::vector<std::string>& into, const std::string& type, const std::string& help,
            output::FileUse use = {});
  // Declares a value with fixed choices; of a word without an option the help shows its name in capitals. read() writes
  // the choice as text, which the command must convert.
  template <class Into>
  void choose(const std::string& name, Into& into, std::vector<std::string> choices, const std::string& help) {
    std::string type = "CHOICE";
    if (!name.starts_with('-')) {
      type = name;
      for (char& each : type) each = static_cast<char>(std::toupper(static_cast<unsigned char>(each)));
    }
    take(name, into, type, help);
    declared_.options.back().choices = std::move(choices);
  }
  void flag(const std::string& name, bool& into, const std::string& help);
  // Sets the last part of --help; form: see filled(). codes: exit codes, without those that all commands share; "":
  // says nothing about exit codes. stopped: `interruptible`, `resumable`, or "" for a command that ends at once.
  void notes(const std::string& text, const std::string& codes = "", const std::string& stopped = "") {
    declared_.notes = text;
    if (!codes.empty())
      declared_.notes += "\n\nExit codes: " + codes + "; 2 bad input; 3 a defect of Regista" + stopped + ".";
  }

  // The action of the command. Returns an exit code. May throw exceptions, which explain_current_exception() explains.
  std::function<int()> run;

  // The command that the words name, or the answer to --help or --version.
  struct Typed {
    const Command* command = nullptr;
    std::string answer;  // text to print; empty: the caller must run the command
  };
  // words: without the program's name. width: columns of the help text. Call this function only once, and only on the
  // root of all commands. Throws BadInput.
  Typed read(const std::vector<std::string>& words, std::size_t width);

  std::vector<output::GivenOption> given() const;
  // The files of the given options. work: noun for messages.
  output::OutputFiles outputs(const std::string& work) const { return {given(), work}; }
  CommandDeclaration declaration() const;  // of this command and its subcommands, without hidden subcommands

 private:
  Command(CLI::App& app, const Command& parent, const std::string& name, const std::string& about);
  void declare(CLI::Option& option, OptionDeclaration declared);
  const Command& chosen() const;
  std::string not_expected(const std::string& word) const;
  std::string elsewhere(const std::string& word) const;
  void refuse_missing_values() const;

  std::unique_ptr<CLI::App> program_;  // null in a subcommand
  CLI::App& app_;
  CommandDeclaration declared_;  // without the subcommands
  std::vector<std::unique_ptr<Command>> commands_;
  std::vector<CLI::Option*> options_;  // same order as declared_.options
};

}  // namespace regista::command
