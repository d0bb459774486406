// SPDX-License-Identifier: MIT
// Who has the ball: we, they, nobody, or both are at it. A side is at the ball while one of its robots is within 0.5 m
// of it, as the SPQR team planned for its contexts. Two things are ours, so that it does not flicker: a side that is at
// the ball stays so up to a margin beyond, and a change counts only when it has lasted for a moment.
#pragma once

#include <limits>
#include <optional>

namespace possession {

enum class State { us, them, none, fight };

struct Rule {
  double reach = 0.5;   // m, >= 0
  double margin = 0.2;  // m, >= 0
  double settle = 0.3;  // s, >= 0
};

inline constexpr double nobody = std::numeric_limits<double>::infinity();

// Distances from the ball, m; `nobody` where a side has no robot.
struct Nearest {
  double us = nobody, them = nobody;
};

class Memory {
 public:
  // time: s, never runs back. nearest: nothing when the ball is unknown, and then nobody knows who has it, not even
  // that nobody has. Call once per decision.
  std::optional<State> update(const Rule& rule, double time, const std::optional<Nearest>& nearest) {
    if (!nearest) {
      forget();
      return std::nullopt;
    }
    us_ = nearest->us <= rule.reach + (us_ ? rule.margin : 0.0);
    them_ = nearest->them <= rule.reach + (them_ ? rule.margin : 0.0);
    const State seen = us_ ? (them_ ? State::fight : State::us) : (them_ ? State::them : State::none);
    if (seen != seen_) since_ = time;
    seen_ = seen;
    // The first sight after none counts at once.
    if (!settled_ || time - since_ >= rule.settle - rounding) settled_ = seen;
    return settled_;
  }
  void forget() { *this = Memory(); }

 private:
  static constexpr double rounding = 1e-9;  // s
  bool us_ = false, them_ = false;
  std::optional<State> seen_, settled_;
  double since_ = 0.0;  // time since which `seen_` is what is seen
};

}  // namespace possession
