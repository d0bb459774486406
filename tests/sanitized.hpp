// SPDX-License-Identifier: MIT
// Whether a test was built with the address sanitizer, which makes matches ten times slower: it may then play fewer.
#pragma once

#if defined(__SANITIZE_ADDRESS__)
#define REGISTA_SANITIZED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define REGISTA_SANITIZED 1
#endif
#endif

namespace regista {

#ifdef REGISTA_SANITIZED
inline constexpr bool sanitized = true;
#else
inline constexpr bool sanitized = false;
#endif

}  // namespace regista
