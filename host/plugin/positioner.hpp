// SPDX-License-Identifier: MIT
// The call of a positioner, and the checks of the points, edges and cells it hands back.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "plugin/instance.hpp"

namespace regista::plugin {

// Points of the field frame, edges between them, and the cells that belong to robots: cell c has the vertices
// [c.first, c.first + c.count), counter-clockwise.
struct Placement {
  std::vector<regista_waypoint> points;
  std::vector<regista_edge> edges;
  std::vector<regista_cell> cells;
  std::vector<regista_vertex> vertices;
};

class Positioner {
 public:
  static constexpr std::uint32_t point_capacity = 256, edge_capacity = 768, cell_capacity = 32, vertex_capacity = 512;

  // Throws Failure when the plugin is no positioner.
  explicit Positioner(std::shared_ptr<Instance> instance);

  // Replaces the content of `out`, which allocates nothing once it has grown. Checked: points finite, inside field and
  // border strip, scores >= 0, tasks and robots that exist; edges between points that exist; cells of robots that exist
  // with vertices that exist, counter-clockwise.
  void place(const regista_frame& frame, Placement& out);

 private:
  void check_points(const regista_frame& frame, std::span<const regista_waypoint> points) const;
  void check_edges(std::span<const regista_edge> edges, std::size_t point_count) const;
  void check_cells(std::span<const regista_cell> cells, std::span<const regista_vertex> vertices) const;

  std::shared_ptr<Instance> instance_;
  const regista_positioner* calls_;
};

}  // namespace regista::plugin
