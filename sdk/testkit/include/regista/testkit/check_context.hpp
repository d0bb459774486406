// SPDX-License-Identifier: MIT
// The contract of contexts: regista_context in <regista/abi.h>.
#pragma once

#include <vector>

#include <regista/testkit/rehearsal.hpp>

namespace regista::testkit {

std::vector<Rehearsal> context_rehearsals(const Options& options);

}  // namespace regista::testkit
