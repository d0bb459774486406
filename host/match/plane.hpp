// SPDX-License-Identifier: MIT
// Plane vectors for true positions, and tests of which points a camera sees. Metres and radians.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace regista::match {

struct Vector {
  double x = 0.0, y = 0.0;
  friend constexpr Vector operator+(Vector a, Vector b) { return {a.x + b.x, a.y + b.y}; }
  friend constexpr Vector operator-(Vector a, Vector b) { return {a.x - b.x, a.y - b.y}; }
  friend constexpr Vector operator*(double s, Vector a) { return {s * a.x, s * a.y}; }
  friend constexpr bool operator==(Vector, Vector) = default;
};

constexpr double dot(Vector a, Vector b) { return a.x * b.x + a.y * b.y; }
constexpr double squared_length(Vector a) { return dot(a, a); }
inline double length(Vector a) { return std::sqrt(squared_length(a)); }

constexpr Vector turned(Vector a, double cosine, double sine) {
  return {cosine * a.x - sine * a.y, sine * a.x + cosine * a.y};
}

// --- Visibility of many points at once. inside() tells which points lie in a camera's sector; hidden() tells whether a
// robot hides a point. Coordinates are in separate arrays, and the tests need no roots, angles or branches, so that a
// compiler can use vector registers. The tests reject most objects before random numbers are drawn. World frame.

constexpr std::size_t most_points = 64;
constexpr float nowhere = 1e4f;  // m; coordinate of a point that no camera can see

struct Points {  // A list of points. Elements from `count` on have the coordinate `nowhere`.
  std::array<float, most_points> x, y;
  std::size_t count = 0;
  Points() {
    x.fill(nowhere);
    y.fill(nowhere);
  }
  std::size_t padded() const { return (count + 7) / 8 * 8; }  // `count` rounded up to a multiple of 8
};

struct Sector {          // the part of the plane that a camera sees, without a range
  float x, y;            // apex
  float axis_x, axis_y;  // unit vector of the camera's axis
  float cosine;          // cosine of half the opening angle; half the angle is in [0, pi]
};

// Returns the square with the sign of the value. For a cosine c and a distance d, the test a >= c * d is then
// signed_square(a) >= signed_square(c) * (d * d), which needs no root.
constexpr float signed_square(float value) { return value * (value < 0.0f ? -value : value); }

struct Offsets {  // Offsets of points from the apex of a sector. squared: squared distance from the apex.
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

// Returns a set of points: bit i is 1 if point i is in the sector and at most sqrt(squared_range[i]) away.
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

// Returns whether a disc around one of `others` cuts the line from the apex to the offset (x, y). squared_radius:
// squared radius of each disc. `others` may contain the observed object and the observer, which hide nothing.
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
