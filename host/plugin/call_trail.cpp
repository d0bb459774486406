// SPDX-License-Identifier: MIT
#include "plugin/call_trail.hpp"

#include <xxhash.h>

namespace regista::plugin {

std::uint64_t AnswerDigest::value() const { return XXH3_64bits(bytes_.data(), bytes_.size()); }

}  // namespace regista::plugin
