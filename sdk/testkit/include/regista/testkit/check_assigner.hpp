// SPDX-License-Identifier: MIT
// The contract of assigners: regista_assigner in <regista/abi.h>.
#pragma once

#include <vector>

#include <regista/testkit/rehearsal.hpp>

namespace regista::testkit {

std::vector<Rehearsal> assigner_rehearsals(const Options& options);

}  // namespace regista::testkit
