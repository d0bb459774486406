// SPDX-License-Identifier: MIT
// The contract of utilities: regista_utility in <regista/abi.h>.
#pragma once

#include <vector>

#include <regista/testkit/course.hpp>

namespace regista::testkit {

std::vector<Course> utility_courses(const Options& options);

// The same scores, but for rounding, when the opponents stand in another order. Not every utility promises it.
Findings check_order_of_opponents(const Loaded& plugin, const Options& options);

}  // namespace regista::testkit
