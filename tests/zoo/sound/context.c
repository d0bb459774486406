/* SPDX-License-Identifier: MIT
 *
 * A context: holds where someone knows where the ball is. */
#include "zoo.h"

static int32_t holds(void* instance, const regista_frame* frame, int32_t* out, regista_error* error) {
  zoo_moment now = zoo_now((zoo_instance*)instance, frame, error);
  *out = (zoo_world(frame)->ball->flags & REGISTA_BALL_KNOWN) != 0;
  now.answer = out;
  now.past[ZOO_ANSWER] = out + 1;
  ZOO_FAULT(&now);
  return now.status;
}

static const regista_context calls = {sizeof(regista_context), 0, holds};
const int32_t zoo_kind = REGISTA_KIND_CONTEXT;
const void* const zoo_calls = &calls;
