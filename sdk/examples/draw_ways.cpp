// SPDX-License-Identifier: MIT
// Example of the extension draw: a utility that prefers near tasks, and draws the way of each robot to the nearest one,
// its length beside it.
//
//   utility: {terms: {near: {plugin: draw_ways, weight: 0.1}}}      regista match a.yaml b.yaml --record match.mcap
#include <array>
#include <cmath>
#include <cstdio>

#include <regista/draw.hpp>
#include <regista/utility.hpp>

namespace {

struct DrawWays {
  static constexpr auto id = "draw_ways", version = "1.0.0",
                        summary = "The nearer, the better; draws the way of each robot to its nearest task";
  static constexpr unsigned reads = REGISTA_READS_NOTHING;

  regista::Draw draw;

  void setup(const regista::Environment&, const regista::Host& host) { draw = regista::Draw(host); }

  void score(const regista::Frame& frame, regista::Utilities out) {
    const regista::World world = frame.world();
    for (std::size_t row = 0; row < out.rows(); ++row) {
      const regista::Robot& robot = world.robot(world.active()[row]);
      double shortest = 1e9;
      std::array<regista::Point, 2> way{regista::Point{robot.pose[0], robot.pose[1]}};
      for (std::size_t column = 0; column < out.columns(); ++column) {
        const double* const place = frame.tasks()[column].after;
        const double distance = std::hypot(place[0] - robot.pose[0], place[1] - robot.pose[1]);
        out(row, column) = 1.0 / (1.0 + distance);
        if (distance >= shortest) continue;
        shortest = distance;
        way[1] = {place[0], place[1]};
      }
      if (!draw.wanted() || out.columns() == 0) continue;
      draw.line("ways", way, {.colour = 0xE69F00FF, .width = 0.03});
      std::array<char, 16> length{};
      std::snprintf(length.data(), length.size(), "%.1f m", shortest);
      draw.text("lengths", {(way[0].x + way[1].x) / 2.0, (way[0].y + way[1].y) / 2.0}, length.data());
    }
  }
};

}  // namespace

REGISTA_PLUGIN(DrawWays, regista::utility)
