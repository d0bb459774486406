// SPDX-License-Identifier: MIT
// A positioner finds the desirable points of this world (V of the paper). The class has
//
//   void place(const regista::Frame&, regista::Placement out);
#pragma once

#include <span>
#include <stdexcept>

#include <regista/plugin.hpp>

namespace regista {

// The host's buffers for points, edges and cells.
class Placement {
 public:
  explicit Placement(regista_placement& raw) : raw_(&raw) {}
  std::size_t point_capacity() const { return raw_->point_capacity; }
  // Returns the index of the point. task: index into the frame's tasks, -1 = none; robot: shirt number, 0 = none.
  std::uint32_t point(double x, double y, double score = 1.0, int task = -1, int robot = 0) {
    need(raw_->point_count, raw_->point_capacity, "points");
    raw_->points[raw_->point_count] = {x, y, score, task, robot};
    return raw_->point_count++;
  }
  void edge(std::uint32_t from, std::uint32_t to) {
    need(raw_->edge_count, raw_->edge_capacity, "edges");
    raw_->edges[raw_->edge_count++] = {from, to};
  }
  // The region of robot `number`, counter-clockwise.
  void cell(int number, std::span<const Vertex> vertices) {
    need(raw_->cell_count, raw_->cell_capacity, "cells");
    if (raw_->vertex_capacity - raw_->vertex_count < vertices.size()) need(0, 0, "vertices");
    raw_->cells[raw_->cell_count++] = {number, raw_->vertex_count, static_cast<std::uint32_t>(vertices.size())};
    for (const Vertex& vertex : vertices) raw_->vertices[raw_->vertex_count++] = vertex;
  }

 private:
  static void need(std::uint32_t count, std::uint32_t capacity, const char* what) {
    if (count >= capacity) throw std::length_error(std::string("more ") + what + " than the host has room for");
  }
  regista_placement* raw_;
};

struct positioner {
  static constexpr std::int32_t kind = REGISTA_KIND_POSITIONER;

  template <class Class>
  static const void* table() {
    static constexpr regista_positioner calls{
        sizeof(regista_positioner), 0,
        [](void* instance, const regista_frame* frame, regista_placement* out, regista_error* error) {
          return detail::guarded(error, [&] { static_cast<Class*>(instance)->place(Frame(*frame), Placement(*out)); });
        }};
    return &calls;
  }
};

}  // namespace regista
