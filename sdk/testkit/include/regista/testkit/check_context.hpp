// SPDX-License-Identifier: MIT
// The contract of contexts: regista_context in <regista/abi.h>.
#pragma once

#include <vector>

#include <regista/testkit/course.hpp>

namespace regista::testkit {

std::vector<Course> context_courses(const Options& options);

}  // namespace regista::testkit
