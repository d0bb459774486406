// SPDX-License-Identifier: MIT
// Whether what a plugin tells can be a covariance: positive semi-definite, up to rounding. Packed as abi.h has it: of a
// place xx, xy, yy; the rest of a motion x vx, x vy, y vx, y vy, vx vx, vx vy, vy vy. All tolerances are relative to
// the diagonal, so that units do not matter.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

namespace regista::plugin {

enum class Covariance { valid, not_finite, not_semi_definite };

// The slow answer, for every matrix (row-major; the lower triangle is read). By elimination without pivoting (an
// L D L^T factorisation): the matrix is positive semi-definite if and only if no pivot is negative and the column below
// a zero pivot is zero.
template <int n>
Covariance examine_covariance_by_elimination(const double (&matrix)[n * n]) {
  constexpr double rounding = 1e-9;
  double sum = 0.0;
  for (const double value : matrix) sum += 0.0 * value;  // 0 unless a value is infinite or no number
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

// Whether a place is clearly certain: false for whatever is not finite, over- or underflows, or is nearly singular.
inline bool clearly_definite(const double (&place)[3]) {
  constexpr double margin = 1e-9;
  const double determinant = place[0] * place[2] - place[1] * place[1];
  return (place[0] > 0.0) & (determinant > margin * place[0] * place[2]);
}

// Whether a motion is clearly positive definite, or clearly so for its place and zero elsewhere. With the 2 x 2 blocks
// [P C; C^T Q] that holds if and only if P and its Schur complement Q - C^T P^-1 C are positive definite; multiplied by
// det P there is no division. False as above.
inline bool clearly_definite(const double (&p)[3], const double (&r)[7]) {
  constexpr double margin = 1e-9;
  const double determinant = p[0] * p[2] - p[1] * p[1];
  // U = adj(P) C and S = det(P) Q - C^T U
  const double u00 = p[2] * r[0] - p[1] * r[2], u01 = p[2] * r[1] - p[1] * r[3];
  const double u10 = p[0] * r[2] - p[1] * r[0], u11 = p[0] * r[3] - p[1] * r[1];
  const double s00 = determinant * r[4] - (r[0] * u00 + r[2] * u10);
  const double s01 = determinant * r[5] - (r[0] * u01 + r[2] * u11);
  const double s11 = determinant * r[6] - (r[1] * u01 + r[3] * u11);
  // What does not move has no uncertain velocity: the other blocks are zero, of either sign. Bits are compared with
  // fewer instructions than numbers.
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

}  // namespace regista::plugin
