// SPDX-License-Identifier: MIT
// Utility plugin around algorithm.hpp: the distance of each active robot of the chosen world to the waypoint of each
// task. That is the waypoint that the positioner made for the task, or else the one that the host matched with it.
#include <vector>

#include <regista/utility.hpp>

#include "../frame_places.hpp"
#include "algorithm.hpp"

namespace {

struct WaypointDistance {
  static constexpr auto id = "waypoint_distance", version = "1.0.0",
                        summary = "Nearness of the robot to the waypoint of the task, straight or along the edges";
  static constexpr unsigned reads = REGISTA_READS_WAYPOINTS | REGISTA_READS_EDGES;
  waypoint_distance::Settings settings;
  static constexpr std::tuple parameters{regista::within(
      &WaypointDistance::settings,
      regista::real("reach", &waypoint_distance::Settings::reach, {0.5, 100.0}, "m",
                    "Distance from which on the utility is 0; as the distance to the task, SPQR 2022: 11")
          .tunable(),
      regista::boolean(
          "along_edges", &waypoint_distance::Settings::along_edges,
          "To the nearest waypoint, then along the edges, instead of straight; the paper gives no formula"))};

  std::vector<waypoint_distance::Point> robots, nodes;
  std::vector<waypoint_distance::Edge> edges;
  std::vector<std::size_t> node_of;
  waypoint_distance::Scorer scorer;

  void setup(const regista::Environment& environment) {
    robots.reserve(environment->team_size);
    constexpr std::size_t most_nodes = 64, most_edges = 192;  // more than there are; only memory depends on it
    nodes.reserve(most_nodes);
    edges.reserve(most_edges);
    scorer.reserve(environment->team_size, most_nodes, most_edges);
    node_of.reserve(environment.roles().size());
  }
  void score(const regista::Frame& frame, regista::Utilities out) {
    read_robots(frame.world(), robots);
    node_of.assign(frame.tasks().size(), waypoint_distance::no_node);
    nodes.clear();
    for (const regista::Waypoint& point : frame.waypoints()) {
      if (point.task >= 0 && point.robot == 0) node_of[static_cast<std::size_t>(point.task)] = nodes.size();
      nodes.push_back({point.x, point.y});
    }
    edges.clear();
    for (const regista::Edge& edge : frame.edges()) edges.push_back({edge.from, edge.to});
    scorer.score(robots, node_of, {nodes, edges}, settings, out.data(), out.stride());
  }
};

}  // namespace

REGISTA_PLUGIN(WaypointDistance, regista::utility)
