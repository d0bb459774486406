// SPDX-License-Identifier: MIT
// Plane vectors and angles of the truth. Metres and radians; the frame is said where a value is declared.
#pragma once

#include <cmath>
#include <numbers>

namespace regista::match {

struct Vector {
  double x = 0.0, y = 0.0;
  friend constexpr Vector operator+(Vector a, Vector b) { return {a.x + b.x, a.y + b.y}; }
  friend constexpr Vector operator-(Vector a, Vector b) { return {a.x - b.x, a.y - b.y}; }
  friend constexpr Vector operator*(double s, Vector a) { return {s * a.x, s * a.y}; }
  friend constexpr bool operator==(Vector, Vector) = default;
};

constexpr double dot(Vector a, Vector b) { return a.x * b.x + a.y * b.y; }
constexpr double cross(Vector a, Vector b) { return a.x * b.y - a.y * b.x; }
constexpr double squared_length(Vector a) { return dot(a, a); }
inline double length(Vector a) { return std::sqrt(squared_length(a)); }

// `a` turned by the angle with this cosine and sine.
constexpr Vector turned(Vector a, double cosine, double sine) {
  return {cosine * a.x - sine * a.y, sine * a.x + cosine * a.y};
}

// The same angle in (-pi, pi].
inline double wrapped(double angle) {
  const double rest = std::remainder(angle, 2.0 * std::numbers::pi);
  return rest <= -std::numbers::pi ? std::numbers::pi : rest;
}

}  // namespace regista::match
