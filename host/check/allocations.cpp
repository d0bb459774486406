// SPDX-License-Identifier: MIT
#include "check/allocations.hpp"

#include "process/sanitized.hpp"

#ifndef REGISTA_SANITIZED
#include <regista/testkit/count_allocations.hpp>
#endif

namespace regista::check {

std::size_t (*count_allocations())() {
#ifdef REGISTA_SANITIZED
  return nullptr;
#else
  testkit::counting = true;
  return [] { return testkit::allocations; };
#endif
}

}  // namespace regista::check
