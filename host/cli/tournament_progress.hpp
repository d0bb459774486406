// SPDX-License-Identifier: MIT
// How far a tournament has come, on standard error: a block that is rewritten in place where that is a terminal, else a
// plain line for each match.
#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>

#include "report/tournament.hpp"

namespace regista::cli {

class TournamentProgress {
 public:
  TournamentProgress(const report::TournamentView& view, bool wanted);
  ~TournamentProgress();
  TournamentProgress(const TournamentProgress&) = delete;
  TournamentProgress& operator=(const TournamentProgress&) = delete;

  // The next match of the schedule, which the view knows already; null: one that is not wanted. fresh: played now.
  void match(std::uint64_t index, const campaign::Decided* decided, bool fresh);
  // Something that is always said.
  void tell(std::string_view line);
  // Takes the block away.
  void clear();
  // A note on equal teams before the first match.
  void begin();
  // How long it took, in a line.
  void finish();
  // How things stand when it does not go on.
  void stopped();

 private:
  using Clock = std::chrono::steady_clock;
  void draw();
  std::string block() const;
  std::string rate_text() const;

  const report::TournamentView& view_;
  std::uint64_t stored_ = 0, played_ = 0;
  bool wanted_, rewrite_;
  int lines_ = 0;  // of the block that is shown
  Clock::time_point began_ = Clock::now(), drawn_{};
};

}  // namespace regista::cli
