// SPDX-License-Identifier: MIT
// The contract of positioners: regista_positioner in <regista/abi.h>.
#pragma once

#include <vector>

#include <regista/testkit/course.hpp>

namespace regista::testkit {

std::vector<Course> positioner_courses(const Options& options);

// With hardly any room a positioner may fail or place less, but it writes no further than it may.
Findings check_small_capacity(const Loaded& plugin, const Options& options);

}  // namespace regista::testkit
