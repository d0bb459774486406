/* SPDX-License-Identifier: MIT
 *
 * A behaviour: walks to its task, and stands where it has none. */
#include <string.h>

#include "zoo.h"

static int32_t act(void* instance, const regista_frame* frame, const regista_body* body, regista_action* out,
                   regista_error* error) {
  zoo_moment now = zoo_now((zoo_instance*)instance, frame, error);
  if (body->task >= 0) {
    const char* const task = (const char*)frame->tasks.data + (size_t)body->task * frame->tasks.stride;
    out->motion = REGISTA_MOTION_WALK_TO;
    memcpy(out->pose, ((const regista_task*)task)->after, sizeof out->pose);
  }
  now.answer = out;
  now.past[ZOO_ANSWER] = (unsigned char*)out + out->size;
  ZOO_FAULT(&now);
  return now.status;
}

static const regista_behaviour calls = {sizeof(regista_behaviour), 0, act};
const int32_t zoo_kind = REGISTA_KIND_BEHAVIOUR;
const void* const zoo_calls = &calls;
