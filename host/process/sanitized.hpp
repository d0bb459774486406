// SPDX-License-Identifier: MIT
// Whether the program was built with the address sanitizer, which reserves most addresses, catches fatal signals itself
// and makes matches ten times slower.
#pragma once

#include <dlfcn.h>

#if defined(__SANITIZE_ADDRESS__)  // GCC's name for it
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

// Whether an address sanitizer reserves the addresses of this process: that of this program, or one that a user has
// loaded first for a plugin.
inline bool addresses_are_reserved() { return sanitized || ::dlsym(RTLD_DEFAULT, "__asan_init") != nullptr; }

}  // namespace regista
