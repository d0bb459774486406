// SPDX-License-Identifier: MIT
// Says whether this program has the address sanitizer, with which a call takes about twenty times as long.
#pragma once

namespace regista::testkit {

#if defined(__SANITIZE_ADDRESS__)  // macro of GCC
inline constexpr bool sanitized = true;
#elif defined(__has_feature)
inline constexpr bool sanitized = __has_feature(address_sanitizer);
#else
inline constexpr bool sanitized = false;
#endif

}  // namespace regista::testkit
