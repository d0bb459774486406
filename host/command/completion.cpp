// SPDX-License-Identifier: MIT
// Both scripts first find the command that the words name, then the option whose value is being typed. Words that were
// declared reach the shell in single quotes.
#include "command/completion.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <string_view>
#include <variant>

namespace regista::command {
namespace {

// What a value may be.
struct Candidates {
  enum class Kind { words, files, folders, nothing } kind = Kind::nothing;
  std::vector<std::string> words, endings;  // endings of files: {"yaml"}; empty: any
};

Candidates candidates(const OptionDeclaration& option) {
  using Kind = Candidates::Kind;
  if (!option.choices.empty()) return {Kind::words, option.choices, {}};
  if (const auto* const reads = std::get_if<output::Reads>(&option.use)) {
    switch (*reads) {
      case output::Reads::documents:
        return {Kind::files, {}, {"yaml", "yml"}};
      case output::Reads::results:
        return {Kind::files, {}, {"db"}};
      case output::Reads::data:
        return {Kind::files, {}, {}};
      case output::Reads::plugins:
        return {Kind::folders, {}, {}};
    }
  }
  if (const auto* const writes = std::get_if<output::Writes>(&option.use)) {
    const bool folder = *writes == output::Writes::figures || *writes == output::Writes::sources;
    return {folder ? Kind::folders : Kind::files, {}, {}};
  }
  return {};
}

std::string in_single_quotes(std::string_view text) {
  std::string out = "'";
  for (const char c : text) {
    if (c == '\'') out += "'\\'";
    out += c;
  }
  return out + '\'';
}

// "regista config check" as the name of a function of the shell.
std::string function_name(const CommandDeclaration& command) {
  std::string out = '_' + command.full_name;
  for (char& c : out) {
    if (c == ' ' || c == '-') c = '_';
  }
  return out;
}

const OptionDeclaration* positional(const CommandDeclaration& command) {
  for (const OptionDeclaration& each : command.options) {
    if (each.is_positional()) return &each;
  }
  return nullptr;
}

std::vector<std::string> option_names(const CommandDeclaration& command) {
  std::vector<std::string> out{"--help"};
  for (const OptionDeclaration& each : command.options) {
    if (!each.is_positional()) out.push_back(each.name());
  }
  return out;
}

// A line of bash that fills COMPREPLY, or nothing.
std::string bash_line(const Candidates& candidates) {
  using Kind = Candidates::Kind;
  switch (candidates.kind) {
    case Kind::words:
      return fmt::format("_regista_words {}", in_single_quotes(fmt::format("{}", fmt::join(candidates.words, " "))));
    case Kind::files:
      return fmt::format("_regista_files {}", in_single_quotes(fmt::format("{}", fmt::join(candidates.endings, "|"))));
    case Kind::folders:
      return "_regista_folders";
    case Kind::nothing:
      break;
  }
  return ":";
}

void add_bash(std::string& out, const CommandDeclaration& command) {
  out += fmt::format("    {})\n      case $before in\n", in_single_quotes(command.full_name));
  for (const OptionDeclaration& each : command.options) {
    if (each.is_positional() || each.is_flag()) continue;
    out += fmt::format("        {}) {}; return ;;\n", fmt::join(each.names, "|"), bash_line(candidates(each)));
  }
  out += "      esac\n";
  out += fmt::format("      if [[ $current == -* ]]; then _regista_words {}; return; fi\n",
                     in_single_quotes(fmt::format("{}", fmt::join(option_names(command), " "))));
  if (!command.commands.empty()) {
    std::vector<std::string> names;
    for (const CommandDeclaration& each : command.commands) names.push_back(each.name);
    out += fmt::format("      _regista_words {}\n", in_single_quotes(fmt::format("{}", fmt::join(names, " "))));
  } else if (const OptionDeclaration* const words = positional(command)) {
    out += fmt::format("      {}\n", bash_line(candidates(*words)));
  }
  out += "      ;;\n";
  for (const CommandDeclaration& each : command.commands) add_bash(out, each);
}

// The full names of all commands, each in quotes.
void add_names(std::vector<std::string>& out, const CommandDeclaration& command) {
  out.push_back(in_single_quotes(command.full_name));
  for (const CommandDeclaration& each : command.commands) add_names(out, each);
}

// In a specification of zsh, whose parts are divided by colons and in brackets.
std::string zsh_text(std::string_view text) {
  std::string out;
  for (const char c : text) {
    if (c == ':' || c == '[' || c == ']' || c == '\\') out += '\\';
    out += c;
  }
  return out;
}

std::string zsh_action(const Candidates& candidates) {
  using Kind = Candidates::Kind;
  switch (candidates.kind) {
    case Kind::words:
      return fmt::format("({})", fmt::join(candidates.words, " "));
    case Kind::files:
      if (candidates.endings.empty()) return "_files";
      return fmt::format("_files -g \"*.({})(-.)\"", fmt::join(candidates.endings, "|"));
    case Kind::folders:
      return "_files -/";
    case Kind::nothing:
      break;
  }
  return " ";
}

void add_zsh(std::string& out, const CommandDeclaration& command) {
  for (const CommandDeclaration& each : command.commands) add_zsh(out, each);
  out += fmt::format("{}() {{\n", function_name(command));
  if (!command.commands.empty()) {
    out += "  local line state\n";
  }
  out += "  _arguments -s -S";
  if (!command.commands.empty()) out += " -C";
  out += fmt::format(" \\\n    {}", in_single_quotes("(-h --help)--help[print this help]"));
  int place = 0;
  for (const OptionDeclaration& each : command.options) {
    if (each.is_positional()) {
      const std::string which = each.is_list ? "*" : fmt::format("{}", ++place);
      out += fmt::format(" \\\n    {}", in_single_quotes(fmt::format("{}:{}:{}", which, zsh_text(each.type),
                                                                     zsh_action(candidates(each)))));
      continue;
    }
    std::string spec = fmt::format("{}{}[{}]", each.is_list ? "*" : "", each.name(), zsh_text(each.help));
    if (!each.is_flag()) spec += fmt::format(":{}:{}", zsh_text(each.type), zsh_action(candidates(each)));
    out += fmt::format(" \\\n    {}", in_single_quotes(spec));
  }
  if (command.commands.empty()) {
    out += "\n}\n\n";
    return;
  }
  out += " \\\n    '1: :->command' '*:: :->rest'\n  case $state in\n    command)\n      local -a commands=(";
  for (const CommandDeclaration& each : command.commands) {
    out += fmt::format("\n        {}", in_single_quotes(fmt::format("{}:{}", zsh_text(each.name), each.about)));
  }
  out += ")\n      _describe command commands ;;\n    rest)\n      case $line[1] in\n";
  for (const CommandDeclaration& each : command.commands) {
    out += fmt::format("        {}) {} ;;\n", each.name, function_name(each));
  }
  out += "      esac ;;\n  esac\n}\n\n";
}

constexpr std::string_view bash_parts = R"(
_regista_words() {
  mapfile -t COMPREPLY < <(compgen -W "$1" -- "$current")
}

_regista_folders() {
  compopt -o filenames 2> /dev/null
  mapfile -t COMPREPLY < <(compgen -d -- "$current")
}

# $1: endings, divided by |; empty: files of any name.
_regista_files() {
  compopt -o filenames 2> /dev/null
  local name
  COMPREPLY=()
  while IFS= read -r name; do
    if [[ -d $name || -z $1 || .${name##*.} == .@($1) ]]; then COMPREPLY+=("$name"); fi
  done < <(shopt -s extglob; compgen -f -- "$current")
}
)";

}  // namespace

std::string bash_completion(const CommandDeclaration& program) {
  std::vector<std::string> names;
  add_names(names, program);
  std::string out = fmt::format("# Completion of {0} for bash, written by: {0} completion bash\n", program.name);
  out += bash_parts;
  out += fmt::format("\n_{}() {{\n", program.name);
  out += fmt::format(
      "  local current=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD-1]}} command={} word\n"
      "  COMPREPLY=()\n"
      "  for word in \"${{COMP_WORDS[@]:1:COMP_CWORD-1}}\"; do\n"
      "    case \"$command $word\" in\n"
      "      {}) command+=\" $word\" ;;\n"
      "    esac\n"
      "  done\n"
      "  case $command in\n",
      in_single_quotes(program.name), fmt::join(names, "|"));
  add_bash(out, program);
  return out + fmt::format("  esac\n}}\ncomplete -F _{0} {0}\n", program.name);
}

std::string zsh_completion(const CommandDeclaration& program) {
  std::string out =
      fmt::format("#compdef {0}\n# Completion of {0} for zsh, written by: {0} completion zsh\n\n", program.name);
  add_zsh(out, program);
  return out + fmt::format("{} \"$@\"\n", function_name(program));
}

}  // namespace regista::command
