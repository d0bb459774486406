// SPDX-License-Identifier: MIT
// Whether a plugin describes itself as abi.h asks.
#pragma once

#include <regista/testkit/findings.hpp>
#include <regista/testkit/loaded.hpp>

namespace regista::testkit {

Findings check_descriptor(const Loaded& plugin);

}  // namespace regista::testkit
