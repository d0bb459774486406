// SPDX-License-Identifier: MIT
#include "match/chance.hpp"

#include <algorithm>
#include <bit>
#include <cassert>
#include <numbers>

namespace regista::match {
namespace {

// Returns ln u for u in (0, 1]. With u = m 2^e and m around 1, a series gives ln m = 2 artanh((m - 1) / (m + 1)).
inline float logarithm(float u) {
  constexpr std::int32_t below_one = 0x3f3504f3;  // the bits of sqrt(1/2)
  const std::int32_t bits = std::bit_cast<std::int32_t>(u);
  const std::int32_t exponent = (bits - below_one) >> 23;
  const float m = std::bit_cast<float>(bits - exponent * (1 << 23));
  const float s = (m - 1.0f) / (m + 1.0f), z = s * s;
  const float series = 1.0f + z * (1.0f / 3.0f + z * (1.0f / 5.0f + z * (1.0f / 7.0f + z * (1.0f / 9.0f))));
  return static_cast<float>(exponent) * std::numbers::ln2_v<float> + 2.0f * s * series;
}

inline NormalPair normal_pair(std::uint32_t radius_bits, std::uint32_t angle_bits) {
  // u is the middle of one of 2^24 equal intervals of (0, 1), so u is never 0.
  const float u = (static_cast<float>(static_cast<std::int32_t>(radius_bits >> 8)) + 0.5f) * 0x1p-24f;
  const float radius = std::sqrt(-2.0f * logarithm(u));
  // Two bits choose a quarter of the circle; the other bits choose an angle in [-pi/4, pi/4) within the quarter.
  constexpr float to_angle = std::numbers::pi_v<float> / 2.0f * 0x1p-32f;
  const float a = static_cast<float>(static_cast<std::int32_t>(angle_bits << 2)) * to_angle, b = a * a;
  const float sine = a * (1.0f + b * (-1.0f / 6.0f + b * (1.0f / 120.0f + b * (-1.0f / 5040.0f))));
  const float cosine = 1.0f + b * (-1.0f / 2.0f + b * (1.0f / 24.0f + b * (-1.0f / 720.0f + b * (1.0f / 40320.0f))));
  // Bit masks replace branches, because vector registers have no branches. Bit 0 of the quarter's number (0 to 3) swaps
  // sine and cosine and negates the second result. Bit 1 negates the two results.
  const std::uint32_t sine_bits = std::bit_cast<std::uint32_t>(sine),
                      cosine_bits = std::bit_cast<std::uint32_t>(cosine);
  const std::uint32_t swap = 0u - (angle_bits >> 30 & 1u), differ = (sine_bits ^ cosine_bits) & swap;
  const std::uint32_t negate = angle_bits & 0x80000000u, negate_second = negate ^ (swap & 0x80000000u);
  return {radius * std::bit_cast<float>(cosine_bits ^ differ ^ negate),
          radius * std::bit_cast<float>(sine_bits ^ differ ^ negate_second)};
}

}  // namespace

NormalPair box_muller(std::uint32_t radius_bits, std::uint32_t angle_bits) {
  return normal_pair(radius_bits, angle_bits);
}

void draw(std::uint64_t seed, Side side, int observer, std::uint32_t tick, std::span<const Draw> wanted, Draws& out) {
  assert(wanted.size() <= most_draws);
  // The number of draws is rounded up to a multiple of a vector register, so that no slow loop handles a remainder.
  const std::size_t padded = (wanted.size() + 3) / 4 * 4;
  std::array<Draw, most_draws> streams;
  std::copy(wanted.begin(), wanted.end(), streams.begin());
  std::fill(streams.begin() + static_cast<std::ptrdiff_t>(wanted.size()),
            streams.begin() + static_cast<std::ptrdiff_t>(padded), Draw{});
  std::array<std::uint32_t, most_draws> radius_bits, angle_bits;
  for (std::size_t i = 0; i < padded; ++i) {
    Chance chance(seed, streams[i].purpose, side, observer, streams[i].object, tick);
    out.uniform[i] = static_cast<float>(chance.bits()) * 0x1p-32f;
    radius_bits[i] = chance.bits();
    angle_bits[i] = chance.bits();
  }
  for (std::size_t i = 0; i < padded; ++i) {
    const NormalPair pair = normal_pair(radius_bits[i], angle_bits[i]);
    out.first[i] = pair.first;
    out.second[i] = pair.second;
  }
}

}  // namespace regista::match
