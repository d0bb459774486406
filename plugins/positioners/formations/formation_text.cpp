// SPDX-License-Identifier: MIT
#include "formation_text.hpp"

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <string>

#include "formation_file.hpp"
#include "role_list.hpp"

namespace formations {
namespace {

constexpr std::size_t players = 11;
constexpr std::string_view blank = " \t\r\v\f";

struct Word {
  std::string_view text;
  std::size_t column = 1;
};

// The words of the lines that are no comments, line by line.
class Lines {
 public:
  explicit Lines(std::string_view bytes) : rest_(bytes.substr(bytes.starts_with("\xef\xbb\xbf") ? 3 : 0)) {}

  // Takes the next line; false at the end, which then has no words.
  bool next() {
    words_.clear();
    while (!rest_.empty() && words_.empty()) {
      const std::size_t end = std::min(rest_.find('\n'), rest_.size());
      split(rest_.substr(0, end));
      rest_.remove_prefix(std::min(end + 1, rest_.size()));
      ++number_;
    }
    return !words_.empty();
  }

  std::size_t size() const { return words_.size(); }
  std::string_view word(std::size_t i) const { return i < words_.size() ? words_[i].text : std::string_view(); }
  bool is(std::string_view first, std::string_view second = {}) const {
    return word(0) == first && (second.empty() || word(1) == second);
  }

  std::string where(std::size_t i = 0) const { return place(number_, i < words_.size() ? words_[i].column : after_); }
  // At a word of the line, or behind its last one.
  [[noreturn]] void wrong(std::size_t i, const std::string& wanted) const {
    if (words_.empty()) refuse("line " + std::to_string(number_) + ": the file ends; expected " + wanted);
    refuse(where(i) + ": " + (i < words_.size() ? quoted(words_[i].text) : std::string("the line ends")) +
           "; expected " + wanted);
  }
  void require(bool holds, std::size_t i, const std::string& wanted) const {
    if (!holds) wrong(i, wanted);
  }

  double number(std::size_t i, const std::string& wanted) const {
    double out = 0.0;
    require(read(word(i), out), i, wanted);
    return out;
  }
  std::size_t count(std::size_t i, const std::string& wanted) const {
    std::size_t out = 0;
    require(read(word(i), out), i, wanted);
    return out;
  }
  // Whether the word is an integer, as partners are.
  bool is_whole(std::size_t i) const {
    int out = 0;
    return read(word(i), out);
  }
  void require_words(std::size_t count, const std::string& wanted) const {
    require(words_.size() >= count, words_.size(), wanted);
    require(words_.size() == count, count, "the end of the line after " + wanted);
  }

 private:
  // A comment may stand behind what a line says.
  void split(std::string_view line) {
    for (std::size_t at = line.find_first_not_of(blank); at != std::string_view::npos;) {
      const std::size_t end = std::min(line.find_first_of(blank, at), line.size());
      const std::string_view text = line.substr(at, end - at);
      if (text.starts_with('#') || text.starts_with("//")) return;
      words_.push_back({text, at + 1});
      after_ = end + 1;
      at = line.find_first_not_of(blank, end);
    }
  }
  template <class Number>
  static bool read(std::string_view word, Number& out) {
    if (word.starts_with('+')) word.remove_prefix(1);
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), out);
    return !word.empty() && error == std::errc() && end == word.data() + word.size();
  }

  std::string_view rest_;
  std::vector<Word> words_;
  std::size_t number_ = 0, after_ = 1;
};

struct Samples {
  std::vector<Sample> list;
  std::vector<std::string> names;

  Sample& begin(const Lines& lines, std::size_t x) {
    if (list.size() == most_samples) {
      refuse(lines.where() + ": has more than " + std::to_string(most_samples) + " samples; more are not read");
    }
    names.push_back("the sample at " + lines.where());
    return list.emplace_back(sample_at(lines.number(x, "a number, x of the ball"),
                                       lines.number(x + 1, "a number, y of the ball"), lines.where(x)));
  }
  void add(const Lines& lines, std::size_t x, std::size_t player) {
    const std::string of = " of position " + std::to_string(player);
    list.back().positions.push_back(
        position_at(lines.number(x, "a number, x" + of), lines.number(x + 1, "a number, y" + of), lines.where(x)));
  }
};

void require_row(Lines& lines, std::size_t player, const char* rest, const std::string& of = {}) {
  lines.next();
  const std::string number = std::to_string(player);
  lines.require(lines.word(0) == number, 0, quoted(number + rest) + of);
}

// Version 2: number, name, partner. Version 3: number, type, name, partner, marker, marker for set plays.
void read_roles(Lines& lines, std::size_t version) {
  for (std::size_t player = 1; player <= players; ++player) {
    require_row(lines, player, version == 3 ? " TYPE ROLE PARTNER MARKER MARKER" : " ROLE PARTNER");
    const std::size_t partner = version == 3 ? 3 : 2;
    lines.require(lines.is_whole(partner), partner, "the number of the position on the other side, or 0 or -1");
    lines.require(version != 3 || lines.size() >= 6, lines.size(), "a marker or x, two times");
  }
  lines.next();
  lines.require(lines.is("End", "Roles"), 0, "\"End Roles\"");
}

void read_samples(Lines& lines, Samples& out) {
  lines.next();
  lines.require(lines.is("Begin", "Samples"), 0, "\"Begin Samples 2 COUNT\"");
  lines.require(lines.word(2) == "2", 2, "2, the version of samples that is read");
  const std::size_t count = lines.count(3, "how many samples follow");
  if (count == 0) refuse(lines.where(3) + ": holds no samples");
  if (count > most_samples) {
    refuse(lines.where(3) + ": has " + std::to_string(count) + " samples; at most " + std::to_string(most_samples) +
           " are read");
  }
  for (std::size_t sample = 0; sample < count; ++sample) {
    lines.next();
    const std::string number = std::to_string(sample);
    if (lines.word(0).starts_with("-----")) {
      lines.require(lines.word(1) == number, 1, number + ", the number of the sample");
      lines.next();
    }
    lines.require(lines.is("Ball"), 0, "\"Ball X Y\" of sample " + number + " of " + std::to_string(count));
    out.begin(lines, 1);
    lines.require_words(3, "\"Ball X Y\"");
    for (std::size_t player = 1; player <= players; ++player) {
      require_row(lines, player, " X Y", " of sample " + number);
      out.add(lines, 1, player);
      lines.require_words(3, quoted(std::to_string(player) + " X Y"));
    }
  }
  lines.next();
  lines.require(lines.is("End", "Samples"), 0, "\"End Samples\" after " + std::to_string(count) + " samples");
  // Constraints are for another method, and librcsc itself ends at "End".
  while (lines.next() && !lines.is("End")) {
    lines.require(lines.is("Begin", "Constraints"), 0, "\"End\"");
    while (!lines.is("End", "Constraints")) {
      if (!lines.next()) lines.wrong(0, "\"End Constraints\"");
    }
  }
}

// Version 1: all roles in one line, which is the present one, then a sample in each.
void read_rows(Lines& lines, Samples& out) {
  for (std::size_t player = 1; player <= players; ++player) {
    const std::size_t name = 2 * (player - 1);
    lines.require(name < lines.size(), name, "\"Begin Roles\", or a name and a partner of eleven roles");
    lines.require(lines.is_whole(name + 1), name + 1, "the number of the position on the other side, or 0 or -1");
  }
  lines.require_words(2 * players, "eleven roles");
  while (true) {
    lines.next();
    if (lines.is("End")) break;
    lines.require(lines.size() > 0, 0, "a sample, or \"End\"");
    out.begin(lines, 0);
    for (std::size_t player = 1; player <= players; ++player) out.add(lines, 2 * player, player);
    lines.require_words(2 + 2 * players, "the ball and eleven positions");
  }
  if (out.list.empty()) refuse(lines.where() + ": holds no samples");
}

// One place for each, wherever the ball is; the present line is the first of them. Editors add empty samples.
void read_places(Lines& lines, Samples& out) {
  out.names.emplace_back();
  out.list.push_back(Sample{{0, 0}, {}});
  for (std::size_t player = 1; player <= players; ++player) {
    const std::string number = std::to_string(player);
    if (player > 1) lines.next();
    lines.require(lines.word(0) == number, 0, quoted(number + " ROLE X Y"));
    lines.require(lines.size() > 1, 1, "the name of a role");
    out.add(lines, 2, player);
    lines.require_words(4, quoted(number + " ROLE X Y"));
  }
  while (lines.next() && !lines.is("End")) {
    lines.require(lines.is("Begin", "Samples"), 0, "the end of the file after eleven positions");
    while (!lines.is("End", "Samples")) {
      if (!lines.next()) lines.wrong(0, "\"End Samples\"");
    }
  }
}

}  // namespace

bool is_text_form(std::string_view bytes) {
  Lines lines(bytes);
  return lines.next() && lines.is("Formation");
}

std::vector<Sample> read_text_form(std::string_view bytes) {
  Lines lines(bytes);
  lines.next();
  lines.require(lines.size() > 1, 1, "DelaunayTriangulation or Static");
  const Method method = method_of(lines.word(1), lines.where(1));
  std::size_t version = 0;  // not said
  if (lines.size() > 2) {
    version = lines.count(2, "the version of its form, 1 to 3");
    if (version > 3) refuse(lines.where(2) + ": its version is " + std::to_string(version) + "; read are 1 to 3");
  }
  lines.next();
  Samples out;
  if (lines.is("Begin", "Roles")) {
    read_roles(lines, version);
    read_samples(lines, out);
  } else if (method == Method::fixed) {
    read_places(lines, out);
  } else {
    lines.require(version < 2, 0, "\"Begin Roles\"");
    read_rows(lines, out);
  }
  if (method == Method::fixed && out.list.size() != 1) {
    refuse("is static but has " + std::to_string(out.list.size()) + " samples");
  }
  refuse_repeated_balls(out.list, out.names);
  return out.list;
}

}  // namespace formations
