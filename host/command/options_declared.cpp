// SPDX-License-Identifier: MIT
#include "command/options_declared.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <sstream>
#include <utility>
#include <variant>

#include "config/errors.hpp"
#include "texts/message.hpp"

namespace regista::command {

namespace {

constexpr std::size_t most_for_names = 30;  // columns; a longer name gets its own line

// Breaks the text into lines of at most `width` columns; indents all but the first. column: start of the first word.
std::string in_lines(std::string_view text, std::size_t width, std::size_t indentation, std::size_t column) {
  std::istringstream words{std::string(text)};
  std::string out;
  for (std::string word; words >> word; column += word.size()) {
    if (!out.empty() && column + 1 + word.size() > width) {
      out += '\n' + std::string(indentation, ' ');
      column = indentation;
    } else if (!out.empty()) {
      out += ' ';
      ++column;
    }
    out += word;
  }
  return out + '\n';
}

std::string left_of(const OptionDeclaration& option) {
  if (option.is_positional()) return option.type + (option.is_list ? "..." : "");
  const std::string names = texts::join(option.names);
  if (option.is_flag()) return names;
  return fmt::format("{} {}", names,
                     fmt::join(option.choices.empty() ? std::vector{option.type} : option.choices, "|"));
}

using Rows = std::vector<std::pair<std::string, std::string>>;

std::string table(std::string_view title, const Rows& rows, std::size_t width) {
  if (rows.empty()) return {};
  std::size_t column = 0;
  for (const auto& [left, right] : rows) {
    if (left.size() <= most_for_names) column = std::max(column, left.size());
  }
  column += 4;
  std::string out = fmt::format("\n{}:\n", title);
  for (const auto& [left, right] : rows) {
    out += "  " + left;
    const std::size_t end = left.size() + 2;
    out += end + 2 > column ? '\n' + std::string(column, ' ') : std::string(column - end, ' ');
    out += in_lines(right, width, column, column);
  }
  return out;
}

std::string usage(const CommandDeclaration& command) {
  std::string out = "Usage: " + command.full_name;
  if (!command.commands.empty()) out += " COMMAND";
  for (const OptionDeclaration& each : command.options) {
    if (each.is_positional()) out += ' ' + left_of(each);
  }
  return out + " [OPTIONS]\n";
}

// The values that completion offers: one of these words, a folder, or a file with one of these endings.
struct Candidates {
  std::vector<std::string> words = {};
  bool folders = false, files = false;
  std::vector<std::string> endings = {};  // {"yaml"}; empty: any ending
};

Candidates candidates(const OptionDeclaration& option) {
  using output::Reads, output::Writes;
  if (!option.choices.empty()) return {.words = option.choices};
  if (const auto* const reads = std::get_if<Reads>(&option.use)) {
    if (*reads == Reads::plugins) return {.folders = true};
    if (*reads == Reads::documents) return {.files = true, .endings = {"yaml", "yml"}};
    if (*reads == Reads::results) return {.files = true, .endings = {"db"}};
    return {.files = true};
  }
  if (const auto* const writes = std::get_if<Writes>(&option.use)) {
    const bool folders = *writes == Writes::figures || *writes == Writes::sources;
    return {.folders = folders, .files = !folders};
  }
  return {};
}

std::string joined(const std::vector<std::string>& words, std::string_view by) {
  return fmt::format("{}", fmt::join(words, by));
}

std::string in_single_quotes(std::string_view text) {
  std::string out = "'";
  for (const char c : text) {
    if (c == '\'') out += "'\\'";
    out += c;
  }
  return out + '\'';
}

// Returns the name of the shell function for a command such as "regista config check".
std::string function_name(const CommandDeclaration& command) {
  std::string out = '_' + command.full_name;
  std::ranges::replace_if(
      out, [](char c) { return c == ' ' || c == '-'; }, '_');
  return out;
}

// Returns a line of bash that writes the candidates into COMPREPLY; empty without candidates.
std::string bash_line(const Candidates& candidates) {
  if (!candidates.words.empty()) return "_regista_words " + in_single_quotes(joined(candidates.words, " "));
  if (candidates.folders) return "_regista_folders";
  return candidates.files ? "_regista_files " + in_single_quotes(joined(candidates.endings, "|")) : ":";
}

void add_bash(std::string& out, const CommandDeclaration& command) {
  out += fmt::format("    {})\n      case $before in\n", in_single_quotes(command.full_name));
  for (const OptionDeclaration& each : command.options) {
    if (each.is_positional() || each.is_flag()) continue;
    out += fmt::format("        {}) {}; return ;;\n", fmt::join(each.names, "|"), bash_line(candidates(each)));
  }
  out += "      esac\n";
  out += fmt::format("      if [[ $current == -* ]]; then _regista_words {}; return; fi\n",
                     in_single_quotes(joined(command.option_names(), " ")));
  if (!command.commands.empty()) {
    out += fmt::format("      _regista_words {}\n", in_single_quotes(joined(command.command_names(), " ")));
  } else if (const auto words = std::ranges::find_if(command.options, &OptionDeclaration::is_positional);
             words != command.options.end()) {
    out += fmt::format("      {}\n", bash_line(candidates(*words)));
  }
  out += "      ;;\n";
  for (const CommandDeclaration& each : command.commands) add_bash(out, each);
}

// Adds the full names of all commands, each in quotes.
void add_names(std::vector<std::string>& out, const CommandDeclaration& command) {
  out.push_back(in_single_quotes(command.full_name));
  for (const CommandDeclaration& each : command.commands) add_names(out, each);
}

// Escapes text for a zsh specification, whose separators are colons and brackets.
std::string zsh_text(std::string_view text) { return texts::with_backslashes(text, ":[]\\"); }

std::string zsh_action(const Candidates& candidates) {
  if (!candidates.words.empty()) return fmt::format("({})", joined(candidates.words, " "));
  if (candidates.folders) return "_files -/";
  if (!candidates.files) return " ";
  return candidates.endings.empty() ? "_files"
                                    : fmt::format("_files -g \"*.({})(-.)\"", joined(candidates.endings, "|"));
}

void add_zsh(std::string& out, const CommandDeclaration& command) {
  for (const CommandDeclaration& each : command.commands) add_zsh(out, each);
  out += fmt::format("{}() {{\n", function_name(command));
  out += command.commands.empty() ? "  _arguments -s -S" : "  local line state\n  _arguments -s -S -C";
  out += fmt::format(" \\\n    {}", in_single_quotes("(-h --help)--help[print this help]"));
  int place = 0;
  for (const OptionDeclaration& each : command.options) {
    const std::string many = each.is_list ? "*" : "";
    std::string spec = !each.is_positional() ? fmt::format("{}{}[{}]", many, each.name(), zsh_text(each.help))
                       : each.is_list        ? many
                                             : fmt::format("{}", ++place);
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

// Returns the options of fish's command `complete` for a value. -x without -a offers nothing; -r -F offers any file.
std::string fish_values(const Candidates& candidates) {
  if (!candidates.words.empty()) return "-x -a " + in_single_quotes(joined(candidates.words, " "));
  if (candidates.folders) return "-x -a '(__fish_complete_directories)'";
  if (!candidates.files) return "-x";
  if (candidates.endings.empty()) return "-r -F";
  std::vector<std::string> suffixes;
  for (const std::string& each : candidates.endings) suffixes.push_back("__fish_complete_suffix ." + each);
  return fmt::format("-x -k -a '({})'", joined(suffixes, "; "));
}

void add_fish(std::string& out, const CommandDeclaration& command, const std::string& program) {
  const std::string here =
      fmt::format("complete -c {0} -n 'test \"$(_{0}_command)\" = \"{1}\"'", program, command.full_name);
  out += fmt::format("{} -f -s h -l help -d 'print this help'\n", here);
  for (const OptionDeclaration& each : command.options) {
    std::string names = each.is_positional() ? "" : " -l " + each.name().substr(2);
    if (each.names.size() == 2) names = " -s " + each.names.front().substr(1) + names;
    const std::string values = each.is_flag() ? "-f" : fish_values(candidates(each));
    out += fmt::format("{}{} {} -d {}\n", here, names, values, in_single_quotes(each.help));
  }
  for (const CommandDeclaration& each : command.commands)
    out += fmt::format("{} -f -a {} -d {}\n", here, each.name, in_single_quotes(each.about));
  for (const CommandDeclaration& each : command.commands) add_fish(out, each, program);
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

std::vector<std::string> CommandDeclaration::option_names() const {
  std::vector<std::string> out{"--help"};
  for (const OptionDeclaration& each : options) {
    if (!each.is_positional()) out.push_back(each.name());
  }
  return out;
}

std::vector<std::string> CommandDeclaration::command_names() const {
  return texts::names_of(commands, &CommandDeclaration::name);
}

const CommandDeclaration& named(const CommandDeclaration& program, const std::vector<std::string>& words) {
  const CommandDeclaration* command = &program;
  for (const std::string& word : words) {
    const auto found = std::ranges::find(command->commands, word, &CommandDeclaration::name);
    if (found == command->commands.end()) {
      if (command->commands.empty()) throw config::BadInput(command->full_name + " has no commands of its own");
      throw config::BadInput(texts::unknown("command", word, command->full_name, command->command_names()));
    }
    command = &*found;
  }
  return *command;
}

std::string filled(std::string_view notes, std::size_t width) {
  std::string out, paragraph;
  const auto end_paragraph = [&] {
    if (!paragraph.empty()) out += in_lines(paragraph, width, 0, 0);
    paragraph.clear();
  };
  for (std::size_t begin = 0; begin < notes.size();) {
    const std::size_t end = std::min(notes.find('\n', begin), notes.size());
    const std::string_view line = notes.substr(begin, end - begin);
    begin = end + 1;
    if (line.empty() || line.starts_with(' ')) {
      end_paragraph();
      out += fmt::format("{}\n", line);
    } else {
      paragraph += fmt::format("{}\n", line);
      if (line.ends_with(':')) end_paragraph();
    }
  }
  end_paragraph();
  return out;
}

std::string help_text(const CommandDeclaration& command, std::size_t width) {
  Rows arguments, options, commands;
  for (const OptionDeclaration& each : command.options) {
    (each.is_positional() ? arguments : options).emplace_back(left_of(each), each.help);
  }
  options.emplace_back("-h, --help", "print this help");
  for (const CommandDeclaration& each : command.commands) commands.emplace_back(each.name, each.about);

  std::string out = in_lines(fmt::format("{}: {}", command.full_name, command.about), width, 0, 0) + '\n';
  out += in_lines(usage(command), width, 4, 0);
  out += table("Arguments", arguments, width);
  out += table("Commands", commands, width);
  out += table("Options", options, width);
  if (!command.notes.empty()) out += '\n' + filled(command.notes, width);
  return out;
}

// The scripts first find the command that the words name, then the option of the value at the cursor. Declared words
// reach the shell in single quotes.
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

std::string fish_completion(const CommandDeclaration& program) {
  std::vector<std::string> names;
  add_names(names, program);
  std::string out = fmt::format(
      "# Completion of {0} for fish, written by: {0} completion fish\n\n"
      "function _{0}_command  # the command that the words before the cursor name\n"
      "  set -l command {0}\n"
      "  for word in (commandline -opc)[2..]\n"
      "    if contains -- \"$command $word\" {1}\n      set command \"$command $word\"\n    end\n"
      "  end\n"
      "  echo $command\nend\n\ncomplete -c {0} -f\n",
      program.name, fmt::join(names, " "));
  add_fish(out, program, program.name);
  return out;
}

}  // namespace regista::command
