// SPDX-License-Identifier: MIT
// A course through scenes, for the kinds whose calls read a frame.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <regista/testkit/rehearsal.hpp>
#include <regista/testkit/scenes.hpp>

namespace regista::testkit {

// For a team of `size`, of which this is robot 2. play(instance, scene, index, findings, trail): one step, in which the
// scene may be of a later host. call: what the step calls, for findings.
template <class Play>
Rehearsal rehearse_scenes(int size, const char* call, const std::vector<Scene>& course, const Play& play) {
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
