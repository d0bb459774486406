// SPDX-License-Identifier: MIT
// Positioners that break one promise each.
#include <array>
#include <limits>

#include "bad.hpp"

namespace {

using regista::Frame;
using regista::Placement;
using regista::Vertex;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

struct OffTheField : bad::Described {
  static constexpr auto id = "off_the_field";
  void place(const Frame&, Placement out) { out.point(5.3, 0.0); }
};
struct NowhereAtAll : bad::Described {
  static constexpr auto id = "nowhere_at_all";
  void place(const Frame&, Placement out) { out.point(0.0, nan); }
};
struct BadScore : bad::Described {
  static constexpr auto id = "bad_score";
  void place(const Frame&, Placement out) { out.point(0.0, 0.0, -0.5); }
};
struct NoSuchTask : bad::Described {
  static constexpr auto id = "no_such_task";
  void place(const Frame& frame, Placement out) { out.point(0, 0, 1, static_cast<int>(frame.tasks().size())); }
};
struct NoSuchRobot : bad::Described {
  static constexpr auto id = "no_such_robot";
  void place(const Frame&, Placement out) { out.point(0, 0, 1, -1, 12); }
};
struct EdgeToNowhere : bad::Described {
  static constexpr auto id = "edge_to_nowhere";
  void place(const Frame&, Placement out) { out.edge(out.point(0, 0), 5); }
};
struct EdgeToItself : bad::Described {
  static constexpr auto id = "edge_to_itself";
  void place(const Frame&, Placement out) {
    const std::uint32_t a = out.point(0, 0);
    out.edge(a, a);
  }
};
struct EdgeTwice : bad::Described {
  static constexpr auto id = "edge_twice";
  void place(const Frame&, Placement out) {
    const std::uint32_t a = out.point(0, 0), b = out.point(1, 0);
    out.edge(a, b);
    out.edge(b, a);
  }
};
constexpr std::array<Vertex, 3> triangle{{{0, 0}, {1, 0}, {0, 1}}};
struct CellOfNobody : bad::Described {
  static constexpr auto id = "cell_of_nobody";
  void place(const Frame&, Placement out) { out.cell(0, triangle); }
};
struct TwoCells : bad::Described {
  static constexpr auto id = "two_cells";
  void place(const Frame&, Placement out) {
    out.cell(1, triangle);
    out.cell(1, triangle);
  }
};
struct ClockwiseCell : bad::Described {
  static constexpr auto id = "clockwise_cell";
  void place(const Frame&, Placement out) { out.cell(1, std::array<Vertex, 3>{triangle[2], triangle[1], triangle[0]}); }
};
struct CellOffTheField : bad::Described {
  static constexpr auto id = "cell_off_the_field";
  void place(const Frame&, Placement out) { out.cell(1, std::array<Vertex, 3>{Vertex{0, 0}, {9, 0}, {0, 1}}); }
};
struct CellPastTheEnd : bad::Described {
  static constexpr auto id = "cell_past_the_end";
  static std::int32_t call(void*, const regista_frame*, regista_placement* out, regista_error*) {
    *static_cast<regista_cell*>(out->cells.data) = {1, 0, 4};
    out->cells.count = 1;
    return REGISTA_OK;
  }
};
struct CountsTooFar : bad::Described {
  static constexpr auto id = "counts_too_far";
  static std::int32_t call(void*, const regista_frame*, regista_placement* out, regista_error*) {
    out->points.count = out->points.capacity + 1;
    return REGISTA_OK;
  }
};
// Sound as long as there is room for two points.
struct IgnoresCapacity : bad::Described {
  static constexpr auto id = "ignores_capacity";
  static std::int32_t call(void*, const regista_frame*, regista_placement* out, regista_error*) {
    auto* const bytes = static_cast<unsigned char*>(out->points.data);
    *reinterpret_cast<regista_waypoint*>(bytes) = {0, 0, 1, -1, 0};
    *reinterpret_cast<regista_waypoint*>(bytes + out->points.stride) = {1, 0, 1, -1, 0};
    out->points.count = 2;
    return REGISTA_OK;
  }
};
// Takes the room of each buffer for an array of what it knows: two elements of each.
template <class T>
void fill_as_array(regista_room& room, const T& first, const T& second) {
  auto* const elements = static_cast<T*>(room.data);
  elements[0] = first;
  elements[1] = second;
  room.count = 2;
}
struct StepsByPointRoom : bad::Described {
  static constexpr auto id = "steps_by_point_room";
  static std::int32_t call(void*, const regista_frame*, regista_placement* out, regista_error*) {
    fill_as_array<regista_waypoint>(out->points, {0, 0, 1, -1, 0}, {1, 0, 1, -1, 0});
    return REGISTA_OK;
  }
};
struct StepsByEdgeRoom : bad::Described {
  static constexpr auto id = "steps_by_edge_room";
  static std::int32_t call(void*, const regista_frame*, regista_placement* raw, regista_error*) {
    Placement out(*raw);
    for (const double x : {0.0, 1.0, 2.0}) out.point(x, 0.0);
    fill_as_array<regista_edge>(raw->edges, {0, 1}, {1, 2});
    return REGISTA_OK;
  }
};
struct StepsByCellRoom : bad::Described {
  static constexpr auto id = "steps_by_cell_room";
  static std::int32_t call(void*, const regista_frame*, regista_placement* out, regista_error*) {
    fill_as_array<regista_cell>(out->cells, {1, 0, 0}, {2, 0, 0});
    return REGISTA_OK;
  }
};
struct StepsByVertexRoom : bad::Described {
  static constexpr auto id = "steps_by_vertex_room";
  static std::int32_t call(void*, const regista_frame*, regista_placement* out, regista_error*) {
    fill_as_array<regista_vertex>(out->vertices, {0, 0}, {1, 0});
    return REGISTA_OK;
  }
};
struct MovesTheRoom : bad::Described {
  static constexpr auto id = "moves_the_room";
  static std::int32_t call(void*, const regista_frame*, regista_placement* out, regista_error*) {
    out->vertices.capacity += 1;
    return REGISTA_OK;
  }
};
struct FillsTheTail : bad::Described {
  static constexpr auto id = "fills_the_tail";
  static std::int32_t call(void*, const regista_frame*, regista_placement* out, regista_error*) {
    auto* bytes = reinterpret_cast<unsigned char*>(out);
    for (std::size_t k = sizeof *out; k < out->size; ++k) bytes[k] = 0;
    return REGISTA_OK;
  }
};

}  // namespace

REGISTA_PLUGINS(
    regista::Plugin<OffTheField, regista::positioner>, regista::Plugin<NowhereAtAll, regista::positioner>,
    regista::Plugin<BadScore, regista::positioner>, regista::Plugin<NoSuchTask, regista::positioner>,
    regista::Plugin<NoSuchRobot, regista::positioner>, regista::Plugin<EdgeToNowhere, regista::positioner>,
    regista::Plugin<EdgeToItself, regista::positioner>, regista::Plugin<EdgeTwice, regista::positioner>,
    regista::Plugin<CellOfNobody, regista::positioner>, regista::Plugin<TwoCells, regista::positioner>,
    regista::Plugin<ClockwiseCell, regista::positioner>, regista::Plugin<CellOffTheField, regista::positioner>,
    regista::Plugin<CellPastTheEnd, bad::bare_positioner>, regista::Plugin<CountsTooFar, bad::bare_positioner>,
    regista::Plugin<IgnoresCapacity, bad::bare_positioner>, regista::Plugin<StepsByPointRoom, bad::bare_positioner>,
    regista::Plugin<StepsByEdgeRoom, bad::bare_positioner>, regista::Plugin<StepsByCellRoom, bad::bare_positioner>,
    regista::Plugin<StepsByVertexRoom, bad::bare_positioner>, regista::Plugin<MovesTheRoom, bad::bare_positioner>,
    regista::Plugin<FillsTheTail, bad::bare_positioner>)
