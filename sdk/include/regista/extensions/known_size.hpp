// SPDX-License-Identifier: MIT
// A struct that says its size, for a caller that may know less of it: hosts answer extensions so.
#pragma once

#include <algorithm>
#include <cstdint>
#include <cstring>

namespace regista {

// As much of `value` as *out has room for by its field `size`, which stays what fits. Null is let be.
template <class Struct>
void write_known(Struct value, Struct* out) {
  if (out == nullptr) return;
  value.size = std::min<std::uint32_t>(out->size, sizeof value);
  std::memcpy(static_cast<void*>(out), &value, value.size);
}

}  // namespace regista
