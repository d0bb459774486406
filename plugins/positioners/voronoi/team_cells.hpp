// SPDX-License-Identifier: GPL-3.0-or-later
// The cells of the active robots of a world, for plugins: from the host's views to cells.hpp and back.
#pragma once

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <vector>

#include <regista/positioner.hpp>

#include "cells.hpp"

namespace voronoi {

class TeamCells {
 public:
  // Throws std::out_of_range when the team has more robots than there may be sites.
  void setup(const regista::Environment& environment) {
    if (environment->team_size > most_cell_sites) {
      throw std::out_of_range("cells: at most " + std::to_string(most_cell_sites) + " robots, not " +
                              std::to_string(environment->team_size));
    }
    field_ = {environment->field_length / 2.0, environment->field_width / 2.0};
    team_.reserve(most_cell_sites);
  }

  // Calls use(shirt number, cell) for each active robot that has a cell, ascending.
  template <class Use>
  void each(const regista::World& world, const Use& use) {
    const regista::Span<std::int32_t> active = world.active();
    team_.clear();
    for (const std::int32_t number : active) {
      const regista::Robot& robot = world.robot(number);
      team_.push_back({robot.pose[0], robot.pose[1]});
    }
    for (std::size_t i = 0; i < team_.size(); ++i) {
      const Cell own = cell(team_, i, field_);
      if (own.count > 0) use(active[i], own);
    }
  }

  static void write(std::int32_t number, const Cell& cell, regista::Placement& out) {
    std::array<regista::Vertex, most_cell_corners> vertices;
    std::transform(cell.span().begin(), cell.span().end(), vertices.begin(), [](const Point& corner) {
      return regista::Vertex{corner.x, corner.y};
    });
    out.cell(number, {vertices.data(), cell.count});
  }

 private:
  Extent field_{};
  std::vector<Point> team_;
};

}  // namespace voronoi
