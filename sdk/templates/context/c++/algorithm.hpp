// SPDX-License-Identifier: MIT
// Whether something is near, with hysteresis: at the edge the answer does not change to and fro. Knows nothing of
// Regista, so that it can be tested and used alone.
#pragma once

class Nearness {
 public:
  // distance, m: nearer than `near` it is near, and it stays so up to `near` + `margin`.
  bool update(double distance, double near, double margin) {
    near_ = distance < (near_ ? near + margin : near);
    return near_;
  }
  void forget() { near_ = false; }

 private:
  bool near_ = false;
};
