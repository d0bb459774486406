// SPDX-License-Identifier: MIT
// The contract of behaviours: regista_behaviour in <regista/abi.h>.
#pragma once

#include <vector>

#include <regista/testkit/rehearsal.hpp>

namespace regista::testkit {

std::vector<Rehearsal> behaviour_rehearsals(const Options& options);

}  // namespace regista::testkit
