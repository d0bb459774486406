// SPDX-License-Identifier: MIT
// One step is one scene, as it is or as a later host would lay it out.
#include <regista/testkit/rehearse_scenes.hpp>

namespace regista::testkit {

Rehearsal rehearse_scenes(int size, const char* call, const std::vector<Scene>& course,
                          const std::function<void(Instance&, const Scene&, std::size_t, Findings&, Trail&)>& play) {
  std::vector<Scene> later;
  for (const Scene& scene : course) later.push_back(scene.grown({24}));
  Rehearsal r;
  r.environment = EnvironmentBuilder{}.team_size(static_cast<unsigned>(size)).own(2);
  r.steps = course.size();
  r.name = [course](std::size_t i) { return course[i].name(); };
  r.play = [course, later, call, play](Instance& instance, std::size_t i, Growth growth, Findings& findings,
                                       Trail& trail) {
    const Scene& scene = (growth.bytes == 0 ? course : later)[i];
    play(instance, scene, i, findings, trail);
    if (!scene.unchanged()) findings.say(call, ": wrote to its input");
  };
  return r;
}

}  // namespace regista::testkit
