// SPDX-License-Identifier: MIT
// A context answers yes or no, before there are tasks.
#include <regista/testkit/kind_checks.hpp>

#include <regista/testkit/scenario.hpp>
#include <regista/testkit/scenes.hpp>

namespace regista::testkit {

std::vector<Scenario> context_scenarios(const Options& options) {
  std::vector<Scenario> out;
  for (const int size : team_sizes) {
    std::vector<Scene> scenario;
    for (const Scene& scene : scenes(size, options.seed)) {
      scenario.push_back(scene.before_tasks());
    }
    const auto play = [](Instance& instance, const Scene& scene, std::size_t, Findings& findings, Trail& trail) {
      const std::int32_t answer = instance.holds(scene);
      trail.add(answer);
      if (answer != 0 && answer != 1) findings.say("holds: answered ", answer, ", neither 0 nor 1");
    };
    out.push_back(scenario_of_scenes(size, "holds", scenario, play));
  }
  return out;
}

}  // namespace regista::testkit
