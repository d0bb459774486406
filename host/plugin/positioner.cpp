// SPDX-License-Identifier: MIT
#include "plugin/positioner.hpp"

#include <fmt/format.h>

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
  regista_placement& raw = *answer_.data();
  raw = {};
  raw.size = sizeof raw;
  raw.point_capacity = point_capacity;
  raw.edge_capacity = edge_capacity;
  raw.cell_capacity = cell_capacity;
  raw.vertex_capacity = vertex_capacity;
  raw.points = points_.data();
  raw.edges = edges_.data();
  raw.cells = cells_.data();
  raw.vertices = vertices_.data();
  instance_->call_with([&](Inputs& inputs) { inputs.add("frame", &frame); }, "place", calls_->place, &frame, &raw);
  instance_->check("place", answer_, "the placement itself");
  instance_->check("place", points_, "points");
  instance_->check("place", edges_, "edges");
  instance_->check("place", cells_, "cells");
  instance_->check("place", vertices_, "vertices");

  // Of the struct only the counts are read: the plugin may have written over the rest.
  check_count(*instance_, raw.point_count, point_capacity, "points");
  check_count(*instance_, raw.edge_count, edge_capacity, "edges");
  check_count(*instance_, raw.cell_count, cell_capacity, "cells");
  check_count(*instance_, raw.vertex_count, vertex_capacity, "vertices");
  check_points(frame, raw.point_count);
  check_edges(raw.edge_count, raw.point_count);
  check_cells(raw.cell_count, raw.vertex_count);
  const auto take = [](auto& to, const auto& from, std::uint32_t count) {
    to.reserve(from.size());  // at the first call, so that none allocates later
    const auto taken = from.first(count);
    to.assign(taken.begin(), taken.end());
  };
  take(out.points, points_, raw.point_count);
  take(out.edges, edges_, raw.edge_count);
  take(out.cells, cells_, raw.cell_count);
  take(out.vertices, vertices_, raw.vertex_count);
}

void Positioner::check_points(const regista_frame& frame, std::uint32_t count) const {
  const regista_environment& field = instance_->environment();
  const double x_limit = field.field_length / 2 + field.border_strip + rounding;
  const double y_limit = field.field_width / 2 + field.border_strip + rounding;
  const auto tasks = static_cast<std::int64_t>(frame.tasks.count);
  const auto robots = static_cast<std::int64_t>(field.team_size);
  for (std::uint32_t i = 0; i < count; ++i) {
    const regista_waypoint& p = points_.data()[i];
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

void Positioner::check_edges(std::uint32_t count, std::uint32_t point_count) const {
  for (std::uint32_t i = 0; i < count; ++i) {
    const regista_edge& edge = edges_.data()[i];
    if (edge.from >= point_count || edge.to >= point_count) [[unlikely]] {
      instance_->fail("place", fmt::format("edge {} joins points {} and {} of {}", i, edge.from, edge.to, point_count));
    }
  }
}

void Positioner::check_cells(std::uint32_t count, std::uint32_t vertex_count) const {
  for (std::uint32_t i = 0; i < vertex_count; ++i) {
    const regista_vertex& vertex = vertices_.data()[i];
    if (!std::isfinite(vertex.x) || !std::isfinite(vertex.y)) [[unlikely]] {
      instance_->fail("place", fmt::format("vertex {} is at ({}, {})", i, vertex.x, vertex.y));
    }
  }
  for (std::uint32_t i = 0; i < count; ++i) {
    const regista_cell& cell = cells_.data()[i];
    if (cell.robot < 1 || static_cast<std::uint32_t>(cell.robot) > instance_->environment().team_size) [[unlikely]] {
      instance_->fail(
          "place", fmt::format("cell {} belongs to robot {} of {}", i, cell.robot, instance_->environment().team_size));
    }
    if (cell.first > vertex_count || cell.count > vertex_count - cell.first) [[unlikely]] {
      instance_->fail("place", fmt::format("cell {} has {} vertices from {} on, but there are {}", i, cell.count,
                                           cell.first, vertex_count));
    }
    double twice_area = 0.0;
    for (std::uint32_t k = 0; k < cell.count; ++k) {
      const regista_vertex& a = vertices_.data()[cell.first + k];
      const regista_vertex& b = vertices_.data()[cell.first + (k + 1 == cell.count ? 0 : k + 1)];
      twice_area += a.x * b.y - b.x * a.y;
    }
    if (twice_area < -rounding) [[unlikely]]
      instance_->fail("place", fmt::format("cell {} runs clockwise", i));
  }
}

}  // namespace regista::plugin
