// SPDX-License-Identifier: MIT
// An outline for a terminal: what came out is its last lines, where it is seen first.
#include <algorithm>
#include <cstddef>
#include <string_view>
#include <vector>

#include "report/match_remarks.hpp"
#include "report/outline.hpp"

namespace regista::report {
namespace {

bool is_in_text(Readers readers) { return readers != Readers::page; }

std::size_t characters(std::string_view text) {
  return static_cast<std::size_t>(
      std::ranges::count_if(text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

void replace(std::string& text, std::string_view sign, std::string_view by) {
  for (std::size_t at = text.find(sign); at != std::string::npos; at = text.find(sign, at + by.size()))
    text.replace(at, sign.size(), by);
}

// Of a table: our own words with the signs that every terminal has; names, paths and values of users as they are.
std::string cell_text(const Sentence& sentence) {
  std::string out;
  for (const Sentence::Piece& each : sentence.pieces()) {
    std::string piece = plain(Sentence(each.kind, each.text));
    if (each.kind == Sentence::Kind::words) {
      replace(piece, "±", "+/-");
      replace(piece, "–", "-");
      replace(piece, "∞", "inf");
    }
    out += piece;
  }
  return out;
}

std::string table_text(const Table& table) {
  std::vector<std::size_t> columns;
  for (std::size_t i = 0; i < table.headings.size(); ++i) {
    if (is_in_text(table.headings[i].readers)) columns.push_back(i);
  }
  std::vector<std::vector<std::string>> rows(1);
  for (const std::size_t i : columns) rows.front().push_back(cell_text(table.headings[i].title));
  for (const Row& row : table.rows) {
    if (!is_in_text(row.readers)) continue;
    std::vector<std::string>& cells = rows.emplace_back();
    for (const std::size_t i : columns) cells.push_back(cell_text(row.cells[i].words));
  }
  std::vector<std::size_t> widths(columns.size(), 0);
  for (const auto& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], characters(row[i]));
  }
  std::string out = table.summary.empty() ? std::string() : table.summary + '\n';
  for (const auto& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string room(widths[i] - characters(row[i]), ' ');
      if (i > 0) line += "  ";
      line += table.headings[columns[i]].column == Column::words ? row[i] + room : room + row[i];
    }
    line.erase(line.find_last_not_of(' ') + 1);
    out += line + '\n';
  }
  return out;
}

std::string lines_text(const Lines& lines) {
  std::string out;
  for (const Sentence& each : lines.lines) out += (lines.look == Lines::Look::list ? "  " : "") + plain(each) + '\n';
  return out;
}

}  // namespace

std::string section_text(const Section& section) {
  std::string out;
  for (const Item& each : section.items) {
    if (!is_in_text(each.readers)) continue;
    if (const auto* const lines = std::get_if<Lines>(&each.what)) out += lines_text(*lines);
    if (const auto* const table = std::get_if<Table>(&each.what)) out += (out.empty() ? "" : "\n") + table_text(*table);
  }
  return out;
}

std::string outline_text(const Outline& outline) {
  std::string out = section_text(doubts(outline.remarks));
  out += outline.kind + ": " + plain(outline.title) + '\n';
  if (const std::string question = question_of(outline); !question.empty()) out += plain(question) + '\n';
  const auto add = [&out](const Section& section) {
    const std::string content = section_text(section);
    if (!content.empty()) out += '\n' + section.title + '\n' + content;
  };
  add(played_section(outline.played));
  std::ranges::for_each(outline.sections, add);
  if (const std::string notes = section_text(notes_on(outline.remarks)); !notes.empty()) out += '\n' + notes;
  out += '\n' + plain(outline.headline) + '\n';
  for (const Sentence& each : outline.beside) out += plain(each) + '\n';
  return out;
}

}  // namespace regista::report
