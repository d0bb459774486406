// SPDX-License-Identifier: MIT
// Formation by Delaunay triangulation (Akiyama & Noda 2008, "Multi-agent Positioning Mechanism in the Dynamic
// Environment"): samples say where everybody stands for some places of the ball; between them positions are linear
// inside the triangle of samples that holds the ball. At a sample its own positions come out; over the triangles'
// sides nothing jumps.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "triangulation.hpp"

namespace formations {

struct Position {
  double x, y;  // m
  friend bool operator==(const Position&, const Position&) = default;
};

// In the field frame: x towards the opponent's goal, y to the left. Distinct places of the ball, on the grid.
struct Sample {
  GridPoint ball;
  std::vector<Position> positions;  // as many in every sample
};

// Metres to a step of the grid.
inline constexpr double grid_step = 1e-4;

// What rules where the ball is outside of the samples' convex hull.
enum class Beyond {
  nearest_point,  // of the hull: nothing jumps
  nearest_sample  // librcsc's rule
};

// Up to three samples and their shares, >= 0, which add up to 1.
struct Shares {
  std::array<std::size_t, 3> sample;
  std::array<double, 3> share;
};

class Formation {
 public:
  // Samples: at least one. Balls and positions are multiplied by the two scales, > 0.
  Formation(std::span<const Sample> samples, double scale_x, double scale_y, Beyond beyond);

  std::size_t positions() const { return positions_; }

  // A function of the ball alone, whatever was asked before. `ball` is finite.
  Shares shares(const Position& ball) const;
  // Of number `index`, from 0.
  Position position(const Shares& shares, std::size_t index) const;

  const Triangulation& triangulation() const { return triangulation_; }
  const Position& ball(std::size_t sample) const { return balls_[sample]; }

 private:
  static constexpr std::size_t cells = 16;  // along each side of the samples' bounding box

  double turn(int a, int b, const Position& p) const;
  std::size_t cell(const Position& ball) const;
  int locate(const Position& ball, int start) const;
  int thorough(const Position& ball) const;
  Shares inside(int triangle, const Position& ball) const;
  Shares on_border(const Position& ball) const;
  Shares at_nearest(const Position& ball) const;

  Beyond beyond_;
  std::size_t positions_;
  std::vector<Position> balls_;
  std::vector<Position> table_;  // sample by sample
  Triangulation triangulation_;
  Position low_{}, per_cell_{};  // corner of the bounding box, cells to a metre
  double flat_ = 0.0;            // m^2; what rounding may make of no area
  std::vector<int> starts_;      // for each cell a triangle at or near it
};

}  // namespace formations
