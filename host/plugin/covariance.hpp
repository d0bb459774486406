// SPDX-License-Identifier: MIT
// Whether a 4 x 4 matrix can be a covariance: symmetric and positive semi-definite, up to rounding. By elimination
// without pivoting (an L D L^T factorisation): the matrix is positive semi-definite if and only if no pivot is negative
// and the column below a zero pivot is zero. All tolerances are relative to the diagonal, so units do not matter.
#pragma once

#include <cmath>

namespace regista::plugin {

enum class Covariance { valid, not_finite, not_symmetric, not_semi_definite };

inline Covariance examine_covariance(const double (&matrix)[16]) {
  constexpr int n = 4;
  constexpr double rounding = 1e-9;
  double sum = 0.0;
  for (const double value : matrix) sum += 0.0 * value;  // 0 unless one of them is infinite or no number
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

}  // namespace regista::plugin
