// SPDX-License-Identifier: MIT
// Reads tables of comma-separated values as people, pandas, R and this program write them (RFC 4180), in UTF-8, plain
// or compressed by gzip. The first line names the columns; blank lines are ignored. libcsv splits a line into fields.
// Table passes libcsv one field at a time, to know the place of each field. A file of chess games is a table, too (PGN,
// "Portable Game Notation Specification and Implementation Guide", 1994), with the columns White, Black and Result.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "config/node.hpp"
#include "statistics/counts.hpp"

struct csv_parser;  // a type of libcsv
struct gzFile_s;    // a type of zlib

namespace regista::study {

// Called from time to time while a file is read. lines: number of lines so far. May throw to stop the reading.
using Progress = std::function<void(std::size_t lines)>;

class Table {
 public:
  static constexpr std::size_t longest_line = 65'536;     // bytes; also the limit for a field that spans several lines
  static constexpr std::size_t most_lines = 100'000'000;  // about the lines that a 1 kHz camera writes in a day

  // Opens the file and reads the names of its columns. All calls throw config::Error at the place of a mistake.
  explicit Table(const std::filesystem::path& file, Progress progress = {});
  Table(const Table&) = delete;
  Table& operator=(const Table&) = delete;

  // The index of a column. Throws if the first line does not name the column.
  std::size_t column(std::string_view name, std::string_view layout = {}) const;
  bool has_column(std::string_view name) const;
  std::span<const std::string> columns() const { return columns_; }  // in the order of the first line

  // Reads the next row; false at the end of the file.
  bool next();

  // Fields of the current row. Numbers are decimal: 1, 1.0, +1, .5, 1e0.
  std::string_view text(std::size_t column) const {
    return std::string_view(text_).substr(fields_[column].from, fields_[column].size);
  }
  std::optional<double> value(std::size_t column) const;  // nothing if it is not a number; may be infinite or NaN
  double number(std::size_t column) const;                // finite
  // A whole number from 0 to `most`, which is below 2^53; the text may be "3.0".
  std::int64_t count(std::size_t column, std::int64_t most) const;

  config::Location where(std::size_t column) const;  // place of the field or, before next(), of its column's name
  [[noreturn]] void refuse(std::size_t column, const std::string& message) const;  // throws config::Error at the field

 private:
  struct Field {
    std::size_t from = 0, size = 0;  // the field's position in text_
    int line = 0, column = 0;        // position in the file at which the field begins
  };
  struct Close {
    void operator()(gzFile_s* file) const;
    void operator()(csv_parser* parser) const;
  };
  bool read_line();
  bool read_row();
  void begin_field(std::size_t byte);
  bool read_game();
  [[noreturn]] void refuse_line(std::size_t byte, const std::string& message) const;

  std::string name_;
  Progress progress_;
  std::unique_ptr<gzFile_s, Close> file_;
  std::unique_ptr<csv_parser, Close> parser_;
  std::string line_;  // current line, with its line feed
  std::size_t lines_ = 0;
  bool of_games_ = false;  // true: the file holds chess games (PGN)
  std::vector<std::string> columns_;
  std::vector<Field> fields_;  // fields of the current row
  std::string text_;           // the texts of the fields, one after the other
  Field begun_;                // the field that is being read
  bool row_ended_ = false;
};

// --- Results of games that teams played elsewhere, as a table with columns in any order:
//
//   first, second and     LL, LD, DD, WD, WW: counts of pairs; DD also counts a pair with one win each
//                         wins, draws, losses: counts of games that belong to no pair
//                         score: one game per line: 1, 0.5 or 0 points for the first team, or 1-0, 1/2-1/2 or 0-1
//   home, away and        home_goals, away_goals: one game per line; a game without goals was not played
//   White, Black and      Result: as score; * for a game that has not ended
//
// Where lines are games, two lines of the same teams, in either order, with the same text in a column `pair` form a
// pair; a game with an empty field in that column belongs to no pair. All counts are from the first team's point of
// view. Counts of several lines with the same teams are added. The reader ignores the other columns that `regista
// report --csv` writes, and the index column that pandas and R write.

struct ResultsOfTeams {
  std::vector<std::string> teams;                 // in the order of their first line
  std::vector<statistics::Encounter> encounters;  // one per pairing, in the order of its first line
  std::vector<std::string> remarks;               // sentences about games that were left out and names that look alike
};

inline constexpr std::size_t most_ranked_teams = 500;

// Throws config::Error at the place of the mistake: a column that is missing or unknown, a count that is negative or
// not whole, a team against itself, a pair of one score or three games, no game at all.
ResultsOfTeams read_results_of_teams(const std::filesystem::path& file);

}  // namespace regista::study
