// SPDX-License-Identifier: MIT
// Which part of a component lies in what the camera saw: a sector of a disc. Nothing is detected outside it, so a
// component there must not be held against a missing sighting.
//
// At the borders the probability that the robot is inside is that of a uniform distribution with the component's mean
// and standard deviation across the border: a ramp of half width sqrt(3) deviations, without any transcendental
// function. The borders are taken as independent of each other. Robots that stand behind others (occlusion) are not
// thought of.
#pragma once

#include <algorithm>
#include <cmath>

#include "component.hpp"

namespace gm_phd {

struct View {
  double x, y;                   // apex, field frame
  double axis_x, axis_y;         // unit vector
  double cosine, sine;           // of half the opening angle, which is in [0, pi]
  double range;                  // m
  double border_variance = 0.0;  // m^2: how far the borders may be from where they are believed to be

  // Probability that the robot is inside, 0 to 1.
  double share(const Component& c) const {
    const double ax = c.x - x, ay = c.y - y;
    const double ahead = ax * axis_x + ay * axis_y, left = axis_x * ay - axis_y * ax;
    const double far = std::sqrt(ax * ax + ay * ay);
    const double reach = std::sqrt(3.0 * (c.pxx + c.pyy + border_variance));  // beyond it nothing is uncertain
    // Signed distances to the borders, positive inside.
    const double rim = range - far, to_left = ahead * sine - left * cosine, to_right = ahead * sine + left * cosine;
    const bool all_round = sine <= 0.0 && cosine < 0.0, convex = cosine >= 0.0;
    const double side = convex ? std::min(to_left, to_right) : std::max(to_left, to_right);
    if (rim <= -reach || (!all_round && side <= -reach)) return 0.0;
    if (rim >= reach && (all_round || side >= reach)) return 1.0;
    // The rim's normal is the line of sight.
    const double out = far > 0.0 ? 1.0 / far : 0.0;
    double inside = ramp(rim, across(c, ax * out, ay * out));
    if (all_round) return inside;
    const double nlx = axis_x * sine + axis_y * cosine, nly = axis_y * sine - axis_x * cosine;
    const double nrx = axis_x * sine - axis_y * cosine, nry = axis_y * sine + axis_x * cosine;
    const double l = ramp(to_left, across(c, nlx, nly)), r = ramp(to_right, across(c, nrx, nry));
    return inside * (convex ? l * r : std::max(l, r));
  }

 private:
  double across(const Component& c, double nx, double ny) const {
    return c.pxx * nx * nx + 2.0 * c.pxy * nx * ny + c.pyy * ny * ny + border_variance;
  }
  static double ramp(double distance, double variance) {
    const double half = std::sqrt(3.0 * std::max(variance, 0.0));
    if (distance >= half) return 1.0;
    if (distance <= -half) return 0.0;
    return 0.5 + 0.5 * distance / half;
  }
};

}  // namespace gm_phd
