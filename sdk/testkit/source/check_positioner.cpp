// SPDX-License-Identifier: MIT
// Points, edges and cells: on the field, sound among each other, within the room there is.
#include <regista/testkit/kind_checks.hpp>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>

#include <regista/testkit/scenario.hpp>
#include <regista/testkit/scenes.hpp>

namespace regista::testkit {

namespace {

struct Lawn {  // half sizes, with the border strip
  double x, y;
  bool has(double px, double py) const { return std::abs(px) <= x + 1e-9 && std::abs(py) <= y + 1e-9; }
};

void check_points(const Placed& placed, const Lawn& lawn, const Scene& scene, Findings& findings) {
  const auto tasks = static_cast<std::int32_t>(scene.columns()), robots = static_cast<std::int32_t>(scene.team_size());
  for (std::size_t i = 0; i < placed.points.size(); ++i) {
    const regista_waypoint& p = placed.points[i];
    if (!lawn.has(p.x, p.y)) findings.say("place: point ", i, " at (", p.x, ", ", p.y, ") is outside the field");
    if (!std::isfinite(p.score) || p.score < 0.0) findings.say("place: point ", i, " has the score ", p.score);
    if (p.task < -1 || p.task >= tasks) findings.say("place: point ", i, " names task ", p.task, " of ", tasks);
    if (p.robot < 0 || p.robot > robots) findings.say("place: point ", i, " names robot ", p.robot, " of ", robots);
  }
}

void check_edges(const Placed& placed, Findings& findings) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> seen;
  for (std::size_t i = 0; i < placed.edges.size(); ++i) {
    const regista_edge& e = placed.edges[i];
    if (e.from >= placed.points.size() || e.to >= placed.points.size()) {
      findings.say("place: edge ", i, " from ", e.from, " to ", e.to, " with only ", placed.points.size(), " points");
    } else if (e.from == e.to) {
      findings.say("place: edge ", i, " leads from point ", e.from, " to itself");
    } else if (!seen.insert(std::minmax(e.from, e.to)).second) {
      findings.say("place: the edge between points ", e.from, " and ", e.to, " stands twice");
    }
  }
}

void check_cells(const Placed& placed, const Lawn& lawn, const Scene& scene, Findings& findings) {
  std::set<std::int32_t> owners;
  for (const regista_cell& c : placed.cells) {
    if (c.robot < 1 || c.robot > static_cast<std::int32_t>(scene.team_size())) {
      findings.say("place: a cell belongs to robot ", c.robot, " of ", scene.team_size());
    } else if (!owners.insert(c.robot).second) {
      findings.say("place: robot ", c.robot, " has two cells");
    }
    if (c.first > placed.vertices.size() || c.count > placed.vertices.size() - c.first) {
      findings.say("place: the cell of robot ", c.robot, " has vertices past the end");
      continue;
    }
    double twice_area = 0.0;
    for (std::uint32_t k = 0; k < c.count; ++k) {
      const regista_vertex& a = placed.vertices[c.first + k];
      const regista_vertex& b = placed.vertices[c.first + (k + 1) % c.count];
      if (!lawn.has(a.x, a.y)) findings.say("place: the cell of robot ", c.robot, " leaves the field");
      twice_area += a.x * b.y - a.y * b.x;
    }
    if (twice_area < -1e-9) findings.say("place: the cell of robot ", c.robot, " is not counter-clockwise");
  }
}

}  // namespace

std::vector<Scenario> positioner_scenarios(const Options& options) {
  std::vector<Scenario> out;
  for (const int size : team_sizes) {
    std::vector<Scene> scenario;
    for (const Scene& scene : scenes(size, options.seed)) {
      scenario.push_back(scene.before_placing());
    }
    EnvironmentBuilder environment;
    const regista_environment& e = environment.team_size(static_cast<unsigned>(size)).own(own_number(size)).raw();
    const Lawn lawn{e.field_length / 2 + e.border_strip, e.field_width / 2 + e.border_strip};
    const auto play = [lawn](Instance& instance, const Scene& scene, std::size_t, Findings& findings, Trail& trail) {
      const Placed placed = instance.place(scene);
      trail.add_all(placed.points);
      trail.add_all(placed.edges);
      trail.add_all(placed.cells);
      trail.add_all(placed.vertices);
      check_points(placed, lawn, scene, findings);
      check_edges(placed, findings);
      check_cells(placed, lawn, scene, findings);
    };
    out.push_back(scenario_of_scenes(size, "place", scenario, play));
  }
  return out;
}

Findings check_small_capacity(const Loaded& plugin, const Options& options) {
  return detail::everywhere(
      plugin, options, positioner_scenarios(options),
      [&](const Corner& corner, const Scenario& scenario, Findings& findings) {
        Instance instance(plugin, scenario.environment, corner.values);
        const int size = static_cast<int>(EnvironmentBuilder(scenario.environment).raw().team_size);
        for (const Scene& scene : scenes(size, options.seed)) {
          findings.where(corner.name, scene.name());
          for (const std::uint32_t room : {0u, 1u, 3u}) {
            try {
              (void)instance.place(scene.before_placing(), {room, room, room, room, room});
            } catch (const CallFailed& failure) {
              const std::string text = failure.what();
              if (text.find("past the") != std::string::npos || text.find("says ") != std::string::npos ||
                  text.find("across the boundary") != std::string::npos) {
                findings.say(text);
              }
            }
          }
        }
      });
}

}  // namespace regista::testkit
