/* SPDX-License-Identifier: MIT
 *
 * Writes past the end of a buffer that the host lent. The build says which, ZOO_BUFFER, and how far, ZOO_BYTES. */
#include <string.h>

#include "zoo.h"

#ifndef ZOO_BUFFER
#define ZOO_BUFFER ZOO_ANSWER
#endif
#ifndef ZOO_BYTES
#define ZOO_BYTES 4
#endif

void writes_past_the_end(zoo_moment* now) {
  static int written; /* once for each process: a single accident is the hardest to find */
  if (now->asked < ZOO_WHEN || written || now->past[ZOO_BUFFER] == NULL) return;
  written = 1;
  memset(now->past[ZOO_BUFFER], 0x5a, ZOO_BYTES);
}
