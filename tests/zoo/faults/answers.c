/* SPDX-License-Identifier: MIT
 *
 * Answers what it promised not to. */
#include <math.h>
#include <string.h>

#include "zoo.h"

void is_no_number(zoo_moment* now) {
  if (now->asked == ZOO_WHEN) *(double*)now->answer = (double)NAN;
}

void gives_a_column_that_is_none(zoo_moment* now) {
  if (now->asked >= ZOO_WHEN && now->utilities.rows > 0) *(int32_t*)now->answer = (int32_t)now->utilities.columns + 2;
}

void is_neither_true_nor_false(zoo_moment* now) {
  if (now->asked == ZOO_WHEN) *(int32_t*)now->answer = 5;
}

void returns_another_status(zoo_moment* now) {
  if (now->asked == ZOO_WHEN) now->status = 77;
}

/* Fails with a text that has no end. */
void fails_at_length(zoo_moment* now) {
  if (now->asked != ZOO_WHEN) return;
  memset(now->error->text, 'x', sizeof now->error->text);
  now->status = REGISTA_FAILED;
}
