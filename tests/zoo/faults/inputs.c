/* SPDX-License-Identifier: MIT
 *
 * Writes into what it was only to read, at one call in ten: a second play looks at one decision in thirteen. */
#include <stdint.h>

#include "zoo.h"

static int is_time(const zoo_moment* now) { return now->asked >= ZOO_WHEN && now->asked % 10 == 0; }

void moves_the_ball(zoo_moment* now) {
  if (is_time(now)) ((regista_ball*)(uintptr_t)now->frame->mine->ball)->position[0] += 1.0;
}

void moves_a_robot(zoo_moment* now) {
  if (is_time(now)) ((regista_robot*)(uintptr_t)now->frame->mine->robots.data)->pose[1] += 0.5;
}

void moves_the_clock(zoo_moment* now) {
  if (is_time(now)) ((regista_frame*)(uintptr_t)now->frame)->time += 60.0;
}

/* From then on, since at one call alone there may be nothing to raise. */
void raises_its_utility(zoo_moment* now) {
  if (now->asked < ZOO_WHEN || now->utilities.rows == 0 || now->utilities.columns == 0) return;
  *(double*)(uintptr_t)now->utilities.values += 0.25;
}
