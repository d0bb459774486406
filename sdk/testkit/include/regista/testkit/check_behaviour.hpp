// SPDX-License-Identifier: MIT
// The contract of behaviours: regista_behaviour in <regista/abi.h>.
#pragma once

#include <vector>

#include <regista/testkit/course.hpp>

namespace regista::testkit {

std::vector<Course> behaviour_courses(const Options& options);

}  // namespace regista::testkit
