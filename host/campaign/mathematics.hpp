// SPDX-License-Identifier: MIT
// A fingerprint of the mathematics library: its results differ in the last digit between versions and, because it
// chooses its code by the processor it finds, between families of processors.
#pragma once

#include <string>

namespace regista::campaign {

// Version of the C library and a hash over the bits of what its functions return at a few hundred points.
std::string mathematics_fingerprint();

}  // namespace regista::campaign
