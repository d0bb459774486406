// SPDX-License-Identifier: MIT
// Tenures: how long a robot of one team holds a role before it takes another one, in the phase Playing.
//
// A tenure begins when the robot decides on the role, or at its first decision of a span in which it plays: in the
// phase Playing and not penalised. It is finished when the robot plays and decides on another role, or on none.
// Tenures that something else ends are not finished and do not count: the end of Playing or of the match, a penalty, a
// crash. A set play is no end, nor is a fall.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace regista::match {

// Of all finished tenures of all robots; nothing without one. Quantiles as in statistics/quantile.hpp: type 7 of
// R. J. Hyndman and Y. Fan, "Sample Quantiles in Statistical Packages", The American Statistician 50, 1996.
struct TenureMetrics {
  std::optional<double> median_seconds, tenth_seconds;  // tenth: a tenth of them are shorter
};

class TenureMeasures {
 public:
  // longest: s, of a span of play. There is room for it from the beginning; longer tenures make their own.
  TenureMeasures(int team_size, double longest);

  // Robot `number` has decided at this time, s of match time. role: row or -1. plays: see above.
  void decided(int number, int role, double time, bool plays);
  void crashed(int number);

  TenureMetrics result() const;

 private:
  struct Held {
    int role = -1;
    double since = 0.0;  // s
  };
  double quantile(double probability) const;
  double shortest_but(std::size_t rank) const;  // s, of the finished ones

  std::vector<Held> held_;               // by robot
  std::vector<std::uint32_t> finished_;  // by length in physics steps: how many
  std::size_t count_ = 0;                // of all of them
};

}  // namespace regista::match
