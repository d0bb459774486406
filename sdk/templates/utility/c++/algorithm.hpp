// SPDX-License-Identifier: MIT
// How good it is to be near. Knows nothing of Regista, so that it can be tested and used alone.
#pragma once

// In (0, 1]: 1 at the distance 0, a half at `half_at`. distance >= 0 and half_at > 0, both in m.
inline double nearness(double distance, double half_at) { return half_at / (half_at + distance); }
