// SPDX-License-Identifier: MIT
// The chance of many sightings at once: for each object the first block of its own stream (see chance.hpp) as a uniform
// number and a pair of normal ones, by Box and Muller, "A Note on the Generation of Random Normal Deviates", 1958.
//
// A camera frame is a handful of such draws and most of what sensing costs, so logarithm, sine and cosine are short
// polynomials in single precision that a compiler puts into vector registers (absolute error of a normal number below
// 3e-6). Built from +, -, * and / alone they give the same bits on every processor, which a libm does not.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "match/chance.hpp"
#include "match/sector.hpp"

namespace regista::match {

constexpr std::size_t most_draws = 2 * most_points;

// The stream that one sighting draws from.
struct Draw {
  Purpose purpose = Purpose::kick;
  int object = 0;
};

// Element i belongs to draw i of the call.
struct Draws {
  std::array<float, most_draws> uniform;        // [0, 1]
  std::array<float, most_draws> first, second;  // standard normal, independent; |value| < 5.9
};

// wanted: at most most_draws. Elements of `out` beyond them may be overwritten too.
void draw(std::uint64_t seed, Side side, int observer, std::uint32_t tick, std::span<const Draw> wanted, Draws& out);

// Two standard normal numbers from two words of 32 random bits.
struct NormalPair {
  float first, second;
};
NormalPair box_muller(std::uint32_t radius_bits, std::uint32_t angle_bits);

}  // namespace regista::match
