// SPDX-License-Identifier: MIT
// Says whether this program has the address sanitizer. The sanitizer reserves most addresses, handles fatal signals
// itself and makes matches ten times slower.
#pragma once

#include <dlfcn.h>

#if defined(__SANITIZE_ADDRESS__)  // macro of GCC
#define REGISTA_SANITIZED
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define REGISTA_SANITIZED
#endif
#endif

namespace regista {

#ifdef REGISTA_SANITIZED
inline constexpr bool sanitized = true;
#else
inline constexpr bool sanitized = false;
#endif

// Returns whether an address sanitizer reserves addresses of this process. The sanitizer may be that of this program,
// or one that a user has preloaded for a plugin.
inline bool addresses_are_reserved() { return sanitized || ::dlsym(RTLD_DEFAULT, "__asan_init") != nullptr; }

}  // namespace regista
