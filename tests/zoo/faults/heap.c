/* SPDX-License-Identifier: MIT
 *
 * Damages the heap that it shares with everybody. */
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "zoo.h"

/* The compiler would see through a plain pointer, and refuse. */
static char* volatile block;

void frees_twice(zoo_moment* now) {
  if (now->asked != ZOO_WHEN) return;
  block = malloc(4096);
  free(block);
  free(block);
}

void writes_after_free(zoo_moment* now) {
  if (now->asked != ZOO_WHEN) return;
  for (size_t size = 16; size <= 512; size += 16) {
    block = malloc(size);
    free(block);
    memset(block, 0x5a, 16);
  }
}

void frees_what_is_the_hosts(zoo_moment* now) {
  if (now->asked == ZOO_WHEN) free((void*)(uintptr_t)now->frame);
}

void frees_a_part(zoo_moment* now) {
  if (now->asked != ZOO_WHEN) return;
  block = malloc(4096);
  block += 24;
  free(block);
}

void writes_before_its_block(zoo_moment* now) {
  if (now->asked != ZOO_WHEN) return;
  block = malloc(100);
  block -= 16;
  memset(block, 0x5a, 16);
  block += 16;
  free(block);
}

void writes_far_past_its_block(zoo_moment* now) {
  if (now->asked != ZOO_WHEN) return;
  block = malloc(100);
  memset(block, 0x5a, 65536);
}
