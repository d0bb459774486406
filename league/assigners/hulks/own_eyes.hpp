// SPDX-License-Identifier: MIT
// When this robot last saw the ball with its own eyes. A frame has no such thing: the ball of a world is anyone's.
#pragma once

#include <optional>

namespace hulks {

class OwnEyes {
 public:
  void forget() { *this = {}; }
  // Once at each decision. sees: whether there is a ball in the image, if the host tells. mine, common: when the ball
  // was last seen by anyone, as this robot knows and as all can know; nothing: never. Times in s.
  void look(double now, std::optional<bool> sees, std::optional<double> mine, std::optional<double> common) {
    if (sees) {
      if (*sees) seen_ = now;
    } else if (mine && (!common || *mine > *common + rounding_of_ages)) {
      seen_ = *mine;  // what is newer than all that was told, this robot has seen itself
    }
  }
  bool saw_within(double seconds, double now) const { return now - seen_ <= seconds; }

 private:
  static constexpr double rounding_of_ages = 0.3;  // s, in packets
  double seen_ = -1e9;
};

}  // namespace hulks
