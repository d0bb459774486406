// SPDX-License-Identifier: MIT
// print_config_schema rules|robot|disturbance|opening|team|tuning [plugins]: the schema, for the validator's test. With
// the word "plugins", the schema knows the plugins of the fixtures.
#include <cstdio>
#include <cstring>
#include <vector>

#include "config/documents.hpp"

using namespace regista::config;

static std::vector<PluginDeclaration> fixture_plugins() {
  using Type = PluginParameter::Type;
  return {
      {"odometry_pose", "predictor", "", {}},
      {"kalman_ball",
       "predictor",
       "A ball that rolls",
       {{"deceleration", Type::real, 0.1, 1, "m/s^2", "of the ball", 0.3}}},
      {"gaussian_mixture", "predictor", "", {}},
      {"dead_reckoning", "predictor", "", {}},
      {"always", "context", "", {}},
      {"ball_lost", "context", "", {{"after", Type::real, 0, 60, "s", "unseen", 5}}},
      {"voronoi", "positioner", "", {{"merge", Type::real, 0, 5, "m", "nearer nodes", 0.5}}},
      {"distance", "utility", "", {}},
      {"persistence", "utility", "", {{.name = "for_robots", .type = Type::choice, .choices = {"own", "all"}}}},
      {"waypoint_proximity", "utility", "", {}},
      {"greedy", "assigner", "", {}},
      {"event_based",
       "sender",
       "",
       {{"reserve", Type::integer, 0, 1000, "packets", "kept back", 30},
        {"period", Type::real, 0, 600, "s", "at the latest", 10},
        {.name = "whistle", .type = Type::boolean, .initial = 1},
        {.name = "label", .type = Type::text},
        {.name = "weights", .type = Type::file}}},
  };
}

int main(int count, char** arguments) {
  if (count < 2) return 2;
  const std::vector<PluginDeclaration> plugins = count > 2 ? fixture_plugins() : std::vector<PluginDeclaration>{};
  for (const DocumentKind& kind :
       {DocumentKind::rules, DocumentKind::robot, DocumentKind::disturbance, DocumentKind::opening, DocumentKind::team,
        DocumentKind::tournament, DocumentKind::tuning}) {
    if (kind.name == arguments[1]) {
      std::fputs(schema(kind, plugins).c_str(), stdout);
      return 0;
    }
  }
  return 2;
}
