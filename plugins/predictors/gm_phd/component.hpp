// SPDX-License-Identifier: MIT
// One Gaussian of the mixture: where a robot may be and how it may move, with the number of robots it stands for.
// Carried forward by its motion, corrected by a sighting, put together with others of its kind.
//
// Motion: each component of the velocity is an Ornstein-Uhlenbeck process (a random walk pulled back to zero) of the
// standing deviation `speed` and the time constant `persistence`, so that the expected way of a robot seen with the
// velocity v is v * persistence * (1 - exp(-t / persistence)): constant velocity with decay. Uhlenbeck and Ornstein,
// "On the theory of the Brownian motion" (Physical Review 36, 1930), in closed form: one long step equals many short
// ones. Correction: Kalman. Putting together: the mean and covariance of the mixture (Vo and Ma 2006, table II).
#pragma once

#include <algorithm>
#include <cmath>

namespace gm_phd {

// SI units, field frame. cross: E[dx dvx], E[dx dvy], E[dy dvx], E[dy dvy].
struct Component {
  double x = 0.0, y = 0.0, vx = 0.0, vy = 0.0;
  double pxx = 0.0, pxy = 0.0, pyy = 0.0;             // covariance of the position
  double cxx = 0.0, cxy = 0.0, cyx = 0.0, cyy = 0.0;  // cross
  double vxx = 0.0, vxy = 0.0, vyy = 0.0;             // covariance of the velocity
  double weight = 0.0;                                // expected number of robots
  double age = 0.0;                                   // s since it was last seen
  int label = 0;                                      // 0: none yet
  bool seen = false;                                  // in the image just taken in
  bool confirmed = false;                             // a component with this label has stood for a robot
};

struct Sighting {
  double x, y;        // field frame, m
  double xx, xy, yy;  // covariance, positive definite
};

// The motion over `dt`: p' = p + reach v, v' = keep v, and its noise per axis.
struct Step {
  double dt = 0.0, keep = 1.0, reach = 0.0, position_noise = 0.0, cross_noise = 0.0, velocity_noise = 0.0;
  double survival = 1.0;  // share of the weight that is left
  Step() = default;
  // speed in m/s, persistence in s, survival_per_second in (0, 1].
  Step(double duration, double speed, double persistence, double survival_per_second)
      : dt(duration), survival(std::pow(survival_per_second, duration)) {
    const double variance = speed * speed;
    const double lost = -std::expm1(-dt / persistence);  // 1 - keep
    keep = 1.0 - lost;
    reach = persistence * lost;
    velocity_noise = variance * lost * (1.0 + keep);
    cross_noise = variance * persistence * lost * lost;
    position_noise = std::max(0.0, variance * persistence * (2.0 * (dt - reach) - persistence * lost * lost));
  }
};

inline void advance(Component& c, const Step& step) {
  const double r = step.reach, k = step.keep;
  c.x += r * c.vx;
  c.y += r * c.vy;
  c.vx *= k;
  c.vy *= k;
  c.pxx += r * (2.0 * c.cxx + r * c.vxx) + step.position_noise;
  c.pxy += r * (c.cxy + c.cyx + r * c.vxy);
  c.pyy += r * (2.0 * c.cyy + r * c.vyy) + step.position_noise;
  c.cxx = k * (c.cxx + r * c.vxx) + step.cross_noise;
  c.cxy = k * (c.cxy + r * c.vxy);
  c.cyx = k * (c.cyx + r * c.vxy);
  c.cyy = k * (c.cyy + r * c.vyy) + step.cross_noise;
  c.vxx = k * k * c.vxx + step.velocity_noise;
  c.vxy *= k * k;
  c.vyy = k * k * c.vyy + step.velocity_noise;
  c.weight *= step.survival;
  c.age += step.dt;
  c.seen = false;
}

// How a sighting fits a component.
struct Fit {
  double dx, dy;         // sighting minus expectation
  double ixx, ixy, iyy;  // inverse of the innovation's covariance
  double determinant;    // of that covariance
  double distance;       // squared Mahalanobis
};

inline Fit compare(const Component& c, const Sighting& z) {
  Fit fit;
  fit.dx = z.x - c.x;
  fit.dy = z.y - c.y;
  const double sxx = c.pxx + z.xx, sxy = c.pxy + z.xy, syy = c.pyy + z.yy;
  fit.determinant = sxx * syy - sxy * sxy;
  const double scale = 1.0 / fit.determinant;
  fit.ixx = syy * scale;
  fit.ixy = -sxy * scale;
  fit.iyy = sxx * scale;
  fit.distance = fit.ixx * fit.dx * fit.dx + 2.0 * fit.ixy * fit.dx * fit.dy + fit.iyy * fit.dy * fit.dy;
  return fit;
}

// The Kalman update. The covariance of the position is taken as P S^-1 R, a product of positive terms: no difference of
// nearly equal matrices, however exact the sighting is.
inline void take(Component& c, const Sighting& z, const Fit& fit) {
  // gain K = P S^-1, velocity gain L = C' S^-1
  const double kxx = c.pxx * fit.ixx + c.pxy * fit.ixy, kxy = c.pxx * fit.ixy + c.pxy * fit.iyy;
  const double kyx = c.pxy * fit.ixx + c.pyy * fit.ixy, kyy = c.pxy * fit.ixy + c.pyy * fit.iyy;
  const double lxx = c.cxx * fit.ixx + c.cyx * fit.ixy, lxy = c.cxx * fit.ixy + c.cyx * fit.iyy;
  const double lyx = c.cxy * fit.ixx + c.cyy * fit.ixy, lyy = c.cxy * fit.ixy + c.cyy * fit.iyy;
  c.x += kxx * fit.dx + kxy * fit.dy;
  c.y += kyx * fit.dx + kyy * fit.dy;
  c.vx += lxx * fit.dx + lxy * fit.dy;
  c.vy += lyx * fit.dx + lyy * fit.dy;
  c.vxx -= lxx * c.cxx + lxy * c.cyx;
  c.vxy -= 0.5 * (lxx * c.cxy + lxy * c.cyy + lyx * c.cxx + lyy * c.cyx);
  c.vyy -= lyx * c.cxy + lyy * c.cyy;
  // E[dp dv'] = R S^-1 C = R L'
  c.cxx = z.xx * lxx + z.xy * lxy;
  c.cxy = z.xx * lyx + z.xy * lyy;
  c.cyx = z.xy * lxx + z.yy * lxy;
  c.cyy = z.xy * lyx + z.yy * lyy;
  c.pxx = kxx * z.xx + kxy * z.xy;
  c.pxy = 0.5 * (kxx * z.xy + kxy * z.yy + kyx * z.xx + kyy * z.xy);
  c.pyy = kyx * z.xy + kyy * z.yy;
  c.age = 0.0;
  c.seen = true;
}

// Squared Mahalanobis distance of the means of position and velocity under the covariance of `b`, or anything beyond
// `limit` where that is clear earlier.
inline double distance(const Component& a, const Component& b, double limit) {
  const double dx = a.x - b.x, dy = a.y - b.y, squared = dx * dx + dy * dy;
  if (squared > limit * (b.pxx + b.pyy)) return 2.0 * limit + 1.0;  // no eigenvalue exceeds the trace
  const double determinant = b.pxx * b.pyy - b.pxy * b.pxy;
  if (!(determinant > 0.0)) return squared > 0.0 ? 2.0 * limit + 1.0 : 0.0;
  const double ixx = b.pyy / determinant, ixy = -b.pxy / determinant, iyy = b.pxx / determinant;
  const double ux = ixx * dx + ixy * dy, uy = ixy * dx + iyy * dy;  // P^-1 dp
  const double place = dx * ux + dy * uy;
  if (place > limit) return place;
  // What is left of the velocity once the place is known: mean e, covariance Q = V - C' P^-1 C.
  const double ex = a.vx - b.vx - b.cxx * ux - b.cyx * uy, ey = a.vy - b.vy - b.cxy * ux - b.cyy * uy;
  const double gxx = ixx * b.cxx + ixy * b.cyx, gxy = ixx * b.cxy + ixy * b.cyy;
  const double gyx = ixy * b.cxx + iyy * b.cyx, gyy = ixy * b.cxy + iyy * b.cyy;
  const double qxx = b.vxx - b.cxx * gxx - b.cyx * gyx, qxy = b.vxy - b.cxx * gxy - b.cyx * gyy;
  const double qyy = b.vyy - b.cxy * gxy - b.cyy * gyy, q = qxx * qyy - qxy * qxy;
  if (!(qxx > 0.0 && q > 0.0)) return ex == 0.0 && ey == 0.0 ? place : 2.0 * limit + 1.0;
  return place + (qyy * ex * ex - 2.0 * qxy * ex * ey + qxx * ey * ey) / q;
}

// Mean and covariance of the two as one mixture; the label stays that of `a`.
inline void combine(Component& a, const Component& b) {
  const double weight = a.weight + b.weight, s = b.weight / weight, r = 1.0 - s, both = s * r;
  const double dx = b.x - a.x, dy = b.y - a.y, du = b.vx - a.vx, dv = b.vy - a.vy;
  a.x += s * dx;
  a.y += s * dy;
  a.vx += s * du;
  a.vy += s * dv;
  a.pxx = r * a.pxx + s * b.pxx + both * dx * dx;
  a.pxy = r * a.pxy + s * b.pxy + both * dx * dy;
  a.pyy = r * a.pyy + s * b.pyy + both * dy * dy;
  a.cxx = r * a.cxx + s * b.cxx + both * dx * du;
  a.cxy = r * a.cxy + s * b.cxy + both * dx * dv;
  a.cyx = r * a.cyx + s * b.cyx + both * dy * du;
  a.cyy = r * a.cyy + s * b.cyy + both * dy * dv;
  a.vxx = r * a.vxx + s * b.vxx + both * du * du;
  a.vxy = r * a.vxy + s * b.vxy + both * du * dv;
  a.vyy = r * a.vyy + s * b.vyy + both * dv * dv;
  a.weight = weight;
  a.age = std::min(a.age, b.age);
  a.seen = a.seen || b.seen;
}

}  // namespace gm_phd
