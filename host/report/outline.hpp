// SPDX-License-Identifier: MIT
// The outline of a study's report: a headline, sections with sentences, tables and figures for people, and numbers for
// programs. Each study makes one outline. outline.cpp writes it as text and JSON, outline_page.cpp as an HTML page.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <functional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "report/figure.hpp"
#include "report/what_was_played.hpp"
#include "study/measure.hpp"

namespace regista::report {

// A text of a report: words of the program, and names, paths and commands of users. The text for a terminal and the
// page mark and escape the words of users differently.
class Sentence {
 public:
  enum class Kind {
    words,   // words of the program
    strong,  // emphasised words of the program
    name,    // a name that a user gave
    code,    // a command or a value
    path,    // path of a value or of a file; a line may break after a point or an underscore
    mark,    // coloured sign of a team on a page: "first" or "second"
    link     // link to a file beside the page, or to a place on the page
  };
  struct Piece {
    Kind kind;
    std::string text;
    // Only for a link whose words differ from its target: path of the file (empty: this page) and fragment.
    std::string file{}, fragment{};
  };

  Sentence() = default;
  Sentence(std::string words) { add(Kind::words, std::move(words)); }  // NOLINT(google-explicit-constructor)
  Sentence(const char* words) : Sentence(std::string(words)) {}        // NOLINT(google-explicit-constructor)
  Sentence(Kind kind, std::string_view text) { add(kind, std::string(text)); }
  static Sentence link_to(std::string_view words, std::string_view file, std::string_view fragment) {
    Sentence out;
    out.pieces_.push_back({Kind::link, std::string(words), std::string(file), std::string(fragment)});
    return out;
  }

  Sentence& operator<<(const Sentence& more) {
    pieces_.insert(pieces_.end(), more.pieces_.begin(), more.pieces_.end());
    return *this;
  }
  bool empty() const { return pieces_.empty(); }
  const std::vector<Piece>& pieces() const { return pieces_; }

 private:
  void add(Kind kind, std::string text) {
    if (!text.empty()) pieces_.push_back({kind, std::move(text)});
  }
  std::vector<Piece> pieces_;
};

inline Sentence strong(std::string_view words) { return {Sentence::Kind::strong, words}; }
inline Sentence named(std::string_view name) { return {Sentence::Kind::name, name}; }
inline Sentence code(std::string_view words) { return {Sentence::Kind::code, words}; }
inline Sentence path(std::string_view path) { return {Sentence::Kind::path, path}; }

std::string plain(const Sentence& sentence);  // one line with escapes for invisible characters
texts::Html html(const Sentence& sentence);

// Which readers see a part of the report: readers of the text in a terminal, of the page, or of both. A terminal has
// less room than a page. Programs read only Outline::data.
enum class Readers : unsigned char { all, terminal, page };

// The content of a table cell. In words of the program, a terminal shows ASCII characters for the signs ±, – and ∞.
struct Cell {
  Sentence words;
  bool stressed = false;
  int series = 0;       // number of the series whose colour a page uses as background (page.css); 0: no background
  double ground = 0.0;  // strength of the background colour, 0 to 100 %

  Cell() = default;
  Cell(Sentence words_) : words(std::move(words_)) {}     // NOLINT(google-explicit-constructor)
  Cell(std::string words_) : words(std::move(words_)) {}  // NOLINT(google-explicit-constructor)
  Cell(const char* words_) : words(words_) {}             // NOLINT(google-explicit-constructor)
  template <class Count>
  requires std::is_integral_v<Count> Cell(Count count)
      : words(std::to_string(count)) {}  // NOLINT(google-explicit-constructor)
};

enum class Column { number, words };  // number: aligned to the right; words: aligned to the left

struct Heading {
  Sentence title;
  Column column = Column::number;
  Readers readers = Readers::all;
};

struct Row {
  std::vector<Cell> cells;  // one cell for each heading
  Readers readers = Readers::all;
};

struct Table {
  enum class Style { plain, values, tight, heat };  // values: long texts; tight: many columns; heat: coloured cells

  std::vector<Heading> headings;
  std::vector<Row> rows;
  Style style = Style::plain;
  std::string summary;    // a line above the table; on a page, a click on this line shows or hides the table
  bool open = false;      // true: the page shows the folded table open at first
  bool sortable = false;  // readers of a page may sort and filter the table
  std::string file, csv;  // name and content of a download from a page

  explicit Table(std::vector<Heading> headings_) : headings(std::move(headings_)) {}
  void row(std::vector<Cell> cells, Readers readers = Readers::all) { rows.push_back({std::move(cells), readers}); }
};

struct Lines {
  enum class Style { paragraphs, note, list, heading };
  std::vector<Sentence> lines;
  Style style = Style::paragraphs;
};

struct Figures {
  enum class Style { single, beside };  // single: each figure is as wide as the page; beside: two figures share a row
  std::vector<std::string> names;       // a page ignores names of figures that do not exist
  Style style = Style::single;
};

// A text of several lines. A page shows only the summary until the reader clicks on the summary.
struct Listing {
  Sentence summary;
  std::string text;
  bool open = false;  // true: the page shows the text without a click
};

struct Item {
  std::variant<Lines, Table, Figures, Listing> what;
  Readers readers = Readers::all;
};

struct Section {
  std::string id, title;
  std::vector<Item> items;

  Section(std::string id_, std::string title_) : id(std::move(id_)), title(std::move(title_)) {}
  // These functions ignore empty sentences, lists, tables and texts.
  void line(Sentence sentence, Readers readers = Readers::all);
  void note(Sentence sentence, Readers readers = Readers::all);
  void list(std::vector<Sentence> sentences, Readers readers = Readers::all);
  void table(Table table, Readers readers = Readers::all);
  void figures(std::vector<std::string> names, Figures::Style style = Figures::Style::single);
  void listing(Sentence summary, std::string text);
  bool empty() const { return items.empty(); }
};

struct Tile {
  std::string number;
  Sentence what;
};

struct Outline {
  std::string kind, title;       // "Tournament", "new vs old (290 pairs)"
  std::string name, question;    // name of the study in its document, if the title lacks it; question of the study
  Sentence headline;             // the result in one line
  std::vector<Sentence> beside;  // sentences about the data behind the result and about its limits
  std::vector<Tile> tiles;       // the most important numbers
  std::string lead;              // name of the main figure, which a page shows beside the tiles
  WhatWasPlayed played;
  std::string fingerprint;  // hash of all matches; empty: unknown
  std::vector<Section> sections;
  study::MatchRemarks remarks;  // doubts and notes about single matches
  int reload_seconds = 0;       // s until the page of a running study reloads; 0: never
  // Returns every number in full precision for programs. Only outline_json() calls this function.
  std::function<nlohmann::ordered_json()> data;

  void add(Section section) {
    if (!section.empty()) sections.push_back(std::move(section));
  }
};

std::string question_of(const Outline& outline);  // "night: which is better?"; empty without a question
std::string outline_text(const Outline& outline);
std::string section_text(const Section& section);  // lines with line ends, without the section's title
std::string outline_json(const Outline& outline);  // one JSON object and a newline
// results: path relative to the page.
std::string outline_page(const Outline& outline, const std::string& results, const std::vector<Figure>& figures);

// Returns whether a file with these first bytes is a page of Regista.
bool is_our_page(std::string_view beginning);
inline constexpr std::size_t page_beginning = 512;  // number of first bytes that is_our_page() needs

}  // namespace regista::report
