// SPDX-License-Identifier: MIT
// A positioner finds the desirable points of this world (V of the paper). The class has
//
//   void place(const regista::Frame&, regista::Placement out);
#pragma once

#include <span>

#include <regista/plugin.hpp>

namespace regista {

// The host's buffers for points, edges and cells.
class Placement {
 public:
  explicit Placement(regista_placement& raw)
      : points_(raw.points), edges_(raw.edges), cells_(raw.cells), vertices_(raw.vertices) {}
  std::size_t point_capacity() const { return points_.capacity(); }
  // Returns the index of the point. task: index into the frame's tasks, -1 = none; robot: shirt number, 0 = none.
  std::uint32_t point(double x, double y, double score = 1.0, int task = -1, int robot = 0) {
    const auto index = static_cast<std::uint32_t>(points_.size());
    points_.add("points") = {x, y, score, task, robot};
    return index;
  }
  void edge(std::uint32_t from, std::uint32_t to) { edges_.add("edges") = {from, to}; }
  // The region of robot `number`, counter-clockwise.
  void cell(int number, std::span<const Vertex> vertices) {
    const auto first = static_cast<std::uint32_t>(vertices_.size());
    cells_.add("cells") = {number, first, static_cast<std::uint32_t>(vertices.size())};
    for (const Vertex& vertex : vertices) vertices_.add("vertices") = vertex;
  }

 private:
  Room<Waypoint> points_;
  Room<Edge> edges_;
  Room<regista_cell> cells_;
  Room<Vertex> vertices_;
};

#pragma GCC visibility push(hidden)  // see plugin.hpp
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
#pragma GCC visibility pop

}  // namespace regista
