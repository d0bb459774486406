// SPDX-License-Identifier: MIT
// How far a study of many matches has come, on standard error: a block that is rewritten in place where that is a
// terminal, else a plain line for each match.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

#include "campaign/job.hpp"

namespace regista::cli {

// What a study has to say. Texts are lines, each ended, but for `match`.
struct StudyWords {
  std::uint64_t matches = 0;              // of the schedule, at most
  std::function<std::uint64_t()> taken;   // so far
  std::function<std::string()> standing;  // that is rewritten
  std::function<std::string()> whole;     // when it does not go on; empty: nothing to tell
  // "small 1:0 other": what is told of a match behind its number.
  std::function<std::string(std::uint64_t index, const campaign::Decided& decided)> match;
};

class StudyProgress {
 public:
  StudyProgress(StudyWords words, bool wanted);
  ~StudyProgress();
  StudyProgress(const StudyProgress&) = delete;
  StudyProgress& operator=(const StudyProgress&) = delete;

  // The next match of the schedule, which the study knows already; null: one that is not wanted. fresh: played now.
  void match(std::uint64_t index, const campaign::Decided* decided, bool fresh);
  // Something that is always said.
  void tell(std::string_view line);
  // Something that is said where progress is.
  void note(const std::string& line);
  // Takes the block away.
  void clear();
  // How long it took, in a line.
  void finish();
  // How things stand when it does not go on.
  void stopped();

 private:
  using Clock = std::chrono::steady_clock;
  void draw();
  std::string block() const;
  std::string rate_text() const;

  StudyWords words_;
  std::uint64_t stored_ = 0, played_ = 0;
  bool wanted_, rewrite_;
  int lines_ = 0;  // of the block that is shown
  Clock::time_point began_ = Clock::now(), drawn_{};
};

}  // namespace regista::cli
