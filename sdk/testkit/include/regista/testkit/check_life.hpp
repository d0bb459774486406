// SPDX-License-Identifier: MIT
// The life of instances: created and destroyed at once, reset again and again, many side by side, destroyed in any
// order.
#pragma once

#include <vector>

#include <regista/testkit/course.hpp>

namespace regista::testkit {

Findings check_life(const Loaded& plugin, const Options& options, const std::vector<Course>& courses);

}  // namespace regista::testkit
