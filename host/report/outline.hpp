// SPDX-License-Identifier: MIT
// What a study found, before it is known who reads it: a headline, sections of sentences, tables and figures for
// people, and the same in numbers for programs. Each study makes one; text, page and JSON are three renderers of it
// (outline_text.cpp, outline_page.cpp, outline.cpp).
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "report/figure.hpp"
#include "report/sentence.hpp"
#include "report/what_was_played.hpp"
#include "study/match_remarks.hpp"

namespace regista::report {

// Who sees it: a terminal has less room than a page. Programs read Outline::data.
enum class Readers : unsigned char { all, terminal, page };

// One value. The signs ±, – and ∞ of its words are written as every terminal can show them; what comes from users is no
// words, but a name, a path or code.
struct Cell {
  Sentence words;
  bool stressed = false;
  // On a page: how strongly it is coloured, 0 to 100 %, in the colour of this series (page_style.hpp); 0: not at all.
  int series = 0;
  double ground = 0.0;

  Cell() = default;
  Cell(Sentence words_) : words(std::move(words_)) {}     // NOLINT(google-explicit-constructor)
  Cell(std::string words_) : words(std::move(words_)) {}  // NOLINT(google-explicit-constructor)
  Cell(const char* words_) : words(words_) {}             // NOLINT(google-explicit-constructor)
  template <class Count>
  requires std::is_integral_v<Count> Cell(Count count)
      : words(std::to_string(count)) {}  // NOLINT(google-explicit-constructor)
};

enum class Column { number, words };  // numbers are set to the right, so that their digits line up

struct Heading {
  Sentence title;
  Column column = Column::number;
  Readers readers = Readers::all;
};

struct Row {
  std::vector<Cell> cells;  // as many as there are headings
  Readers readers = Readers::all;
};

struct Table {
  enum class Look { plain, values, tight, heat };  // of a page: long values, many columns, cells with a ground

  std::vector<Heading> headings;
  std::vector<Row> rows;
  Look look = Look::plain;
  std::string summary;    // a line above it; a page folds it under these words
  bool open = false;      // folded, but shown at first
  std::string file, csv;  // of a page: name and content under which it can be taken away

  explicit Table(std::vector<Heading> headings_) : headings(std::move(headings_)) {}
  void row(std::vector<Cell> cells, Readers readers = Readers::all) { rows.push_back({std::move(cells), readers}); }
};

struct Lines {
  enum class Look { paragraphs, note, list, heading };
  std::vector<Sentence> lines;
  Look look = Look::paragraphs;
};

struct Figures {
  enum class Look { single, wide, beside };  // as wide as the page, or beside each other
  std::vector<std::string> names;            // those that are not there are left out
  Look look = Look::single;
};

// Lines as they are, folded on a page.
struct Listing {
  Sentence summary;
  std::string text;
  bool open = false;  // not folded
};

struct Item {
  std::variant<Lines, Table, Figures, Listing> what;
  Readers readers = Readers::all;
};

struct Section {
  std::string id, title;
  std::vector<Item> items;

  Section(std::string id_, std::string title_) : id(std::move(id_)), title(std::move(title_)) {}
  // Nothing is added for empty ones.
  void line(Sentence sentence, Readers readers = Readers::all);
  void note(Sentence sentence, Readers readers = Readers::all);
  void list(std::vector<Sentence> sentences, Readers readers = Readers::all);
  void table(Table table, Readers readers = Readers::all);
  void figures(std::vector<std::string> names, Figures::Look look = Figures::Look::single);
  void listing(Sentence summary, std::string text);
  bool empty() const { return items.empty(); }
};

struct Tile {
  std::string number;
  Sentence what;
};

struct Outline {
  std::string kind, title;       // "Tournament", "new vs old (290 pairs)"
  std::string name, question;    // of its document, where the title does not say it; what the study asks
  Sentence headline;             // what came out, in one line
  std::vector<Sentence> beside;  // what it rests on, and what it does not say
  std::vector<Tile> tiles;       // its most important numbers
  WhatWasPlayed played;
  std::string fingerprint;  // of all matches; empty: not known
  std::vector<Section> sections;
  study::MatchRemarks remarks;  // what is held against single matches
  // For programs, every number in full; made where it is wanted.
  std::function<nlohmann::ordered_json()> data;

  void add(Section section) {
    if (!section.empty()) sections.push_back(std::move(section));
  }
};

std::string question_of(const Outline& outline);  // "night: which is better?"; empty where it asks nothing
std::string outline_text(const Outline& outline);
std::string section_text(const Section& section);  // without its title; lines, each ended
std::string outline_json(const Outline& outline);  // one object with a newline
// results: file, as seen from the page.
std::string outline_page(const Outline& outline, const std::string& results, const std::vector<Figure>& figures);

// Whether a file that begins so is such a page.
bool is_our_page(std::string_view beginning);
inline constexpr std::size_t page_beginning = 512;  // bytes that are enough to tell

}  // namespace regista::report
