// SPDX-License-Identifier: GPL-3.0-or-later
// Positioner plugin around cells.hpp and cell_points.hpp: the cells of the active robots of the chosen world, and in
// each the point where its robot should be, bound to that robot.
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include <regista/positioner.hpp>

#include "cell_points.hpp"
#include "team_cells.hpp"

namespace {

enum class Target { centroid, best };

struct VoronoiCells {
  static constexpr auto id = "voronoi_cells", version = "1.0.0", licence = "GPL-3.0-or-later",
                        summary = "Voronoi cells of the own robots, each with its centroid or its best point";
  static constexpr unsigned reads = REGISTA_READS_OPPONENTS_MINE | REGISTA_READS_OPPONENTS_COMMON;
  Target target = Target::centroid;
  voronoi::Attraction attraction;
  static constexpr std::array target_names{"centroid", "best"};
  static constexpr std::tuple parameters{
      regista::choice("target", &VoronoiCells::target, target_names,
                      "Each cell's point: centroid, which spreads the team (Cortes et al. 2004), or the best by the "
                      "weights below"),
      regista::within(
          &VoronoiCells::attraction,
          regista::real("openness", &voronoi::Attraction::openness, {0.0, 1.0}, "1",
                        "Weight of the distance from the nearest opponent; assumption")
              .tunable(),
          regista::real("ball", &voronoi::Attraction::ball, {0.0, 1.0}, "1",
                        "Weight of nearness to the ball; assumption")
              .tunable(),
          regista::real("goal", &voronoi::Attraction::goal, {0.0, 1.0}, "1",
                        "Weight of nearness to the middle of the opponent's goal; assumption")
              .tunable(),
          regista::real("full_openness", &voronoi::Attraction::full_openness, {0.1, 20.0}, "m",
                        "Distance from the nearest opponent that counts fully; assumption, as full_score of voronoi")
              .tunable())};

  voronoi::TeamCells cells;
  voronoi::Point opponent_goal{};
  std::vector<voronoi::Point> opponents;

  void setup(const regista::Environment& environment) {
    cells.setup(environment);
    opponent_goal = {environment->field_length / 2.0, 0.0};
    attraction.reach = std::hypot(environment->field_length, environment->field_width);
    opponents.reserve(64);
  }

  void place(const regista::Frame& frame, regista::Placement out) {
    const regista::World world = frame.world();
    opponents.clear();
    for (const regista::Opponent& opponent : world.opponents()) {
      opponents.push_back({opponent.position[0], opponent.position[1]});
    }
    std::optional<voronoi::Point> where;
    if (world.ball_known()) where = voronoi::Point{world.ball().position[0], world.ball().position[1]};
    cells.each(world, [&](std::int32_t number, const voronoi::Cell& cell) {
      const voronoi::Candidate chosen = target == Target::centroid
                                            ? voronoi::Candidate{voronoi::centroid(cell), 1.0}
                                            : voronoi::best_point(cell, opponents, where, opponent_goal, attraction);
      out.point(chosen.at.x, chosen.at.y, chosen.value, -1, number);
      voronoi::TeamCells::write(number, cell, out);
    });
  }
};

}  // namespace

REGISTA_PLUGIN(VoronoiCells, regista::positioner)
