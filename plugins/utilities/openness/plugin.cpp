// SPDX-License-Identifier: MIT
// Utility plugin around algorithm.hpp: the tasks after their offset, against the chosen world's opponents. It says
// something of a task and nothing of a robot, so that a column has one value: it decides which tasks are done where
// there are more of them than robots, by an assigner that weighs the sum.
#include <cmath>
#include <vector>

#include <regista/utility.hpp>

#include "../frame_places.hpp"
#include "algorithm.hpp"

namespace {

struct Openness {
  static constexpr auto id = "openness", version = "1.0.0",
                        summary = "How free of opponents the task is, and the lines of a pass and a shot through it";
  static constexpr unsigned reads = REGISTA_READS_OPPONENTS_MINE | REGISTA_READS_OPPONENTS_COMMON;
  openness::Settings settings;
  double likely = 0.5;
  static constexpr regista::Range share{0.0, 1.0}, metres{0.05, 20.0};
  static constexpr std::tuple parameters{
      regista::within(
          &Openness::settings,
          regista::real("target_share", &openness::Settings::target_share, share, "1",
                        "Share of the target's freedom in the score; our choice")
              .tunable(),
          regista::real("pass_share", &openness::Settings::pass_share, share, "1",
                        "Share of the freedom of the line from the ball to the target; our choice")
              .tunable(),
          regista::real(
              "shot_share", &openness::Settings::shot_share, share, "1",
              "Share of the freedom of the line from the target to the opponent's goal, where who stands in the "
              "goal area does not count; our choice")
              .tunable(),
          regista::real(
              "target_clearance", &openness::Settings::target_clearance, metres, "m",
              "A target is free when no opponent is so near; our choice, the reach of SPQR's numbers near the ball")
              .tunable(),
          regista::real("line_clearance", &openness::Settings::line_clearance, metres, "m",
                        "A line is free when no opponent is so near; 0.75 as for SPQR's Voronoi edges")
              .tunable()),
      regista::real("likely", &Openness::likely, {0.0, 1.0}, "1",
                    "Opponents whose existence is less probable do not count; our choice")
          .tunable()};

  std::vector<openness::Point> opponents, blockers;
  places::TargetList targets;
  std::vector<double> scores;
  double goal_line = 0.0, area_line = 0.0, area_side = 0.0;

  void setup(const regista::Environment& environment) {
    const std::size_t tasks = environment.roles().size();
    targets.reserve(tasks);
    scores.reserve(tasks);
    constexpr std::size_t most = 64;  // more than a world has; only memory depends on it
    opponents.reserve(most);
    blockers.reserve(most);
    goal_line = environment->field_length / 2.0;
    area_line = goal_line - environment->goal_area_length;
    area_side = environment->goal_area_width / 2.0;
  }
  void score(const regista::Frame& frame, regista::Utilities out) {
    const regista::World world = frame.world();
    opponents.clear();
    blockers.clear();
    for (const regista::Opponent& opponent : world.opponents()) {
      if (opponent.weight < likely) continue;
      const openness::Point point{opponent.position[0], opponent.position[1]};
      opponents.push_back(point);
      // The goalkeeper stands near every line to its goal.
      if (point.x < area_line || std::abs(point.y) > area_side) blockers.push_back(point);
    }
    targets.read_tasks(frame);
    openness::Scene scene{opponents, blockers, std::nullopt, {goal_line, 0.0}};
    if (world.ball_known()) scene.ball = openness::Point{world.ball().position[0], world.ball().position[1]};
    scores.resize(targets.size());
    openness::score(targets, scene, settings, scores);
    for (std::size_t i = 0; i < out.rows(); ++i) std::ranges::copy(scores, out.data() + i * out.stride());
  }
};

}  // namespace

REGISTA_PLUGIN(Openness, regista::utility)
