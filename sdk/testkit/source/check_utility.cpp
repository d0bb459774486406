// SPDX-License-Identifier: MIT
// Scores are finite and not negative; opponents have no order.
#include <regista/testkit/kind_checks.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

#include <regista/testkit/scenario.hpp>
#include <regista/testkit/scenes.hpp>

namespace regista::testkit {

namespace {

void check_scores(const Matrix& scores, Findings& findings, Trail& trail) {
  for (std::size_t i = 0; i < scores.rows(); ++i) {
    for (std::size_t j = 0; j < scores.columns(); ++j) {
      const double value = scores(i, j);
      trail.add(value);
      if (!std::isfinite(value) || value < 0.0) findings.say("score: row ", i, ", column ", j, " is ", value);
    }
  }
}

Scene opponents_reversed(const Scene& scene) {
  SceneData data = scene.data();
  std::reverse(data.mine.opponents.begin(), data.mine.opponents.end());
  std::reverse(data.common.opponents.begin(), data.common.opponents.end());
  return Scene(std::move(data));
}

}  // namespace

std::vector<Scenario> utility_scenarios(const Options& options) {
  std::vector<Scenario> out;
  for (const int size : team_sizes) {
    std::vector<Scene> scenario;
    for (const Scene& scene : scenes(size, options.seed)) {
      if (scene.rows() == 0 || scene.columns() == 0) continue;  // never called then
      scenario.push_back(scene);
    }
    const auto play = [](Instance& instance, const Scene& scene, std::size_t, Findings& findings, Trail& trail) {
      check_scores(instance.score(scene), findings, trail);
    };
    out.push_back(scenario_of_scenes(size, "score", scenario, play));
  }
  return out;
}

Findings check_order_of_opponents(const Loaded& plugin, const Options& options) {
  return detail::everywhere(
      plugin, options, utility_scenarios(options),
      [&](const Corner& corner, const Scenario& scenario, Findings& findings) {
        Instance one(plugin, scenario.environment, corner.values), other(plugin, scenario.environment, corner.values);
        const int size = static_cast<int>(EnvironmentBuilder(scenario.environment).raw().team_size);
        for (const Scene& scene : scenes(size, options.seed)) {
          if (scene.rows() == 0 || scene.columns() == 0) continue;
          findings.where(corner.name, scene.name());
          const Matrix a = one.score(scene), b = other.score(opponents_reversed(scene));
          for (std::size_t i = 0; i < a.rows(); ++i) {
            for (std::size_t j = 0; j < a.columns(); ++j) {
              if (std::abs(a(i, j) - b(i, j)) > 1e-9 * std::max(1.0, std::abs(a(i, j)))) {
                findings.say("score: depends on the order in which the opponents are listed");
                return;
              }
            }
          }
        }
      });
}

}  // namespace regista::testkit
