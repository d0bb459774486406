// SPDX-License-Identifier: MIT
// What `regista plugin check` says of a file: one verdict for each check.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace regista::check {

enum class Status : std::uint8_t {
  pass,
  warn,   // may be meant, and may go wrong elsewhere
  fail,   // breaks a promise of <regista/abi.h>
  crash,  // the process of the check died, or had to be ended
  skip    // there was nothing to check, or an earlier check stands in the way
};

// "pass", "warn", "fail", "crash", "skip"
const char* word(Status status);

struct Verdict {
  std::string plugin;   // id; empty: of the file
  std::string check;    // "imports", "assigner.promises"; the names stay from version to version
  std::string promise;  // a sentence: what is checked
  Status status = Status::pass;
  std::vector<std::string> lines;  // what was found, one line each; also of one that passed
  double seconds = 0.0;            // of wall time
};

struct Report {
  std::string file;
  std::vector<Verdict> verdicts;

  // No check failed or crashed.
  bool passed() const;
};

}  // namespace regista::check
