// SPDX-License-Identifier: MIT
// The contract of assigners: regista_assigner in <regista/abi.h>.
#pragma once

#include <vector>

#include <regista/testkit/course.hpp>

namespace regista::testkit {

std::vector<Course> assigner_courses(const Options& options);

}  // namespace regista::testkit
