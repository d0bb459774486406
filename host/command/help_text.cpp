// SPDX-License-Identifier: MIT
#include "command/help_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>
#include <vector>

namespace regista::command {
namespace {

constexpr std::size_t most_for_names = 30;  // columns; a longer name has a line of its own

std::vector<std::string_view> words_of(std::string_view text) {
  std::vector<std::string_view> out;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find_first_of(" \n", begin), text.size());
    if (end > begin) out.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return out;
}

// The words in lines of at most `width` columns, all but the first of them indented. column: where the first begins.
std::string in_lines(std::string_view text, std::size_t width, std::size_t indentation, std::size_t column) {
  std::string out;
  bool first = true;
  for (const std::string_view word : words_of(text)) {
    if (!first && column + 1 + word.size() > width) {
      out += '\n' + std::string(indentation, ' ');
      column = indentation;
    } else if (!first) {
      out += ' ';
      ++column;
    }
    out += word;
    column += word.size();
    first = false;
  }
  return out + '\n';
}

std::string value_of(const OptionDeclaration& option) {
  if (option.choices.empty()) return option.type;
  return fmt::format("{}", fmt::join(option.choices, "|"));
}

std::string left_of(const OptionDeclaration& option) {
  if (option.is_positional()) return option.type + (option.is_list ? "..." : "");
  std::string out = fmt::format("{}", fmt::join(option.names, ", "));
  if (!option.is_flag()) out += ' ' + value_of(option);
  return out;
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

}  // namespace

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

}  // namespace regista::command
