// SPDX-License-Identifier: GPL-3.0-or-later
// Where in its cell a robot should be.
//
// The centroid: robots that always walk there spread over the field (Lloyd 1982; Cortes, Martinez, Karatas & Bullo
// 2004, "Coverage control for mobile sensing networks"), as centres of mass of cells do in Dashti et al. 2006, "Dynamic
// Positioning based on Voronoi Cells".
//
// The best point: offensive placement, far from opponents and near to ball and goal. It is sought among the centroid
// and points half-way and 0.9 of the way from it to each corner and to the middle of each side: no optimum, but the
// same for all who see the same.
#pragma once

#include <optional>
#include <span>

#include "cells.hpp"

namespace voronoi {

// Of area, not of corners. The cell is not empty.
Point centroid(const Cell& cell);

// What makes a point good. Weights are >= 0.
struct Attraction {
  double openness = 1.0, ball = 0.5, goal = 0.5;
  double full_openness = 3.0;  // m, > 0; distance from the nearest opponent that counts as 1
  double reach = 10.8;         // m, > 0; distance from ball or goal that counts as 0
};

struct Candidate {
  Point at;
  double value;  // [0, 1]: weighted mean of min(1, d_opponent / full_openness), 1 - d_ball / reach, 1 - d_goal / reach
};

// The candidate with the largest value, the first of equals. The centroid with 1 when all weights are 0; without a ball
// its weight does not count.
Candidate best_point(const Cell& cell, std::span<const Point> opponents, const std::optional<Point>& ball,
                     const Point& goal, const Attraction& attraction);

// The value of any point, as above.
double value_of(const Point& point, std::span<const Point> opponents, const std::optional<Point>& ball,
                const Point& goal, const Attraction& attraction);

}  // namespace voronoi
