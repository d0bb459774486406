// SPDX-License-Identifier: MIT
// Glue between the algorithm and Regista: what it is called, what can be set, which call it answers.
#include <vector>

#include <regista/positioner.hpp>

#include "algorithm.hpp"

namespace {

struct Plugin {
  static constexpr auto id = "@NAME@", version = "0.1.0", summary = "Points on a circle around the ball";
  // Of a frame it reads nothing but what every plugin is shown; see REGISTA_READS_* in <regista/abi.h>.
  static constexpr unsigned reads = REGISTA_READS_NOTHING;

  double radius = 1.5;
  int count = 6;
  static constexpr std::tuple parameters{
      regista::real("radius", &Plugin::radius, {0.2, 10.0}, "m", "Distance of the points from the ball").tunable(),
      regista::integer("count", &Plugin::count, {3, 24}, "1", "Number of the points on the circle")};

  Point edge;
  std::vector<Point> points;  // kept, so that only the first call allocates

  void setup(const regista::Environment& environment) {
    edge = {environment->field_length / 2.0, environment->field_width / 2.0};
  }

  void place(const regista::Frame& frame, regista::Placement out) {
    Point centre;  // of the field, while nobody knows the ball
    if (frame.world().ball_known()) {
      const regista::Ball& ball = frame.world().ball();
      centre = {ball.position[0], ball.position[1]};
    }
    ring(centre, radius, count, edge, points);
    for (const Point& each : points) out.point(each.x, each.y);
    out.point(-0.75 * edge.x, 0.0);  // without it, teams that keep the tasks nearest to points keep no defender
    for (int i = 0; i < count; ++i) out.edge(static_cast<unsigned>(i), static_cast<unsigned>((i + 1) % count));
  }
};

}  // namespace

REGISTA_PLUGIN(Plugin, regista::positioner)
