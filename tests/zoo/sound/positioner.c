/* SPDX-License-Identifier: MIT
 *
 * A positioner: the ball, its mirror image, and the edge between them. */
#include "zoo.h"

static double within(double value, double limit) { return value < -limit ? -limit : value > limit ? limit : value; }

static int32_t place(void* instance, const regista_frame* frame, regista_placement* out, regista_error* error) {
  zoo_instance* self = (zoo_instance*)instance;
  zoo_moment now = zoo_now(self, frame, error);
  const regista_ball* ball = &zoo_world(frame)->ball;
  if ((ball->flags & REGISTA_BALL_KNOWN) != 0) {
    const double x = within(ball->position[0], self->x_limit), y = within(ball->position[1], self->y_limit);
    out->points[0] = (regista_waypoint){x, y, 1.0, -1, 0};
    out->points[1] = (regista_waypoint){x, -y, 0.5, -1, 0};
    out->point_count = 2;
    out->edges[0] = (regista_edge){0, 1};
    out->edge_count = 1;
  }
  now.answer = out->points;
  now.past[ZOO_ANSWER] = out->points + out->point_capacity;
  now.past[ZOO_EDGES] = out->edges + out->edge_capacity;
  now.past[ZOO_CELLS] = out->cells + out->cell_capacity;
  now.past[ZOO_VERTICES] = out->vertices + out->vertex_capacity;
  now.past[ZOO_STRUCTURE] = (unsigned char*)out + out->size;
  ZOO_FAULT(&now);
  return now.status;
}

static const regista_positioner calls = {sizeof(regista_positioner), 0, place};
const int32_t zoo_kind = REGISTA_KIND_POSITIONER;
const void* const zoo_calls = &calls;
