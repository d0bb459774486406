// SPDX-License-Identifier: MIT
// The calls of a predictor, with checks of its answers.
#pragma once

#include <bit>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "plugin/instance.hpp"

namespace regista::plugin {

// Largest coordinate (m) and speed (m/s) of a track, far more than on a field. Larger numbers could cause overflows.
inline constexpr double farthest = 1e4;

// --- Checks whether the numbers of a plugin are a covariance matrix: positive semi-definite up to rounding. The
// numbers have the order of abi.h: a place has xx, xy, yy; a motion has also x vx, x vy, y vx, y vy, vx vx, vx vy, vy
// vy. All tolerances are relative to the diagonal, so units do not matter.

enum class Covariance { valid, not_finite, not_semi_definite };

// Checks any matrix (row-major; reads the lower triangle). Slow. Eliminates without exchange of rows (L D L^T): the
// matrix is positive semi-definite if and only if no pivot is negative and each zero pivot has only zeros below.
template <int n>
Covariance examine_covariance_by_elimination(const double (&matrix)[n * n]) {
  constexpr double rounding = 1e-9;
  double sum = 0.0;
  for (const double value : matrix) sum += 0.0 * value;  // 0, or NaN if a value is infinite or NaN
  if (sum != 0.0) return Covariance::not_finite;

  double a[n][n], diagonal[n];
  for (int i = 0; i < n; ++i) {
    diagonal[i] = matrix[i * n + i];
    if (diagonal[i] < 0.0) return Covariance::not_semi_definite;
    for (int j = 0; j <= i; ++j) a[i][j] = matrix[i * n + j];
  }
  for (int k = 0; k < n; ++k) {
    const double pivot = a[k][k];
    if (pivot < -rounding * diagonal[k]) return Covariance::not_semi_definite;
    if (pivot <= rounding * diagonal[k]) {
      for (int i = k + 1; i < n; ++i) {
        if (a[i][k] * a[i][k] > rounding * diagonal[i] * diagonal[k]) return Covariance::not_semi_definite;
      }
      continue;
    }
    const double inverse = 1.0 / pivot;
    for (int i = k + 1; i < n; ++i) {
      const double factor = a[i][k] * inverse;
      for (int j = k + 1; j <= i; ++j) a[i][j] -= factor * a[j][k];
    }
  }
  return Covariance::valid;
}

// Returns whether the covariance of a place is clearly positive definite. False for numbers that are not finite,
// overflow or underflow, and for a nearly singular matrix.
inline bool clearly_definite(const double (&place)[3]) {
  constexpr double margin = 1e-9;
  const double determinant = place[0] * place[2] - place[1] * place[1];
  return (place[0] > 0.0) & (determinant > margin * place[0] * place[2]);
}

// Like the function above, for the covariance of a motion, whose velocity part may be zero. The matrix of 2 x 2 blocks
// [P C; C^T Q] is positive definite if and only if P and the Schur complement Q - C^T P^-1 C are positive definite. The
// code multiplies the complement by det P, to avoid a division.
inline bool clearly_definite(const double (&p)[3], const double (&r)[7]) {
  constexpr double margin = 1e-9;
  const double determinant = p[0] * p[2] - p[1] * p[1];
  // U = adj(P) C and S = det(P) Q - C^T U
  const double u00 = p[2] * r[0] - p[1] * r[2], u01 = p[2] * r[1] - p[1] * r[3];
  const double u10 = p[0] * r[2] - p[1] * r[0], u11 = p[0] * r[3] - p[1] * r[1];
  const double s00 = determinant * r[4] - (r[0] * u00 + r[2] * u10);
  const double s01 = determinant * r[5] - (r[0] * u01 + r[2] * u11);
  const double s11 = determinant * r[6] - (r[1] * u01 + r[3] * u11);
  // The velocity of a body at rest is certain: C and Q are 0 or -0. A test of bits needs the fewest instructions.
  constexpr std::uint64_t sign = std::uint64_t{1} << 63;
  std::uint64_t any = 0;
  for (const double value : r) any |= std::bit_cast<std::uint64_t>(value);
  const bool still = (any & ~sign) == 0;
  return clearly_definite(p) &
         (still | ((s00 > margin * determinant * r[4]) & (s00 * s11 - s01 * s01 > margin * s00 * s11)));
}

inline Covariance examine_covariance(const double (&p)[3]) {
  if (clearly_definite(p)) return Covariance::valid;
  return examine_covariance_by_elimination<2>({p[0], p[1], p[1], p[2]});
}

inline Covariance examine_covariance(const double (&p)[3], const double (&r)[7]) {
  if (clearly_definite(p, r)) return Covariance::valid;
  return examine_covariance_by_elimination<4>({p[0], p[1], r[0], r[1],  //
                                               p[1], p[2], r[2], r[3],  //
                                               r[0], r[2], r[4], r[5],  //
                                               r[1], r[3], r[5], r[6]});
}

class Predictor : CallsOfKind<regista_predictor, REGISTA_KIND_PREDICTOR> {
 public:
  static constexpr std::uint32_t track_capacity = 64;

  // Throws Failure if the plugin is not a predictor or cannot model environment.subject.
  explicit Predictor(std::shared_ptr<Instance> instance);

  // Moves the estimate `dt` > 0 seconds ahead. motion: the robot's motion since the last call, in the robot frame at
  // the last call; null for a model of a teammate. last: frame of the last decision; null before the first decision.
  void predict(double dt, const regista_motion* motion, const regista_frame* last);
  void correct(std::span<const regista_measurement> measurements, const regista_visible_area& area);
  // Uses the tracks in a teammate's packet, `age` >= 0 seconds old. The plugin predicts these tracks to the present.
  void absorb(std::span<const regista_track> tracks, double age);
  // Returns the current estimate, valid until the next call. Checks: numbers are finite; |heading| <= pi; covariances
  // are positive semi-definite; weights are in (0, 1]; ages are >= 0; a model of self has one track, labelled with its
  // number; the ball's best hypothesis is first; teammates are in ascending order; labels of opponents are unique.
  std::span<const regista_track> tracks();

 private:
  std::vector<regista_track> tracks_;  // copy of the last answer, which stays valid when the buffer is used again
};

}  // namespace regista::plugin
