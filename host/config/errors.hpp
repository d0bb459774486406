// SPDX-License-Identifier: MIT
// Mistakes of users: a mistake in a document (Error) or outside of documents (BadInput); all mistakes of a document.
#pragma once

#include <cstddef>
#include <functional>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace regista::config {

// A place in a file. Line and column (in bytes) count from 1. Line 0 means the whole file or a value of the command
// line. For a value of the command line, `file` is "--set path=value".
struct Location {
  std::string file = {};
  int line = 0, column = 0;
  // True for a value that a study lays over another document. Its relative file names start at the current folder.
  bool laid = false;
  bool is_laid() const { return laid || line == 0; }
  friend bool operator==(const Location&, const Location&) = default;
};

std::string to_string(const Location&);  // "file:line:column", or "file" if line is 0

// A mistake in a document. what() is one line "file:line:column: message"; control characters are escaped.
class Error : public std::runtime_error {
 public:
  Error(Location where, const std::string& message);
  const Location& where() const { return where_; }
  std::string message() const { return what() + before_message_; }  // what() without the place at its beginning

 private:
  Location where_;
  std::size_t before_message_;
};

// A request that cannot be fulfilled, for a reason outside of all documents. what() is one line with the reason.
class BadInput : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Collects the mistakes in a document. Most commands stop at the first mistake. `config check` continues as if the
// wrong value were missing. It reports all mistakes except those that only follow from another mistake.
class Mistakes {
 public:
  enum class After { stop, go_on };
  // looked_for: the name of a missing file is a mistake. as_they_stand: no file name is checked, for saved documents.
  enum class Files { looked_for, as_they_stand };
  explicit Mistakes(After after, Files files = Files::looked_for) : after_(after), files_(files) {}

  bool looks_for_files() const { return files_ == Files::looked_for; }

  // Takes a mistake in the value at `path` ("" for no value). After::stop: throws the mistake. After::go_on: stores it.
  void add(const Error& mistake, std::string_view path);

  // Runs `step`. If it throws Error, reports this as a mistake in the value at `path`.
  template <class Step>
  void attempt(std::string_view path, Step step) {
    try {
      step();
    } catch (const Error& mistake) {
      add(mistake, path);
    }
  }

  // Marks the value at `path` as unknown, because another mistake prevents reading it.
  void doubt(std::string_view path) { doubted_.emplace(path); }

  // Returns whether the value at `path`, or a map or list that contains it, is wrong or unknown.
  bool mistaken(std::string_view path) const;
  // Like mistaken(). Also returns true if a value inside of the value at `path` is wrong or unknown.
  bool doubtful(std::string_view path) const;

  // Marks the plugin that the document names at this Location as unknown.
  void doubt_place(const Location& place) { doubted_places_.push_back(place); }
  bool doubtful_place(const Location& place) const;

  // Adds the mistakes and unknown plugins of `others`. Unlike add(), marks no value as wrong, because the same path may
  // be right in this document.
  void take_over(const Mistakes& others);

  bool none() const { return total_ == 0; }
  std::size_t total() const { return total_; }
  // Returns at most 10000 mistakes in the order of lines: first mistakes in `file`, then mistakes in other files.
  std::vector<Error> in_order(std::string_view file) const;

 private:
  static constexpr std::size_t most_kept = 10'000;
  After after_;
  Files files_;
  std::size_t total_ = 0;
  std::vector<Error> found_;
  std::set<std::string> said_;
  std::set<std::string, std::less<>> doubted_;  // paths of unknown values
  std::vector<Location> doubted_places_;
};

}  // namespace regista::config
