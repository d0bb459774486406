// SPDX-License-Identifier: MIT
// Where readers tell what is wrong with a document. Most commands stop at the first mistake. `config check` goes on, as
// if the document did not say what is wrong, and tells all of them; what only follows from another one is left out.
#pragma once

#include <cstddef>
#include <functional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "config/node.hpp"

namespace regista::config {

class Mistakes {
 public:
  enum class After { stop, go_on };
  // Whether a file that is not there is a mistake. Not in a document that is read back, perhaps elsewhere: its files
  // are kept as they stand in it.
  enum class Files { looked_for, as_they_stand };
  explicit Mistakes(After after, Files files = Files::looked_for) : after_(after), files_(files) {}

  bool looks_for_files() const { return files_ == Files::looked_for; }

  // Of the value at `path`, "" where it is of none. stop: throws it. go_on: keeps it, once.
  void add(const Error& mistake, std::string_view path);

  // Takes a step that throws Error for a mistake in the value at `path`.
  template <class Step>
  void attempt(std::string_view path, Step step) {
    if (after_ == After::stop) {
      step();
      return;
    }
    try {
      step();
    } catch (const Error& mistake) {
      add(mistake, path);
    }
  }

  // What the value at `path` is to be, the document does not say, because of a mistake that was told elsewhere.
  void doubt(std::string_view path) { doubted_.emplace(path); }

  // Whether the value at `path`, or one around it, is mistaken or in doubt.
  bool mistaken(std::string_view path) const;
  // The same, or one inside of it: what is found out by its help need not be so.
  bool doubtful(std::string_view path) const;

  // A plugin's place, named by where it stands, of which it is not sure what it asks for.
  void doubt_place(const Location& place) { doubted_places_.push_back(place); }
  bool doubtful_place(const Location& place) const;

  // What others told, but for their paths, which mean another document.
  void take_over(const Mistakes& others);

  bool none() const { return total_ == 0; }
  std::size_t total() const { return total_; }
  // Those of `file`, then those of other files, each in the order of its lines. At most the first 10000 that were
  // found.
  std::vector<Error> in_order(std::string_view file) const;

 private:
  static constexpr std::size_t most_kept = 10'000;
  After after_;
  Files files_;
  std::size_t total_ = 0;
  std::vector<Error> found_;
  std::set<std::string> said_;
  std::set<std::string, std::less<>> doubted_;  // paths
  std::vector<Location> doubted_places_;
};

}  // namespace regista::config
