// SPDX-License-Identifier: MIT
// How far a log-likelihood ratio jumps beyond a bound on average when it passes it. Wald's bounds suppose that it stops
// exactly on them; a test that stops earlier by this much keeps its error rates with fewer games. Estimated from the
// new extremes on the way: D. Siegmund, "Sequential Analysis", 1985, corollary 8.33: sum d^2 / (2 sum d), d the step
// from each extreme so far to the next.
#pragma once

namespace regista::statistics {

class Overshoot {
 public:
  // To be called with every value of the ratio, in order; it starts at 0.
  void update(double ratio) {
    if (ratio < lowest_) {
      below_.add(lowest_ - ratio);
      lowest_ = ratio;
    }
    if (ratio > highest_) {
      above_.add(ratio - highest_);
      highest_ = ratio;
    }
  }

  double below() const { return below_.mean_excess(); }  // at the lower bound; 0 while there is no extreme
  double above() const { return above_.mean_excess(); }  // at the upper bound

 private:
  struct Steps {
    double sum = 0.0, of_squares = 0.0;

    void add(double step) {
      sum += step;
      of_squares += step * step;
    }
    double mean_excess() const { return sum > 0.0 ? of_squares / (2.0 * sum) : 0.0; }
  };
  double lowest_ = 0.0, highest_ = 0.0;
  Steps below_, above_;
};

}  // namespace regista::statistics
