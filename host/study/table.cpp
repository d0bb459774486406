// SPDX-License-Identifier: MIT
#include "study/table.hpp"

#include <csv.h>
#include <fmt/format.h>
#include <utf8proc.h>
#include <zlib.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <map>
#include <utility>

#include "texts/message.hpp"

namespace regista::study {

void Table::Close::operator()(gzFile_s* file) const { gzclose_r(file); }

void Table::Close::operator()(csv_parser* parser) const {
  csv_free(parser);
  delete parser;
}

Table::Table(const std::filesystem::path& file, Progress progress)
    : name_(file.string()), progress_(std::move(progress)), parser_(new csv_parser) {
  csv_init(parser_.get(), CSV_STRICT);
  csv_set_space_func(parser_.get(),
                     [](unsigned char byte) -> int { return byte == ' ' || byte == '\t' || byte == '\r'; });
  csv_set_term_func(parser_.get(), [](unsigned char byte) -> int { return byte == '\n'; });
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored)) throw config::Error({name_}, "is a folder, not a table");
  // Reading a pipe could wait forever, and reading a device might never end.
  if (std::filesystem::is_other(file, ignored)) throw config::Error({name_}, "is not a regular file");
  errno = 0;
  file_.reset(gzopen(name_.c_str(), "rb"));  // gzopen also reads files that are not compressed
  if (!file_) throw config::Error({name_}, fmt::format("cannot be opened: {}", std::strerror(errno)));
  gzbuffer(file_.get(), 1u << 17);
  if (!read_row()) throw config::Error({name_}, "is empty; expected a first line with the names of columns");
  for (std::size_t i = 0; i < fields_.size(); ++i) columns_.emplace_back(text(i));
  if (of_games_) columns_ = {"White", "Black", "Result"};
  if (const std::size_t at = columns_[0].find(';'); columns_.size() == 1 && at != std::string::npos)
    refuse_line(at, "semicolons between columns; expected commas");
}

bool Table::has_column(std::string_view name) const { return std::ranges::find(columns_, name) != columns_.end(); }

std::size_t Table::column(std::string_view name, std::string_view layout) const {
  const auto found = std::ranges::find(columns_, name);
  if (found != columns_.end()) return static_cast<std::size_t>(found - columns_.begin());
  const std::string message = texts::unknown("column", name, "this file", columns_);
  throw config::Error({name_, 1, 1}, layout.empty() ? message : fmt::format("{}; {}", message, layout));
}

bool Table::next() {
  if (of_games_) return read_game();
  if (!read_row()) return false;
  if (fields_.size() != columns_.size()) {
    throw config::Error({name_, fields_[0].line, 1},
                        fmt::format("{} values, but the first line names {} columns", fields_.size(), columns_.size()));
  }
  if (progress_ && lines_ % 16'384 == 0) progress_(lines_);
  return true;
}

bool Table::read_line() {
  line_.clear();
  ++lines_;
  const gzFile file = file_.get();
  int byte = 0;
  while (byte != '\n' && (byte = gzgetc(file)) != -1) {
    if (line_.size() == longest_line)
      refuse_line(0, fmt::format("is longer than {} bytes; this is no table of comma-separated values", longest_line));
    line_ += static_cast<char>(byte);
  }
  if (byte != '\n') {
    int code = Z_OK;
    const char* message = gzerror(file, &code);
    if (code != Z_OK && code != Z_STREAM_END) {
      const std::string reason = code == Z_ERRNO ? std::strerror(errno) : message;
      refuse_line(0, fmt::format("cannot be read on: {}", texts::one_line(reason)));
    }
    if (line_.empty()) return false;
    line_ += '\n';  // the last line has no end of line
  }
  if (lines_ > most_lines) refuse_line(0, fmt::format("a table may have at most {} lines", most_lines));
  if (lines_ == 1) {
    if (line_.starts_with("\xff\xfe") || line_.starts_with("\xfe\xff"))
      refuse_line(0, "is UTF-16 text; save the file as UTF-8");
    if (line_.starts_with("\xef\xbb\xbf")) line_.erase(0, 3);  // a byte order mark
  }
  for (std::size_t i = 0; i < line_.size();) {
    const auto lead = static_cast<unsigned char>(line_[i]);
    const std::size_t length = lead < 0x80 ? 1 : texts::first_character(std::string_view(line_).substr(i)).bytes;
    if (length == 0) refuse_line(i, fmt::format("byte 0x{:02x} is not UTF-8; save the file as UTF-8", lead));
    if (lead == 0) refuse_line(i, "byte 0x00 is not text; is this a binary file?");
    i += length;
  }
  return true;
}

// Passes libcsv one field at a time, with the byte that ends the field. So the next field begins after that byte.
bool Table::read_row() {
  text_.clear();
  fields_.clear();
  row_ended_ = false;
  for (std::size_t bytes = 0; !row_ended_;) {
    if (bytes > longest_line || !read_line()) {
      if (bytes == 0) return false;
      throw config::Error({name_, begun_.line, begun_.column}, "this field begins with a quote that is not closed");
    }
    if (bytes == 0 && line_.find_first_not_of(" \t\r\n") == std::string::npos) continue;
    if (bytes == 0) begin_field(0);
    bytes += line_.size();
    of_games_ = columns_.empty() && line_[0] == '[';
    if (of_games_) return true;
    for (std::size_t from = 0; from < line_.size();) {
      const std::size_t size = std::min(line_.find(',', from), line_.size() - 1) + 1 - from, known = fields_.size();
      const std::size_t read = csv_parse(
          parser_.get(), line_.data() + from, size,
          [](void* field, std::size_t length, void* table) {
            auto& self = *static_cast<Table*>(table);
            self.fields_.push_back({self.text_.size(), length, self.begun_.line, self.begun_.column});
            self.text_.append(static_cast<const char*>(field), length);
          },
          [](int, void* table) { static_cast<Table*>(table)->row_ended_ = true; }, this);
      from += read;
      if (read < size)
        refuse_line(from, "a quote inside a field; expected the whole field in quotes, each quote inside it doubled");
      if (fields_.size() > known) begin_field(from);
    }
  }
  return true;
}

void Table::begin_field(std::size_t byte) {
  begun_.line = static_cast<int>(lines_);
  begun_.column = static_cast<int>(line_.find_first_not_of(" \t", byte)) + 1;
}

// Reads the next game of a PGN file. The headers of one game are consecutive lines.
bool Table::read_game() {
  text_.clear();
  fields_.assign(columns_.size(), {0, 0, 0, 1});
  int first = 0;  // the line of the first header
  // The first header of the file has been read as the first line of the table, so it is not read again.
  for (bool more = static_cast<int>(lines_) == begun_.line || read_line(); more; more = read_line()) {
    if (line_[0] != '[' && first > 0) break;
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      const std::string before = fmt::format("[{} \"", columns_[i]);
      if (!line_.starts_with(before)) continue;
      if (fields_[i].line > 0)
        refuse_line(0, fmt::format("a second header {} of one game; expected a blank line before", columns_[i]));
      begin_field(before.size() - 1);
      if (first == 0) first = begun_.line;
      const std::size_t from = text_.size();
      for (std::size_t at = before.size(); line_[at] != '"'; ++at) {
        if (line_[at] == '\\') ++at;
        if (at + 1 >= line_.size()) refuse_line(before.size() - 1, "this quote is not closed");
        text_ += line_[at];
      }
      fields_[i] = {from, text_.size() - from, begun_.line, begun_.column};
    }
  }
  for (std::size_t i = 0; first > 0 && i < columns_.size(); ++i) {
    if (fields_[i].line == 0) throw config::Error({name_, first, 1}, "this game has no header " + columns_[i]);
  }
  return first > 0;
}

std::optional<double> Table::value(std::size_t column) const {
  std::string_view digits = text(column);
  if (digits.size() > 1 && digits[0] == '+' && digits[1] != '-') digits.remove_prefix(1);
  double value = 0.0;
  const auto [rest, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error == std::errc::result_out_of_range) refuse(column, "is beyond all numbers");
  if (error != std::errc() || rest != digits.data() + digits.size()) return std::nullopt;
  return value;
}

double Table::number(std::size_t column) const {
  const std::optional<double> number = value(column);
  if (!number) refuse(column, "is no number");
  if (!std::isfinite(*number)) refuse(column, "is not finite");
  return *number;
}

std::int64_t Table::count(std::size_t column, std::int64_t most) const {
  const std::optional<double> number = value(column);
  if (!number || !(*number >= 0.0 && *number <= static_cast<double>(most)) || *number != std::trunc(*number))
    refuse(column, fmt::format("is no whole number from 0 to {}", most));
  return static_cast<std::int64_t>(*number);
}

config::Location Table::where(std::size_t column) const {
  return {name_, fields_[column].line, fields_[column].column};
}

void Table::refuse(std::size_t column, const std::string& message) const {
  const std::string found = fmt::format("{}: {}", texts::one_line(columns_[column]), texts::in_quotes(text(column)));
  throw config::Error(where(column), found + ' ' + message);
}

void Table::refuse_line(std::size_t byte, const std::string& message) const {
  throw config::Error({name_, static_cast<int>(lines_), static_cast<int>(byte) + 1}, message);
}

namespace {

using statistics::Encounter;
using statistics::GameOutcome;

// Names of a layout's columns: first the two teams, then the results in the order of the counts.
using Layout = std::vector<std::string>;
const Layout pairs{"first", "second", "LL", "LD", "DD", "WD", "WW"},
    games{"first", "second", "losses", "draws", "wins"}, scores{"first", "second", "score"},
    goals{"home", "away", "home_goals", "away_goals"}, chess{"White", "Black", "Result"};

// Returns the layout whose columns of results the table has. A table has columns of results of one kind only.
const Layout& layout_of(const Table& table) {
  const auto has = [&](const std::string& name) { return table.has_column(name); };
  std::vector<const Layout*> found;
  for (const Layout* each : {&pairs, &games, &scores, &goals, &chess}) {
    if (std::any_of(each->begin() + 2, each->end(), has)) found.push_back(each);
  }
  if (found.size() == 1) return *found[0];
  throw config::Error(table.where(0),
                      fmt::format("{} columns of results; expected LL, LD, DD, WD, WW (pairs), wins, draws, losses "
                                  "(games), or a game a line: score, or home_goals, away_goals",
                                  found.empty() ? "no" : "two kinds of"));
}

void refuse_unknown_columns(const Table& table, Layout known) {
  // Columns without results that are allowed: the row numbers of pandas and R, and columns of a tournament's table.
  static const Layout left_out{"", "row", "seed", "opening", "ended", "forfeited_by", "plugin", "call", "why"};
  const bool of_tournament = table.has_column("state_hash");  // such a table also has columns of metrics
  if (known != pairs && known != games) known.emplace_back("pair");
  for (std::size_t i = 0; i < table.columns().size(); ++i) {
    const std::string& name = table.columns()[i];
    if (std::ranges::count(known, name) == 0) {
      if (of_tournament || name.starts_with("Unnamed: ") || std::ranges::count(left_out, name) > 0) continue;
      throw config::Error(table.where(i), texts::unknown("column", name, "", known));
    }
    if (std::ranges::count(table.columns(), name) > 1) {
      throw config::Error(table.where(i), fmt::format("column {} stands twice", texts::in_quotes(name)));
    }
  }
}

class Reader {
 public:
  explicit Reader(const std::filesystem::path& file) : file_(file.string()), table_(file), layout_(layout_of(table_)) {
    refuse_unknown_columns(table_, layout_);
    for (const std::string& each : layout_) columns_.push_back(table_.column(each));
    if (table_.has_column("pair")) pair_ = table_.column("pair");
  }

  ResultsOfTeams read() {
    while (table_.next()) take_line();
    std::optional<config::Location> alone;  // the incomplete pair with the smallest line number
    for (const auto& [key, game] : open_) {
      if (game.complete || !game.outcome) continue;
      out_.encounters[key.first].games.add(*game.outcome);
      if (!alone || game.where.line < alone->line) alone = game.where;
    }
    // An unfinished tournament (layout `goals`) may have such a pair, and its own ranking also counts the game.
    if (alone && &layout_ != &goals) throw config::Error(*alone, "this pair has one game; expected two");
    const auto played = [](const Encounter& each) { return each.games_played() > 0; };
    if (std::ranges::none_of(out_.encounters, played)) throw config::Error({file_}, "holds no game");
    const std::string left_out = texts::plural(left_out_, "game is", "games are") + " left out: ";
    if (left_out_ > 0) out_.remarks.push_back(left_out + "without a result, or in a pair with such a game.");
    remark_on_forms();
    return std::move(out_);
  }

 private:
  struct Game {
    std::optional<GameOutcome> outcome;  // nothing without a result
    config::Location where;
    bool complete = false;
  };

  void take_line() {
    const std::size_t first = team(columns_[0]), second = team(columns_[1]);
    if (first == second) table_.refuse(columns_[1], "stands on both sides; expected two different teams");
    const bool turned = first > second;
    const auto [place, is_new] =
        encounter_.try_emplace({std::min(first, second), std::max(first, second)}, out_.encounters.size());
    if (is_new) out_.encounters.push_back({std::min(first, second), std::max(first, second), {}, {}});
    Encounter& encounter = out_.encounters[place->second];
    if (&layout_ == &pairs) {
      add(encounter.pairs, counts<statistics::PairCounts>(), turned);
    } else if (&layout_ == &games) {
      add(encounter.games, counts<statistics::GameCounts>(), turned);
    } else {
      take_game(encounter, place->second, turned);
    }
  }

  std::size_t team(std::size_t column) {
    const std::string name(table_.text(column));
    if (name.empty()) table_.refuse(column, "is no name of a team");
    const auto [place, is_new] = team_.try_emplace(name, out_.teams.size());
    if (is_new) {
      if (out_.teams.size() == most_ranked_teams) {
        table_.refuse(column, fmt::format("is one team too many: at most {} can be ranked", most_ranked_teams));
      }
      out_.teams.push_back(name);
    }
    return place->second;
  }

  template <class Counts>
  Counts counts() const {
    Counts out;
    for (std::size_t i = 2; i < columns_.size(); ++i)
      out.seen[i - 2] = table_.count(columns_[i], statistics::most_counted);
    return out;
  }

  template <class Counts>
  void add(Counts& sum, const Counts& line, bool turned) const {
    const Counts mine = turned ? swapped(line) : line;
    for (std::size_t i = 0; i < mine.seen.size(); ++i) {
      sum.seen[i] += mine.seen[i];
      if (sum.seen[i] > statistics::most_counted) {
        table_.refuse(columns_[2], fmt::format("brings the sum of these teams above {}", statistics::most_counted));
      }
    }
  }

  // Returns the points of the team that the line names first; nothing for a game without a result.
  std::optional<double> points() const {
    const std::string_view text = table_.text(columns_[2]);
    if (&layout_ == &goals) {
      if (text.empty() && table_.text(columns_[3]).empty()) return std::nullopt;
      const std::int64_t scored = table_.count(columns_[2], statistics::most_counted),
                         conceded = table_.count(columns_[3], statistics::most_counted);
      return scored > conceded ? 1.0 : scored < conceded ? 0.0 : 0.5;
    }
    if (text == "*") return std::nullopt;  // in PGN, a game that has not ended
    if (text == "1-0" || text == "0-1") return text == "1-0" ? 1.0 : 0.0;
    const std::optional<double> score = text == "1/2-1/2" ? 0.5 : table_.value(columns_[2]);
    if (score != 1.0 && score != 0.5 && score != 0.0)
      table_.refuse(columns_[2], "is no score; expected 1, 0.5 or 0, or 1-0, 1/2-1/2 or 0-1");
    return score;
  }

  void take_game(Encounter& encounter, std::size_t number, bool turned) {
    std::optional<GameOutcome> now;
    if (const auto score = points()) now = static_cast<GameOutcome>(2.0 * (turned ? 1.0 - *score : *score));
    if (!now) ++left_out_;
    const std::string name(pair_ ? table_.text(*pair_) : std::string_view());
    if (name.empty()) {
      if (now) encounter.games.add(*now);
      return;
    }
    const auto [game, is_new] = open_.try_emplace({number, name}, Game{now, table_.where(*pair_)});
    if (is_new) return;
    if (game->second.complete) table_.refuse(*pair_, "has two games already; a pair is two games");
    game->second.complete = true;
    if (now && game->second.outcome)
      encounter.pairs.add(pair_outcome(*game->second.outcome, *now));
    else if (now || game->second.outcome)
      ++left_out_;
  }

  // Remarks on names that differ only in their form of Unicode: an accent may be a part of its letter (NFC) or follow
  // the letter (Unicode Standard Annex #15, "Unicode Normalization Forms").
  void remark_on_forms() {
    std::map<std::string, std::string> spelled;  // key: the name in the form NFC
    for (const std::string& name : out_.teams) {
      const auto* const bytes = reinterpret_cast<const utf8proc_uint8_t*>(name.c_str());
      const std::unique_ptr<utf8proc_uint8_t, decltype(&std::free)> form(utf8proc_NFC(bytes), &std::free);
      const auto [other, is_new] = spelled.try_emplace(form ? reinterpret_cast<const char*>(form.get()) : name, name);
      if (!is_new)
        out_.remarks.push_back(fmt::format("{} and {} are two teams, but one name in two forms of Unicode; use NFC.",
                                           texts::in_quotes(other->second), texts::in_quotes(name)));
    }
  }

  std::string file_;
  Table table_;
  const Layout& layout_;
  std::vector<std::size_t> columns_;  // in the order of the layout
  std::optional<std::size_t> pair_;
  std::uint64_t left_out_ = 0;
  ResultsOfTeams out_;
  std::map<std::string, std::size_t> team_;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> encounter_;
  std::map<std::pair<std::size_t, std::string>, Game> open_;
};

}  // namespace

ResultsOfTeams read_results_of_teams(const std::filesystem::path& file) { return Reader(file).read(); }

}  // namespace regista::study
