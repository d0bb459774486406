// SPDX-License-Identifier: MIT
// Symmetric 4 x 4 matrices, as the covariance of a ball's state (x, y, vx, vy) is one: the ten numbers that differ, and
// the inverse by blocks (Schur complement), at a third of what a general inverse costs.
#pragma once

#include <Eigen/Core>
#include <algorithm>

namespace regista::mind {

// [position  cross; cross^T  velocity], 2 x 2 each; of the symmetric blocks only xx, xy, yy.
struct Symmetric4 {
  struct Block {
    double xx = 0.0, xy = 0.0, yy = 0.0;
    Block inverse() const {
      const double factor = 1.0 / (xx * yy - xy * xy);
      return {factor * yy, -factor * xy, factor * xx};
    }
  };
  Block position, velocity;
  double xx = 0.0, xy = 0.0, yx = 0.0, yy = 0.0;  // cross: of x with vx, of x with vy, of y with vx, of y with vy

  // In the order of abi.h: of a place, and the rest of a motion; or both in one.
  static Symmetric4 from(const double (&place)[3], const double (&rest)[7]) {
    return {{place[0], place[1], place[2]}, {rest[4], rest[5], rest[6]}, rest[0], rest[1], rest[2], rest[3]};
  }
  void write(double (&motion)[10]) const {
    const double values[10]{position.xx, position.xy, position.yy, xx,          xy,
                            yx,          yy,          velocity.xx, velocity.xy, velocity.yy};
    std::copy_n(values, 10, motion);
  }

  // this += factor * other
  void add(double factor, const Symmetric4& other) {
    position.xx += factor * other.position.xx;
    position.xy += factor * other.position.xy;
    position.yy += factor * other.position.yy;
    velocity.xx += factor * other.velocity.xx;
    velocity.xy += factor * other.velocity.xy;
    velocity.yy += factor * other.velocity.yy;
    xx += factor * other.xx;
    xy += factor * other.xy;
    yx += factor * other.yx;
    yy += factor * other.yy;
  }

  Eigen::Vector4d operator*(const Eigen::Vector4d& v) const {
    return {position.xx * v[0] + position.xy * v[1] + xx * v[2] + xy * v[3],
            position.xy * v[0] + position.yy * v[1] + yx * v[2] + yy * v[3],
            xx * v[0] + yx * v[1] + velocity.xx * v[2] + velocity.xy * v[3],
            xy * v[0] + yy * v[1] + velocity.xy * v[2] + velocity.yy * v[3]};
  }

  // Of a positive definite matrix.
  Symmetric4 inverse() const {
    const Block p = position.inverse();
    // U = P^-1 C and the Schur complement S = V - C^T U.
    const double u00 = p.xx * xx + p.xy * yx, u01 = p.xx * xy + p.xy * yy;
    const double u10 = p.xy * xx + p.yy * yx, u11 = p.xy * xy + p.yy * yy;
    const Block schur{velocity.xx - (xx * u00 + yx * u10), velocity.xy - (xx * u01 + yx * u11),
                      velocity.yy - (xy * u01 + yy * u11)};
    const Block s = schur.inverse();
    // W = U S^-1; the blocks are P^-1 + W U^T, -W, S^-1.
    const double w00 = u00 * s.xx + u01 * s.xy, w01 = u00 * s.xy + u01 * s.yy;
    const double w10 = u10 * s.xx + u11 * s.xy, w11 = u10 * s.xy + u11 * s.yy;
    return {{p.xx + (w00 * u00 + w01 * u01), p.xy + (w00 * u10 + w01 * u11), p.yy + (w10 * u10 + w11 * u11)},
            s,
            -w00,
            -w01,
            -w10,
            -w11};
  }
};

}  // namespace regista::mind
