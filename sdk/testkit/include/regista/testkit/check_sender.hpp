// SPDX-License-Identifier: MIT
// The contract of senders: regista_sender in <regista/abi.h>.
#pragma once

#include <vector>

#include <regista/testkit/rehearsal.hpp>

namespace regista::testkit {

std::vector<Rehearsal> sender_rehearsals(const Options& options);

}  // namespace regista::testkit
