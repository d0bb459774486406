// SPDX-License-Identifier: MIT
// Whether a 4 x 4 matrix can be a covariance: symmetric and positive semi-definite, up to rounding. Row-major. All
// tolerances are relative to the diagonal, so that units do not matter.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

namespace regista::plugin {

enum class Covariance { valid, not_finite, not_symmetric, not_semi_definite };

// The slow answer, for every matrix. By elimination without pivoting (an L D L^T factorisation): the matrix is positive
// semi-definite if and only if no pivot is negative and the column below a zero pivot is zero.
inline Covariance examine_covariance_by_elimination(const double (&matrix)[16]) {
  constexpr int n = 4;
  constexpr double rounding = 1e-9;
  double sum = 0.0;
  for (const double value : matrix) sum += 0.0 * value;  // 0 unless a value is infinite or no number
  if (sum != 0.0) return Covariance::not_finite;

  double a[n][n], diagonal[n];
  for (int i = 0; i < n; ++i) {
    diagonal[i] = matrix[i * n + i];
    if (diagonal[i] < 0.0) return Covariance::not_semi_definite;
    for (int j = 0; j < i; ++j) {
      const double difference = matrix[i * n + j] - matrix[j * n + i];
      if (difference * difference > rounding * rounding * diagonal[i] * diagonal[j]) return Covariance::not_symmetric;
      a[i][j] = matrix[i * n + j];
    }
    a[i][i] = diagonal[i];
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

// Whether the matrix is symmetric to the last bit and clearly positive definite, or clearly so for the position and
// zero elsewhere. With the 2 x 2 blocks [P C; C^T Q] that holds if and only if P and its Schur complement Q - C^T P^-1
// C are positive definite; multiplied by det P there is no division. False for whatever is not finite, over- or
// underflows, or is nearly singular.
inline bool clearly_definite(const double (&m)[16]) {
  constexpr double margin = 1e-9;
  // Bits are compared with fewer instructions than numbers. What is no number is equal to itself by them, but no sum
  // that it is part of is larger than anything.
  const auto bits = [&m](int i) { return std::bit_cast<std::uint64_t>(m[i]); };
  const bool symmetric = ((bits(1) ^ bits(4)) | (bits(2) ^ bits(8)) | (bits(3) ^ bits(12)) | (bits(6) ^ bits(9)) |
                          (bits(7) ^ bits(13)) | (bits(11) ^ bits(14))) == 0;
  const double determinant = m[0] * m[5] - m[1] * m[1];
  // U = adj(P) C and S = det(P) Q - C^T U
  const double u00 = m[5] * m[2] - m[1] * m[6], u01 = m[5] * m[3] - m[1] * m[7];
  const double u10 = m[0] * m[6] - m[1] * m[2], u11 = m[0] * m[7] - m[1] * m[3];
  const double s00 = determinant * m[10] - (m[2] * u00 + m[6] * u10);
  const double s01 = determinant * m[11] - (m[2] * u01 + m[6] * u11);
  const double s11 = determinant * m[15] - (m[3] * u01 + m[7] * u11);
  const bool position_definite = (m[0] > 0.0) & (determinant > margin * m[0] * m[5]);
  // What does not move has no uncertain velocity: the other blocks are zero, of either sign.
  constexpr std::uint64_t sign = std::uint64_t{1} << 63;
  const bool still = ((bits(2) | bits(3) | bits(6) | bits(7) | bits(10) | bits(11) | bits(15)) & ~sign) == 0;
  return symmetric & position_definite &
         (still | ((s00 > margin * determinant * m[10]) & (s00 * s11 - s01 * s01 > margin * s00 * s11)));
}

inline Covariance examine_covariance(const double (&matrix)[16]) {
  return clearly_definite(matrix) ? Covariance::valid : examine_covariance_by_elimination(matrix);
}

}  // namespace regista::plugin
