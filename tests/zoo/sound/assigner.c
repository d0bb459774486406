/* SPDX-License-Identifier: MIT
 *
 * An assigner: each robot takes the first task that is open to it. */
#include <math.h>

#include "zoo.h"

static int taken(const int32_t* out, uint32_t rows, int32_t column) {
  for (uint32_t i = 0; i < rows; ++i) {
    if (out[i] == column) return 1;
  }
  return 0;
}

static int32_t assign(void* instance, const regista_frame* frame, const regista_matrix* u, int32_t* out,
                      regista_error* error) {
  zoo_moment now = zoo_now((zoo_instance*)instance, frame, error);
  for (uint32_t i = 0; i < u->rows; ++i) {
    for (uint32_t j = 0; j < u->columns && out[i] == REGISTA_NO_TASK; ++j) {
      if (u->values[i * u->stride + j] == -INFINITY || taken(out, i, (int32_t)j)) continue;
      out[i] = (int32_t)j;
    }
  }
  now.utilities = *u;
  now.answer = out;
  now.past[ZOO_ANSWER] = out + u->rows;
  ZOO_FAULT(&now);
  return now.status;
}

static const regista_assigner calls = {sizeof(regista_assigner), 0, assign};
const int32_t zoo_kind = REGISTA_KIND_ASSIGNER;
const void* const zoo_calls = &calls;
