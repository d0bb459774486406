// SPDX-License-Identifier: MIT
#include "plugin/positioner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace regista::plugin {
namespace {

constexpr double rounding = 1e-9;  // m, and m^2: what arithmetic may lose

void check_count(const Instance& instance, std::uint32_t count, std::uint32_t capacity, const char* what) {
  if (count > capacity) [[unlikely]]
    instance.fail("place", fmt::format("wrote {} {} into room for {}", count, what, capacity));
}

}  // namespace

Positioner::Positioner(std::shared_ptr<Instance> instance)
    : instance_(std::move(instance)), calls_(&instance_->table<regista_positioner>(REGISTA_KIND_POSITIONER)) {}

void Positioner::place(const regista_frame& frame, Placement& out) {
  AnswerRooms& rooms = instance_->rooms();
  regista_placement& raw = *instance_->open(rooms.placement);
  raw = {};
  raw.size = sizeof raw;
  const auto room = [this](auto& guarded, std::uint32_t capacity) {
    auto* const data = instance_->open(guarded, capacity);
    return regista_room{data, capacity, 0, sizeof *data, 0};
  };
  raw.points = room(rooms.points, point_capacity);
  raw.edges = room(rooms.edges, edge_capacity);
  raw.cells = room(rooms.cells, cell_capacity);
  raw.vertices = room(rooms.vertices, vertex_capacity);
  instance_->call_with([](Inputs& inputs, const regista_frame* seen, auto*) { inputs.add("frame", seen); }, "place",
                       calls_->place, instance_->shown(&frame), &raw);
  instance_->check("place", Instance::Written{rooms.placement, "the placement itself"},
                   Instance::Written{rooms.points, "points"}, Instance::Written{rooms.edges, "edges"},
                   Instance::Written{rooms.cells, "cells"}, Instance::Written{rooms.vertices, "vertices"});

  // Of the struct only the counts are read: the plugin may have written over the rest.
  check_count(*instance_, raw.points.count, point_capacity, "points");
  check_count(*instance_, raw.edges.count, edge_capacity, "edges");
  check_count(*instance_, raw.cells.count, cell_capacity, "cells");
  check_count(*instance_, raw.vertices.count, vertex_capacity, "vertices");
  const auto points = rooms.points.first(raw.points.count);
  const auto edges = rooms.edges.first(raw.edges.count);
  const auto cells = rooms.cells.first(raw.cells.count);
  const auto vertices = rooms.vertices.first(raw.vertices.count);
  check_points(frame, points);
  check_edges(edges, points.size());
  check_cells(cells, vertices);
  instance_->answered(std::span<const regista_waypoint>(points), std::span<const regista_edge>(edges),
                      std::span<const regista_cell>(cells), std::span<const regista_vertex>(vertices));
  const auto take = [](auto& to, const auto& from, std::uint32_t capacity) {
    to.reserve(capacity);  // at the first call, so that none allocates later
    to.assign(from.begin(), from.end());
  };
  take(out.points, points, point_capacity);
  take(out.edges, edges, edge_capacity);
  take(out.cells, cells, cell_capacity);
  take(out.vertices, vertices, vertex_capacity);
}

void Positioner::check_points(const regista_frame& frame, std::span<const regista_waypoint> points) const {
  const regista_environment& field = instance_->environment();
  const double x_limit = field.field_length / 2 + field.border_strip + rounding;
  const double y_limit = field.field_width / 2 + field.border_strip + rounding;
  const auto tasks = static_cast<std::int64_t>(frame.tasks.count);
  const auto robots = static_cast<std::int64_t>(field.team_size);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const regista_waypoint& p = points[i];
    if (!(std::abs(p.x) <= x_limit && std::abs(p.y) <= y_limit)) [[unlikely]] {
      instance_->fail("place", fmt::format("point {} at ({}, {}) is outside the field", i, p.x, p.y));
    }
    if (!(p.score >= 0.0 && p.score <= std::numeric_limits<double>::max())) [[unlikely]] {
      instance_->fail("place", fmt::format("score of point {} is {}; scores are finite and at least 0", i, p.score));
    }
    if (p.task < -1 || p.task >= tasks) [[unlikely]]
      instance_->fail("place", fmt::format("point {} belongs to task {} of {}", i, p.task, tasks));
    if (p.robot < 0 || p.robot > robots) [[unlikely]]
      instance_->fail("place", fmt::format("point {} belongs to robot {} of {}", i, p.robot, robots));
  }
}

void Positioner::check_edges(std::span<const regista_edge> edges, std::size_t point_count) const {
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const regista_edge& edge = edges[i];
    if (edge.from >= point_count || edge.to >= point_count) [[unlikely]] {
      instance_->fail("place", fmt::format("edge {} joins points {} and {} of {}", i, edge.from, edge.to, point_count));
    }
    if (edge.from == edge.to) [[unlikely]]
      instance_->fail("place", fmt::format("edge {} joins point {} to itself", i, edge.from));
  }
  if (!instance_->rooms().closely) return;
  for (std::size_t i = 1; i < edges.size(); ++i) {
    const auto earlier = std::ranges::find_if(edges.first(i), [&](const regista_edge& each) {
      return std::minmax(each.from, each.to) == std::minmax(edges[i].from, edges[i].to);
    });
    if (earlier != edges.begin() + static_cast<std::ptrdiff_t>(i)) [[unlikely]]
      instance_->fail("place",
                      fmt::format("edge {} joins points {} and {} a second time", i, edges[i].from, edges[i].to));
  }
}

void Positioner::check_cells(std::span<const regista_cell> cells, std::span<const regista_vertex> vertices) const {
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const regista_vertex& vertex = vertices[i];
    if (!std::isfinite(vertex.x) || !std::isfinite(vertex.y)) [[unlikely]] {
      instance_->fail("place", fmt::format("vertex {} is at ({}, {})", i, vertex.x, vertex.y));
    }
  }
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const regista_cell& cell = cells[i];
    if (cell.robot < 1 || static_cast<std::uint32_t>(cell.robot) > instance_->environment().team_size) [[unlikely]] {
      instance_->fail(
          "place", fmt::format("cell {} belongs to robot {} of {}", i, cell.robot, instance_->environment().team_size));
    }
    if (cell.first > vertices.size() || cell.count > vertices.size() - cell.first) [[unlikely]] {
      instance_->fail("place", fmt::format("cell {} has {} vertices from {} on, but there are {}", i, cell.count,
                                           cell.first, vertices.size()));
    }
    double twice_area = 0.0;
    for (std::uint32_t k = 0; k < cell.count; ++k) {
      const regista_vertex& a = vertices[cell.first + k];
      const regista_vertex& b = vertices[cell.first + (k + 1 == cell.count ? 0 : k + 1)];
      twice_area += a.x * b.y - b.x * a.y;
    }
    if (twice_area < -rounding) [[unlikely]]
      instance_->fail("place", fmt::format("cell {} runs clockwise", i));
  }
}

}  // namespace regista::plugin
