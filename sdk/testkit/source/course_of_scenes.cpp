// SPDX-License-Identifier: MIT
// One step is one scene, shown as it is asked for.
#include <regista/testkit/course_of_scenes.hpp>

#include <regista/testkit/scenes.hpp>

namespace regista::testkit {

Course course_of_scenes(int size, const char* call, const std::vector<Scene>& course,
                        const std::function<void(Instance&, const Scene&, std::size_t, Findings&, Trail&)>& play) {
  Course r;
  r.environment = EnvironmentBuilder{}.team_size(static_cast<unsigned>(size)).own(own_number(size));
  r.steps = course.size();
  r.name = [course](std::size_t i) { return course[i].name(); };
  r.play = [course, call, play](Instance& instance, std::size_t i, const Showing& showing, Findings& findings,
                                Trail& trail) {
    const Scene scene = course[i].shown(showing);
    play(instance, scene, i, findings, trail);
    if (!scene.unchanged()) findings.say(call, ": wrote to its input");
  };
  return r;
}

}  // namespace regista::testkit
