// SPDX-License-Identifier: MIT
// Every source of chance of a match as its own counter-based stream: Philox4x32-10 of Salmon et al., "Parallel Random
// Numbers: As Easy as 1, 2, 3", SC 2011. A stream is named by (seed; purpose, side, observer, object, tick) and shares
// no state with any other, so that drawing more or fewer numbers here never changes the luck there. `side` is the
// colour slot: when two teams swap places, the luck stays where it was.
//
// Two draws must not stand in one argument list: the order of evaluation differs between compilers.
#pragma once

#include <cstdint>

#include "match/normal_law.hpp"
#include "match/random_words.hpp"
#include "match/side.hpp"

namespace regista::match {

enum class Purpose : std::uint32_t {
  kick,
  fall,
  odometry,
  odometry_scale,
  placing,
  whistle,
  ball,
  false_ball,
  ball_blindness,
  robot,
  landmark,
  radio_delay,
  radio_loss,
  contact,
  incident_time,
  incident_robot,
  incident_place,
  burst,
  ghost_ball,
  misplacing,
  stumble,
  get_up,
};

// A stream: 2^32 blocks of four words. Cheap to make (nothing is drawn until it is asked for).
class Chance {
 public:
  // observer and object: below 2^12 each; tick: physics steps since the start of the match.
  Chance(std::uint64_t seed, Purpose purpose, Side side, int observer, int object, std::uint32_t tick)
      : words_(seed, {0, tick, static_cast<std::uint32_t>(purpose) << 1 | static_cast<std::uint32_t>(side),
                      static_cast<std::uint32_t>(observer) << 12 | static_cast<std::uint32_t>(object)}) {}

  std::uint32_t bits() { return words_.next(); }

  // [0, 1), in steps of 2^-32.
  double uniform() { return bits() * 0x1p-32; }

  bool bernoulli(double probability) { return uniform() < probability; }

  // Symmetric triangular law on (-1, 1): variance 1/6.
  double triangular() {
    const double first = uniform();
    const double second = uniform();
    return first - second;
  }

  double normal() {
    return normal_.draw([this] { return uniform(); });
  }

 private:
  RandomWords words_;
  NormalLaw normal_;
};

}  // namespace regista::match
