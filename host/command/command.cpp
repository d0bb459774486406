// SPDX-License-Identifier: MIT
#include "command/command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "config/errors.hpp"
#include "texts/message.hpp"

namespace regista::command {
namespace {

using config::BadInput;

constexpr auto help_command = "help";

// Returns the names of a command and its subcommands, as `help` accepts them.
CommandDeclaration names_below(const CommandDeclaration& command, const std::string& parent, const std::string& name) {
  CommandDeclaration out{name, parent + ' ' + name, command.about, {}, {}, {}};
  for (const CommandDeclaration& each : command.commands)
    out.commands.push_back(names_below(each, out.full_name, each.name));
  return out;
}

// Returns the message for a wrong number of values. No option takes more than one value, and a flag takes none.
std::string wrong_count(const CLI::ArgumentMismatch& error) {
  const std::string text = error.what(), option = text.substr(0, text.find_first_of(": "));
  if (text.find("flag override") != std::string::npos) return "--" + option + " takes no value";
  return option + (text.ends_with("missing") ? " needs a value" : " is given more than once");
}

}  // namespace

Command::Command(const std::string& name, const std::string& about)
    : program_(std::make_unique<CLI::App>(about, name)), app_(*program_), declared_{name, name, about, {}, {}, {}} {}
Command::Command(CLI::App& app, const Command& parent, const std::string& name, const std::string& about)
    : app_(app), declared_{name, parent.declared_.full_name + ' ' + name, about, {}, {}, {}} {}
Command::~Command() = default;

Command& Command::add(const std::string& name, const std::string& about) {
  // Allows at most one subcommand, so that CLI11 never reads a later word as another subcommand.
  app_.require_subcommand(0, 1);
  CLI::App& app = *app_.add_subcommand(name, about);
  return *commands_.emplace_back(new Command(app, *this, name, about));
}

void Command::answer_version(const std::string& text) {
  declare(*app_.set_version_flag("--version", text), {{}, {}, "print the version", {}, {}});
}

void Command::declare(CLI::Option& option, OptionDeclaration declared) {
  for (const std::string& name : option.get_snames()) declared.names.push_back('-' + name);
  for (const std::string& name : option.get_lnames()) declared.names.push_back("--" + name);
  if (option.get_positional()) declared.names.push_back(option.get_name(true));
  options_.push_back(&option);
  declared_.options.push_back(std::move(declared));
}

void Command::take(const std::string& name, std::string& into, const std::string& type, const std::string& help,
                   output::FileUse use) {
  declare(*app_.add_option(name, into), {{}, type, help, {}, use});
}

void Command::take(const std::string& name, std::vector<std::string>& into, const std::string& type,
                   const std::string& help, output::FileUse use) {
  CLI::Option& option = *app_.add_option(name, into);
  if (option.nonpositional()) option.allow_extra_args(false);
  declare(option, {{}, type, help, {}, use, true});
}

void Command::flag(const std::string& name, bool& into, const std::string& help) {
  declare(*app_.add_flag(name, into)->disable_flag_override(), {{}, {}, help, {}, {}});
}

std::vector<output::GivenOption> Command::given() const {
  std::vector<output::GivenOption> out;
  for (std::size_t i = 0; i < options_.size(); ++i) {
    if (options_[i]->count() == 0) continue;
    out.push_back({declared_.options[i].name(), options_[i]->results(), declared_.options[i].use});
  }
  return out;
}

CommandDeclaration Command::declaration() const {
  CommandDeclaration out = declared_;
  for (const auto& each : commands_) {
    if (!each->hidden) out.commands.push_back(each->declaration());
  }
  if (!program_) return out;
  CommandDeclaration help = names_below(out, out.name, help_command);
  help.about = "explain a command";
  out.commands.push_back(std::move(help));
  return out;
}

// Returns the innermost command that the words named.
const Command& Command::chosen() const {
  const auto named = std::ranges::find_if(commands_, [](const auto& each) { return each->app_.parsed(); });
  return named == commands_.end() ? *this : (*named)->chosen();
}

// Returns the message for a word that no option takes.
std::string Command::not_expected(const std::string& word) const {
  if (word.size() > 1 && word.front() == '-') {
    return texts::unknown("option", word.substr(0, word.find('=')), declared_.full_name, declared_.option_names());
  }
  if (const auto known = declaration().command_names(); !known.empty())
    return texts::unknown("command", word, declared_.full_name, known);
  return fmt::format("unexpected argument {}; see: {} --help", texts::in_quotes(word), declared_.full_name);
}

// Returns "; `regista experiment` has one" if subcommands have the option `word`; empty for none or more than three.
std::string Command::elsewhere(const std::string& word) const {
  const std::string option = word.substr(0, word.find('='));
  std::vector<std::string> takers;
  for (const auto& each : commands_) {
    const auto named = [&](const OptionDeclaration& declared) { return declared.name() == option; };
    if (!each->hidden && std::ranges::any_of(each->declared_.options, named))
      takers.push_back(fmt::format("`{}`", each->declared_.full_name));
  }
  constexpr std::size_t most = 3;
  if (takers.empty() || takers.size() > most) return {};
  return fmt::format("; {} {} one", texts::join(takers), takers.size() == 1 ? "has" : "have");
}

// Refuses an empty value, which is usually an unset variable of a script, and a value that begins with "--", which
// usually means that the user forgot the value of the previous option.
void Command::refuse_missing_values() const {
  for (const output::GivenOption& option : given()) {  // the value of a flag is "true"
    for (const std::string& value : option.values) {
      if (value.empty()) throw BadInput(fmt::format("{} needs a value", option.name));
      if (value.starts_with("--"))
        throw BadInput(fmt::format("{} needs a value, and {} is an option", option.name, texts::in_quotes(value)));
    }
  }
}

Command::Typed Command::read(const std::vector<std::string>& words, std::size_t width) {
  if (!words.empty() && words.front() == help_command) {
    return {nullptr, help_text(named(declaration(), {words.begin() + 1, words.end()}), width)};
  }
  try {
    app_.parse(std::vector<std::string>(words.rbegin(), words.rend()));  // CLI11 expects the words in reverse order
  } catch (const CLI::CallForHelp&) {
    return {nullptr, help_text(chosen().declaration(), width)};
  } catch (const CLI::CallForVersion& version) {
    return {nullptr, std::string(version.what()) + '\n'};
  } catch (const CLI::ExtrasError&) {
    const std::string word = app_.remaining(true).front();
    throw BadInput(chosen().not_expected(word) + elsewhere(word));
  } catch (const CLI::ArgumentMismatch& error) {
    throw BadInput(wrong_count(error));
  } catch (const CLI::ParseError& error) {
    throw BadInput(error.what());
  }
  const Command& command = chosen();
  command.refuse_missing_values();
  if (!command.run) {
    throw BadInput(fmt::format("which command? There are: {}; see: {} --help",
                               texts::join(command.declaration().command_names()), command.declared_.full_name));
  }
  return {&command, {}};
}

}  // namespace regista::command
