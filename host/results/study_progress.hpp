// SPDX-License-Identifier: MIT
// How far a study of many matches has come, on standard error: a block that is rewritten in place where that is a
// terminal, else a plain line for each match.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>

#include "campaign/job.hpp"
#include "report/study_report.hpp"
#include "study/study.hpp"

namespace regista::results {

class StudyProgress {
 public:
  StudyProgress(const report::StudyReport& report, bool wanted);
  ~StudyProgress();
  StudyProgress(const StudyProgress&) = delete;
  StudyProgress& operator=(const StudyProgress&) = delete;

  // A line that stands until the first match has ended.
  void begin();
  // The next match, which the study knows already; null: one that is not wanted. fresh: played now.
  void match(const study::Round& round, std::uint64_t index, const campaign::Decided* decided, bool fresh);
  // Something that is always said.
  void print(std::string_view line);
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
  void show(const std::string& block);
  void draw();
  std::string block() const;
  std::string rate_text() const;

  const report::StudyReport& report_;
  std::uint64_t taken_ = 0, stored_ = 0, played_ = 0;  // taken: also those that are not wanted
  bool wanted_, rewrite_;
  int lines_ = 0;  // of the block that is shown
  Clock::time_point began_ = Clock::now(), drawn_{};
};

}  // namespace regista::results
