// SPDX-License-Identifier: MIT
// Running words of a report, before it is known whether a terminal or a page shows them: pieces from the source, and
// names, paths and commands from elsewhere, which each renderer sets apart and escapes in its own way.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "report/html.hpp"

namespace regista::report {

class Sentence {
 public:
  enum class Kind {
    words,
    strong,
    name,  // that somebody gave to something
    code,  // a command, a value
    path,  // of a document or a file: it may go on in a new line after a point or an underscore
    mark,  // the sign of the first or the second team on a page: "first", "second"
    link   // to a file beside the page
  };
  struct Piece {
    Kind kind;
    std::string text;
  };

  Sentence() = default;
  Sentence(std::string words) { add(Kind::words, std::move(words)); }  // NOLINT(google-explicit-constructor)
  Sentence(const char* words) : Sentence(std::string(words)) {}        // NOLINT(google-explicit-constructor)
  Sentence(Kind kind, std::string_view text) { add(kind, std::string(text)); }

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

// As a reader may see it (texts/visible.hpp), in one line.
std::string plain(const Sentence& sentence);
Html html(const Sentence& sentence);

}  // namespace regista::report
