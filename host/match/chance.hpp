// SPDX-License-Identifier: MIT
// The random numbers of a match. Each random source has its own counter-based stream: Philox4x32-10 of J. K. Salmon et
// al., "Parallel Random Numbers: As Easy as 1, 2, 3", SC 2011. The name of a stream is (seed; purpose, side, observer,
// object, tick). Streams share no state, so additional draws from one stream change no other stream. `side` is the
// colour slot. When two teams swap slots, the random numbers stay with the slot. Never put two draws into one argument
// list, because compilers evaluate arguments in different orders.
#pragma once

#include <Random123/philox.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

#include "match/plane.hpp"
#include "match/side.hpp"

namespace regista::match {

// A stream of random words. Two streams are independent if their keys differ, or if words 1 to 3 of their counters
// differ. Word 0 of the counter numbers the blocks of four random words, so a stream has 2^32 blocks.
class RandomWords {
 public:
  RandomWords(std::uint64_t key, const std::array<std::uint32_t, 4>& counter)
      : key_{{static_cast<std::uint32_t>(key), static_cast<std::uint32_t>(key >> 32)}},
        counter_{{counter[0], counter[1], counter[2], counter[3]}} {}

  std::uint32_t next() {
    if (used_ == 4) {
      words_ = Generator{}(counter_, key_);
      ++counter_[0];
      used_ = 0;
    }
    return words_[used_++];
  }

 private:
  using Generator = r123::Philox4x32;  // ten rounds
  Generator::key_type key_;
  Generator::ctr_type counter_;
  Generator::ctr_type words_;
  unsigned used_ = 4;
};

// Turns uniform numbers into standard normal numbers: G. E. P. Box and M. E. Muller, "A Note on the Generation of
// Random Normal Deviates", 1958, in the polar form (Marsaglia and Bray, 1964), which needs no sine.
// std::normal_distribution is not used, because its results differ between libraries. The method computes two numbers
// together: draw() returns the first number and keeps the second number for the next call.
class NormalLaw {
 public:
  // uniform() must return the next number of a uniform law on [0, 1).
  template <class Uniform>
  double draw(Uniform uniform) {
    if (spare_) {
      spare_ = false;
      return second_;
    }
    double x, y, squared;
    do {
      x = 2.0 * uniform() - 1.0;
      y = 2.0 * uniform() - 1.0;
      squared = x * x + y * y;
    } while (squared >= 1.0 || squared == 0.0);
    const double scale = std::sqrt(-2.0 * std::log(squared) / squared);
    second_ = scale * y;
    spare_ = true;
    return scale * x;
  }

 private:
  bool spare_ = false;
  double second_ = 0.0;
};

enum class Purpose : std::uint32_t {  // what the random numbers of a stream decide
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
  get_up
};

// Construction is cheap: the first random number is computed at the first draw.
class Chance {
 public:
  // observer, object: each below 2^12. tick: number of physics steps since the start of the match.
  Chance(std::uint64_t seed, Purpose purpose, Side side, int observer, int object, std::uint32_t tick)
      : words_(seed, {0, tick, static_cast<std::uint32_t>(purpose) << 1 | static_cast<std::uint32_t>(side),
                      static_cast<std::uint32_t>(observer) << 12 | static_cast<std::uint32_t>(object)}) {}

  std::uint32_t bits() { return words_.next(); }

  // A number of the uniform law on [0, 1): a multiple of 2^-32.
  double uniform() { return bits() * 0x1p-32; }

  bool bernoulli(double probability) { return uniform() < probability; }

  // A number of the symmetric triangular law on (-1, 1), whose variance is 1/6.
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

// --- Random numbers of many sightings at once. The first block of each object's stream gives a uniform number and a
// pair of normal numbers (Box and Muller). Sensing spends most of its time here. Logarithm, sine and cosine are
// therefore short polynomials in single precision for vector registers (absolute error of a normal number below 3e-6).
// The polynomials use only +, -, * and /, so every processor computes the same bits, unlike a libm.

constexpr std::size_t most_draws = 2 * most_points;

struct Draw {  // Names a random stream, together with the arguments of draw().
  Purpose purpose = Purpose::kick;
  int object = 0;
};

// The result of draw(). Element i of each array belongs to element i of draw()'s `wanted`.
struct Draws {
  std::array<float, most_draws> uniform;        // [0, 1]
  std::array<float, most_draws> first, second;  // standard normal, independent; |value| < 5.9
};

// Fills `out`. `wanted` may have at most most_draws elements. Elements of `out` from wanted.size() on have any value.
void draw(std::uint64_t seed, Side side, int observer, std::uint32_t tick, std::span<const Draw> wanted, Draws& out);

struct NormalPair {  // Two independent standard normal numbers, made by box_muller() from two words of 32 random bits.
  float first, second;
};
NormalPair box_muller(std::uint32_t radius_bits, std::uint32_t angle_bits);

}  // namespace regista::match
