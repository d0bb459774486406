// SPDX-License-Identifier: MIT
// A context answers yes or no, before there are tasks.
#include <regista/testkit/check_context.hpp>

#include <regista/testkit/course_of_scenes.hpp>
#include <regista/testkit/scenes.hpp>

namespace regista::testkit {

std::vector<Course> context_courses(const Options& options) {
  std::vector<Course> out;
  for (const int size : team_sizes) {
    std::vector<Scene> course;
    for (const Scene& scene : scenes(size, options.seed)) {
      course.push_back(scene.before_tasks());
    }
    const auto play = [](Instance& instance, const Scene& scene, std::size_t, Findings& findings, Trail& trail) {
      const std::int32_t answer = instance.holds(scene);
      trail.add(answer);
      if (answer != 0 && answer != 1) findings.say("holds: answered ", answer, ", neither 0 nor 1");
    };
    out.push_back(course_of_scenes(size, "holds", course, play));
  }
  return out;
}

}  // namespace regista::testkit
