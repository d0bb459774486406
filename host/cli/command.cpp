// SPDX-License-Identifier: MIT
#include "cli/command.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <string_view>

#include "config/bad_input.hpp"
#include "config/text.hpp"

namespace regista::cli {
namespace {

using config::BadInput;

// Every option takes one value or none.
std::string wrong_count(const CLI::ArgumentMismatch& error) {
  const std::string text = error.what(), option = text.substr(0, text.find_first_of(": "));
  if (text.find("flag override") != std::string::npos) return "--" + option + " takes no value";
  return option + (text.ends_with("missing") ? " needs a value" : " is given more than once");
}

}  // namespace

std::string Command::Option::name() const { return option_->get_name(); }
std::string Command::Option::type() const {
  return option_->get_expected_max() == 0 ? std::string() : option_->get_type_name();
}
bool Command::Option::is_positional() const { return !option_->nonpositional(); }
std::vector<std::string> Command::Option::values() const {
  return option_->count() == 0 ? std::vector<std::string>() : option_->results();
}

Command::Command(const std::string& name, const std::string& about)
    : program_(std::make_unique<CLI::App>(about, name)), app_(*program_) {}
Command::Command(CLI::App& app, const Command& parent) : app_(app), parent_(&parent) {}
Command::~Command() = default;

Command& Command::add(const std::string& name, const std::string& about) {
  // At most one command, so that what follows it is never taken for another.
  app_.require_subcommand(0, 1);
  CLI::App& app = *app_.add_subcommand(name, about);
  return *commands_.emplace_back(new Command(app, *this));
}

void Command::hide() { app_.group(""); }

void Command::answer_version(const std::string& text) { app_.set_version_flag("--version", text); }

void Command::take(const std::string& name, std::string& into, const std::string& type, const std::string& help,
                   output::FileUse use) {
  options_.push_back(Option(*app_.add_option(name, into, help)->type_name(type), use));
}

void Command::take(const std::string& name, std::vector<std::string>& into, const std::string& type,
                   const std::string& help, output::FileUse use) {
  CLI::Option& option = *app_.add_option(name, into, help)->type_name(type);
  if (option.nonpositional()) option.allow_extra_args(false);
  options_.push_back(Option(option, use));
}

void Command::flag(const std::string& name, bool& into, const std::string& help) {
  options_.push_back(Option(*app_.add_flag(name, into, help)->disable_flag_override(), {}));
}

void Command::notes(const std::string& text) { app_.footer(text); }

std::string Command::name() const { return app_.get_name(); }

std::string Command::full_name() const { return parent_ == nullptr ? name() : parent_->full_name() + ' ' + name(); }

bool Command::is_hidden() const { return app_.get_group().empty(); }

std::vector<std::string> Command::names_of_commands() const {
  std::vector<std::string> names;
  for (const auto& each : commands_) {
    if (!each->is_hidden()) names.push_back(each->name());
  }
  return names;
}

std::vector<output::GivenOption> Command::given() const {
  std::vector<output::GivenOption> out;
  for (const Option& each : options_) {
    if (std::vector<std::string> values = each.values(); !values.empty()) {
      out.push_back({each.name(), std::move(values), each.use()});
    }
  }
  return out;
}

// The innermost command that was named.
const Command& Command::chosen() const {
  const auto named = std::ranges::find_if(commands_, [](const auto& each) { return each->app_.parsed(); });
  return named == commands_.end() ? *this : (*named)->chosen();
}

// The line for a word that nothing takes.
std::string Command::not_expected(const std::string& word) const {
  if (word.size() > 1 && word.front() == '-') {
    std::vector<std::string> names;
    for (const CLI::Option* each : app_.get_options([](const CLI::Option* all) { return all->nonpositional(); })) {
      names.push_back(each->get_name());
    }
    return config::unknown("option", word.substr(0, word.find('=')), full_name(), names);
  }
  if (const auto known = names_of_commands(); !known.empty())
    return config::unknown("command", word, full_name(), known);
  return fmt::format("{} is one word too many for {}", config::in_quotes(word), full_name());
}

// An empty value is most often a variable of a script that was not set; a value that looks like an option is one whose
// own value was forgotten.
void Command::refuse_missing_values() const {
  for (const Option& option : options_) {
    if (option.type().empty()) continue;
    for (const std::string& value : option.values()) {
      if (value.empty()) throw BadInput(fmt::format("{} needs a value", option.name()));
      if (value.starts_with("--")) {
        throw BadInput(fmt::format("{} needs a value, and {} is an option", option.name(), config::in_quotes(value)));
      }
    }
  }
}

Command::Typed Command::read(const std::vector<std::string>& words) {
  try {
    app_.parse(std::vector<std::string>(words.rbegin(), words.rend()));  // CLI11 wants the last one first
  } catch (const CLI::CallForHelp&) {
    return {nullptr, app_.help()};
  } catch (const CLI::CallForVersion& version) {
    return {nullptr, std::string(version.what()) + '\n'};
  } catch (const CLI::ExtrasError&) {
    throw BadInput(chosen().not_expected(app_.remaining(true).front()));
  } catch (const CLI::ArgumentMismatch& error) {
    throw BadInput(wrong_count(error));
  } catch (const CLI::ParseError& error) {
    throw BadInput(error.what());
  }
  const Command& command = chosen();
  command.refuse_missing_values();
  if (!command.run) {
    throw BadInput(fmt::format("which command? There are: {}; see: {} --help",
                               config::join(command.names_of_commands()), command.full_name()));
  }
  return {&command, {}};
}

}  // namespace regista::cli
