// SPDX-License-Identifier: MIT
#include "report/outline.hpp"

#include <algorithm>

#include "report/match_remarks.hpp"
#include "report/number.hpp"
#include "texts/json.hpp"
#include "texts/message.hpp"

namespace regista::report {

std::string plain(const Sentence& sentence) {
  std::string out;
  for (const Sentence::Piece& each : sentence.pieces()) {
    if (each.kind != Sentence::Kind::mark) out += texts::visible(each.text);
  }
  return out;
}

std::string question_of(const Outline& outline) {
  return outline.name.empty() || outline.question.empty() ? outline.question : outline.name + ": " + outline.question;
}

void Section::line(Sentence sentence, Readers readers) {
  if (sentence.empty()) return;
  // Successive lines for the same readers form one block.
  auto* const last =
      items.empty() || items.back().readers != readers ? nullptr : std::get_if<Lines>(&items.back().what);
  if (last != nullptr && last->style == Lines::Style::paragraphs)
    last->lines.push_back(std::move(sentence));
  else
    items.push_back({Lines{{std::move(sentence)}, Lines::Style::paragraphs}, readers});
}

void Section::note(Sentence sentence, Readers readers) {
  if (!sentence.empty()) items.push_back({Lines{{std::move(sentence)}, Lines::Style::note}, readers});
}

void Section::list(std::vector<Sentence> sentences, Readers readers) {
  if (!sentences.empty()) items.push_back({Lines{std::move(sentences), Lines::Style::list}, readers});
}

void Section::table(Table table, Readers readers) {
  if (!table.rows.empty()) items.push_back({std::move(table), readers});
}

void Section::figures(std::vector<std::string> names, Figures::Style style) {
  items.push_back({Figures{std::move(names), style}, Readers::page});
}

void Section::listing(Sentence summary, std::string text) {
  if (!text.empty()) items.push_back({Listing{std::move(summary), std::move(text)}, Readers::page});
}

std::string outline_json(const Outline& outline) {
  nlohmann::ordered_json out{{"played", played_json(outline.played)}, {"headline", plain(outline.headline)}};
  std::vector<std::string> beside;
  for (const Sentence& each : outline.beside) beside.push_back(plain(each));
  out["beside"] = beside;
  out.update(outline.data());
  add_remarks(outline.remarks, out);
  return text_of(out);
}

// Writes the text for a terminal. The headline is at the end, because readers of a terminal look there first.
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

// Formats a cell for a terminal. Words of the program use ASCII signs; names, paths and values of users stay unchanged.
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

}  // namespace

std::string section_text(const Section& section) {
  std::string out;
  for (const Item& each : section.items) {
    if (!is_in_text(each.readers)) continue;
    if (const auto* const lines = std::get_if<Lines>(&each.what)) {
      const char* const before = lines->style == Lines::Style::list ? "  " : "";
      for (const Sentence& line : lines->lines) out += before + plain(line) + '\n';
    }
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
