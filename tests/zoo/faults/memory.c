/* SPDX-License-Identifier: MIT
 *
 * Takes memory. */
#include <stdlib.h>
#include <string.h>

#include "zoo.h"

void takes_without_end(zoo_moment* now) {
  while (now->asked == ZOO_WHEN) {
    char* const block = malloc((size_t)64 << 20);
    if (block == NULL) abort();
    memset(block, 1, (size_t)64 << 20);
  }
}

/* To the last byte, and goes on as if nothing were: who asks next gets none. */
void leaves_none_to_others(zoo_moment* now) {
  static int taken;
  if (now->asked != ZOO_WHEN || taken) return;
  taken = 1;
  for (size_t size = (size_t)64 << 20; size >= 16; size /= 2) {
    while (malloc(size) != NULL) {
    }
  }
}
