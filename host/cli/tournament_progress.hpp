// SPDX-License-Identifier: MIT
// How far a tournament has come, on standard error: a line that is rewritten in place where that is a terminal, else a
// plain line for each match.
#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>

#include "study/tournament.hpp"

namespace regista::cli {

class TournamentProgress {
 public:
  TournamentProgress(std::array<std::string, 2> labels, std::uint64_t matches, bool wanted);
  ~TournamentProgress();
  TournamentProgress(const TournamentProgress&) = delete;
  TournamentProgress& operator=(const TournamentProgress&) = delete;

  // The next match of the schedule; fresh: played now. standing: with it.
  void match(std::uint64_t index, const study::Fixture& fixture, const campaign::Decided& decided, bool fresh,
             const study::Standing& standing);
  // Something that is always said.
  void tell(std::string_view line);
  void clear();

 private:
  using Clock = std::chrono::steady_clock;
  void draw(const study::Standing& standing);

  std::array<std::string, 2> labels_;
  std::uint64_t matches_, stored_ = 0, played_ = 0;
  bool wanted_, rewrite_, shown_ = false;
  Clock::time_point began_ = Clock::now(), drawn_{};
};

}  // namespace regista::cli
