// SPDX-License-Identifier: GPL-3.0-or-later
// Positioner plugin around algorithm.hpp: the opponents of the chosen world, the field of the environment;
// around team_cells.hpp: the active robots of that world.
#include <algorithm>
#include <cstdint>
#include <initializer_list>
#include <optional>
#include <vector>

#include <regista/positioner.hpp>

#include "algorithm.hpp"
#include "team_cells.hpp"

namespace {

using voronoi::Settings;

struct Voronoi {
  static constexpr auto id = "voronoi", version = "1.2.0", licence = "GPL-3.0-or-later",
                        summary = "Nodes and edges of the Voronoi diagram of the opponents";
  static constexpr unsigned reads = REGISTA_READS_OPPONENTS_MINE | REGISTA_READS_OPPONENTS_COMMON;
  Settings settings = standard();
  bool opponents_are_sites = true, field_corners = true, halfway_ends = true, opponent_posts = true, own_goal = false;
  double drop_beyond = 1.0, inset = 0.15;
  bool cells = false;
  static constexpr std::tuple parameters{
      regista::boolean("opponents", &Voronoi::opponents_are_sites,
                       "Sites: the opponents inside the lines, as the paper"),
      regista::boolean("field_corners", &Voronoi::field_corners,
                       "Sites: the four corners of the field; SPQR 2023, which the paper does not name"),
      regista::boolean("halfway_ends", &Voronoi::halfway_ends,
                       "Sites: both ends of the halfway line; SPQR 2023, which the paper does not name"),
      regista::boolean("opponent_posts", &Voronoi::opponent_posts,
                       "Sites: the posts of the opponent's goal; SPQR 2023, which the paper does not name"),
      regista::boolean("own_goal", &Voronoi::own_goal, "Sites: the middle of the own goal; our option"),
      regista::within(&Voronoi::settings,
                      regista::real("merge", &Settings::merge, {0.0, 5.0}, "m",
                                    "Nodes nearer to each other than this become one, in their middle; SPQR 2023: 0.75")
                          .tunable(),
                      regista::real("clearance", &Settings::clearance, {0.0, 5.0}, "m",
                                    "Edges that pass an opponent nearer than this are dropped; SPQR 2023: 0.75")
                          .tunable()),
      regista::real("drop_beyond", &Voronoi::drop_beyond, {0.0, 10.0}, "m",
                    "Nodes farther than this outside the lines are dropped; SPQR 2023: 1.0 (5.5 and 4.0 of 9 by 6)"),
      regista::real("inset", &Voronoi::inset, {0.0, 2.0}, "m",
                    "The other nodes are moved this far inside the lines; SPQR 2023: 0.15 (4.35 and 2.85 of 9 by 6)"),
      regista::within(&Voronoi::settings,
                      regista::real("full_score", &Settings::full_score, {0.1, 20.0}, "m",
                                    "Distance from the nearest opponent at which a node's score reaches 1; our choice")
                          .tunable(),
                      regista::boolean("boundary", &Settings::boundary,
                                       "Also nodes where an edge of the diagram leaves the field; our option"),
                      regista::real("at_least", &Settings::at_least, {0.0, 1.0}, "m",
                                    "Nodes stay until an opponent has moved so far; 0: until any has moved at all; "
                                    "ours, for speed: play did not differ")),
      regista::boolean("cells", &Voronoi::cells,
                       "Also the Voronoi cell of each active robot among its team, clipped to the lines; our option")};

  static Settings standard() {
    Settings out;
    out.at_least = 0.05;
    return out;
  }

  std::optional<voronoi::Diagram> diagram;
  std::vector<voronoi::Point> opponents;
  voronoi::TeamCells team_cells;

  void setup(const regista::Environment& environment) {
    const double x = environment->field_length / 2.0, y = environment->field_width / 2.0;
    settings.sites = {x, y};
    settings.keep = {x + drop_beyond, y + drop_beyond};
    settings.clip = {std::max(0.0, x - inset), std::max(0.0, y - inset)};
    settings.fixed.clear();
    const auto add = [this](std::initializer_list<voronoi::Point> sites) {
      settings.fixed.insert(settings.fixed.end(), sites);
    };
    if (field_corners) add({{-x, -y}, {-x, y}, {x, -y}, {x, y}});
    if (halfway_ends) add({{0.0, -y}, {0.0, y}});
    if (opponent_posts) add_posts(environment);
    if (own_goal) add({{-x, 0.0}});
    diagram.emplace(settings);
    opponents.reserve(32);
    if (cells) team_cells.setup(environment);
  }

  void add_posts(const regista::Environment& environment) {
    bool known = false;
    for (const regista::Landmark& landmark : environment.landmarks()) {
      if (landmark.kind != REGISTA_LANDMARK_GOAL_POST || landmark.x <= 0.0) continue;
      settings.fixed.push_back({landmark.x, landmark.y});
      known = true;
    }
    if (known) return;
    for (const double side : {-1.0, 1.0}) {  // then the inner edges of the goal
      settings.fixed.push_back({environment->field_length / 2.0, side * environment->goal_width / 2.0});
    }
  }

  void reset(std::uint64_t) { diagram->reset(); }

  void place(const regista::Frame& frame, regista::Placement out) {
    opponents.clear();
    if (opponents_are_sites) {
      for (const regista::Opponent& opponent : frame.world().opponents()) {
        opponents.push_back({opponent.position[0], opponent.position[1]});
      }
    }
    const voronoi::Graph& graph = diagram->of(opponents);
    for (const voronoi::Node& node : graph.nodes) out.point(node.x, node.y, node.score);
    for (const voronoi::Edge& edge : graph.edges) {
      out.edge(static_cast<std::uint32_t>(edge.from), static_cast<std::uint32_t>(edge.to));
    }
    if (!cells) return;
    team_cells.each(frame.world(), [&out](std::int32_t number, const voronoi::Cell& cell) {
      voronoi::TeamCells::write(number, cell, out);
    });
  }
};

}  // namespace

REGISTA_PLUGIN(Voronoi, regista::positioner)
