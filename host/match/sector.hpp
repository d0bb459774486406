// SPDX-License-Identifier: MIT
// The geometry of seeing, for many points at once: which lie in a camera's sector, and which are hidden behind robots.
// Points are kept as separate coordinates and tested without roots, angles or branches, so that a compiler puts them
// into vector registers; most of what a robot might see is rejected here, before any chance is drawn. World frame.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace regista::match {

constexpr std::size_t most_points = 64;
constexpr float nowhere = 1e4f;  // coordinate of what is not there, m

// Unused places are nowhere.
struct Points {
  std::array<float, most_points> x, y;
  std::size_t count = 0;
  Points() {
    x.fill(nowhere);
    y.fill(nowhere);
  }
  std::size_t padded() const { return (count + 7) / 8 * 8; }
};

struct Sector {
  float x, y;            // apex
  float axis_x, axis_y;  // unit vector of the camera's axis
  float cosine;          // of half the opening angle, in [0, pi]
};

// Monotone like the square root's argument with its sign kept: compares a >= c * d without knowing d, only d * d.
constexpr float signed_square(float value) { return value * (value < 0.0f ? -value : value); }

// Offsets of points from the apex.
struct Offsets {
  std::array<float, most_points> x, y, squared;
  std::size_t padded = 0;
};

inline void offsets(const Points& points, const Sector& sector, Offsets& out) {
  out.padded = points.padded();
  for (std::size_t i = 0; i < out.padded; ++i) {
    out.x[i] = points.x[i] - sector.x;
    out.y[i] = points.y[i] - sector.y;
    out.squared[i] = out.x[i] * out.x[i] + out.y[i] * out.y[i];
  }
}

// Bit i: the point is in the sector and no farther than the root of squared_range[i].
inline std::uint64_t inside(const Offsets& points, const Sector& sector,
                            const std::array<float, most_points>& squared_range) {
  const float edge = signed_square(sector.cosine);
  std::array<std::uint32_t, most_points> is_inside;
  for (std::size_t i = 0; i < points.padded; ++i) {
    const float ahead = points.x[i] * sector.axis_x + points.y[i] * sector.axis_y;
    const bool wide = signed_square(ahead) >= edge * points.squared[i];
    const bool near = points.squared[i] <= squared_range[i];
    is_inside[i] = static_cast<std::uint32_t>(wide) & static_cast<std::uint32_t>(near);
  }
  std::uint64_t set = 0;
  for (std::size_t i = 0; i < points.padded; ++i) set |= std::uint64_t{is_inside[i]} << i;
  return set;
}

// A disc of this radius around one of `others` cuts the line of sight from the apex to the offset (x, y), nearer than
// it. The object itself may be among the others, and so may the apex.
inline bool hidden(float x, float y, const Offsets& others, float squared_radius) {
  const float squared = x * x + y * y, width = squared_radius * squared;
  std::uint32_t any = 0;
  for (std::size_t i = 0; i < others.padded; ++i) {
    const float along = x * others.x[i] + y * others.y[i], beside = x * others.y[i] - y * others.x[i];
    any |= static_cast<std::uint32_t>(others.squared[i] < squared) & static_cast<std::uint32_t>(along > 0.0f) &
           static_cast<std::uint32_t>(beside * beside < width);
  }
  return any != 0;
}

}  // namespace regista::match
