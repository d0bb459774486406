/* SPDX-License-Identifier: MIT
 *
 * Changes how everybody's numbers are rounded. */
#define _GNU_SOURCE
#include <fenv.h>

#include "zoo.h"

void round_upward(void) { fesetround(FE_UPWARD); }

/* Subnormal numbers become 0: bits of the x86 register; elsewhere the rounding mode stands for it. */
void flush_to_zero(void) {
#if defined(__x86_64__)
  fenv_t environment;
  fegetenv(&environment);
  environment.__mxcsr |= 0x8040u;
  fesetenv(&environment);
#else
  fesetround(FE_UPWARD);
#endif
}

void trap(void) { feenableexcept(FE_DIVBYZERO | FE_INVALID | FE_INEXACT); }

#ifndef ZOO_CHANGE
#define ZOO_CHANGE round_upward
#endif

void changes_the_arithmetic(zoo_moment* now) {
  if (now->asked == ZOO_WHEN) ZOO_CHANGE();
}

#ifdef ZOO_WHEN_LOADED
__attribute__((constructor)) static void loaded(void) { ZOO_CHANGE(); }
#endif

void only_when_loaded(zoo_moment* now) { (void)now; }
