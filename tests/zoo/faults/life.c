/* SPDX-License-Identifier: MIT
 *
 * Faults outside of any answer: when the file is opened and closed, and in create and destroy. The build says which
 * function is called when: ZOO_AT_LOAD, ZOO_AT_UNLOAD, ZOO_AT_CREATE, ZOO_AT_DESTROY. */
#include <stdlib.h>
#include <unistd.h>

#include "zoo.h"

static volatile int for_ever = 1;

void crash(void) {
  volatile int* volatile nothing = NULL;
  *nothing = 1;
}

void leave(void) { exit(0); }

void hang(void) {
  while (for_ever) {
  }
}

void sleep_on(void) {
  while (for_ever) pause();
}

#ifdef ZOO_AT_LOAD
__attribute__((constructor)) static void load(void) { ZOO_AT_LOAD(); }
#endif

#ifdef ZOO_AT_UNLOAD
__attribute__((destructor)) static void unload(void) { ZOO_AT_UNLOAD(); }
#endif

void none(zoo_moment* now) { (void)now; }
