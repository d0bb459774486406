/* SPDX-License-Identifier: MIT
 *
 * A utility: one over one plus the distance in steps of two metres. */
#include <math.h>

#include "zoo.h"

static int32_t score(void* instance, const regista_frame* frame, const regista_matrix_room* out, regista_error* error) {
  zoo_moment now = zoo_now((zoo_instance*)instance, frame, error);
  const regista_world* world = zoo_world(frame);
  const char* const active = (const char*)world->active.data;
  const char* const robots = (const char*)world->robots.data;
  const char* const tasks = (const char*)frame->tasks.data;
  for (uint32_t i = 0; i < out->rows; ++i) {
    const int32_t number = *(const int32_t*)(active + (size_t)i * world->active.stride);
    const regista_robot* robot = (const regista_robot*)(robots + (size_t)(number - 1) * world->robots.stride);
    for (uint32_t j = 0; j < out->columns; ++j) {
      const regista_task* task = (const regista_task*)(tasks + (size_t)j * frame->tasks.stride);
      const double distance = hypot(task->after[0] - robot->pose[0], task->after[1] - robot->pose[1]);
      out->values[i * out->stride + j] = 1.0 / (1.0 + distance / 2.0);
    }
  }
  now.answer = out->values;
  now.past[ZOO_ANSWER] = out->values + (size_t)(out->rows - 1) * out->stride + out->columns;
  ZOO_FAULT(&now);
  return now.status;
}

static const regista_utility calls = {sizeof(regista_utility), 0, score};
const int32_t zoo_kind = REGISTA_KIND_UTILITY;
const void* const zoo_calls = &calls;
