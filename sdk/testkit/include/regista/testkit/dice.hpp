// SPDX-License-Identifier: MIT
// Chance for tests: the same sequence on every machine and with every standard library. SplitMix64 (Steele, Lea, Flood:
// Fast splittable pseudorandom number generators, OOPSLA 2014).
#pragma once

#include <cstdint>

namespace regista::testkit {

class Dice {
 public:
  explicit Dice(std::uint64_t seed) : state_(seed) {}
  // Other chances for the same thing, by a seed that an author may choose; 0 changes nothing.
  static Dice with(std::uint64_t seed, std::uint64_t what) { return Dice(what + 0x2545f4914f6cdd1du * seed); }
  std::uint64_t bits() {
    state_ += 0x9e3779b97f4a7c15u;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
  // Uniform in [low, high).
  double real(double low, double high) { return low + (high - low) * static_cast<double>(bits() >> 11) * 0x1p-53; }
  // Uniform in [low, high], both included.
  int integer(int low, int high) {
    return low + static_cast<int>(bits() % static_cast<std::uint64_t>(static_cast<std::int64_t>(high) - low + 1));
  }
  bool chance(double probability) { return real(0.0, 1.0) < probability; }

 private:
  std::uint64_t state_;
};

}  // namespace regista::testkit
