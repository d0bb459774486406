// SPDX-License-Identifier: MIT
// The contract of senders: regista_sender in <regista/abi.h>.
#pragma once

#include <vector>

#include <regista/testkit/course.hpp>

namespace regista::testkit {

std::vector<Course> sender_courses(const Options& options);

}  // namespace regista::testkit
