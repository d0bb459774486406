// SPDX-License-Identifier: MIT
// A course through scenes, for the kinds whose calls read a frame.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include <regista/testkit/course.hpp>
#include <regista/testkit/scene.hpp>

namespace regista::testkit {

// For a team of `size`, of which this is robot own_number(size). play(instance, scene, index, findings, trail): one
// step, in which the scene may be of a later host or show less. call: what the step calls, for findings.
Course course_of_scenes(int size, const char* call, const std::vector<Scene>& course,
                        const std::function<void(Instance&, const Scene&, std::size_t, Findings&, Trail&)>& play);

}  // namespace regista::testkit
