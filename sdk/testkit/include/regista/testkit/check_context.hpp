// SPDX-License-Identifier: MIT
// The contract of contexts: regista_context in <regista/abi.h>.
#pragma once

#include <vector>

#include <regista/testkit/rehearsal.hpp>
#include <regista/testkit/scenes.hpp>

namespace regista::testkit {

inline std::vector<Rehearsal> context_rehearsals(const Options&) {
  std::vector<Rehearsal> out;
  for (const int size : team_sizes) {
    std::vector<Scene> course, later;
    for (const Scene& scene : scenes(size)) {
      course.push_back(scene.before_tasks());
      later.push_back(course.back().grown({24}));
    }
    Rehearsal r;
    r.environment = EnvironmentBuilder{}.team_size(static_cast<unsigned>(size)).own(2);
    r.steps = course.size();
    r.name = [course](std::size_t i) { return course[i].name(); };
    r.play = [course, later](Instance& instance, std::size_t i, Growth growth, Findings& findings, Trail& trail) {
      const Scene& scene = (growth.bytes == 0 ? course : later)[i];
      const std::int32_t answer = instance.holds(scene);
      trail.add(answer);
      if (answer != 0 && answer != 1) findings.say("holds: answered ", answer, ", neither 0 nor 1");
      if (!scene.unchanged()) findings.say("holds: wrote to its input");
    };
    out.push_back(std::move(r));
  }
  return out;
}

}  // namespace regista::testkit
