// SPDX-License-Identifier: MIT
// How the game stands: the difference of goals lies in a closed range, if wanted only in the last minutes. The SPQR
// team planned contexts for the differences -2 to 2 beside those that its released code has.
#pragma once

namespace score_context {

struct Rule {
  int least = 1, most = 100;  // own goals minus the opponent's; empty when least > most, and then never holds
  double in_last = 0.0;       // s before the end of the second half; 0: at any time
};

struct Standing {
  int own = 0, opponent = 0;  // goals
  int half = 1;               // 1 or 2
  double time_left = 0.0;     // s left in this half; <= 0 in added time
};

constexpr bool holds(const Rule& rule, const Standing& now) {
  const int difference = now.own - now.opponent;
  const bool late = rule.in_last <= 0.0 || (now.half >= 2 && now.time_left <= rule.in_last);
  return late && difference >= rule.least && difference <= rule.most;
}

}  // namespace score_context
