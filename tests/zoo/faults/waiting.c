/* SPDX-License-Identifier: MIT
 *
 * Takes time. */
#define _GNU_SOURCE
#include <time.h>
#include <unistd.h>

#include "zoo.h"

static volatile int for_ever = 1;

void never_answers(zoo_moment* now) {
  while (now->asked == ZOO_WHEN && for_ever) {
  }
}

void sleeps_for_ever(zoo_moment* now) {
  while (now->asked == ZOO_WHEN && for_ever) pause();
}

/* One robot's instance, so that a short match lasts for seconds, not for minutes. */
void sleeps_a_little(zoo_moment* now) {
  const struct timespec little = {0, 50000000};
  if (now->asked >= ZOO_WHEN && now->robot == 1) nanosleep(&little, NULL);
}
