/* SPDX-License-Identifier: MIT
 *
 * A positioner: the ball, its mirror image, and the edge between them, where there is room for all three. */
#include "zoo.h"

static double within(double value, double limit) { return value < -limit ? -limit : value > limit ? limit : value; }

static int32_t place(void* instance, const regista_frame* frame, regista_placement* out, regista_error* error) {
  zoo_instance* self = (zoo_instance*)instance;
  zoo_moment now = zoo_now(self, frame, error);
  const regista_ball* ball = zoo_world(frame)->ball;
  if ((ball->flags & REGISTA_BALL_KNOWN) != 0 && out->points.capacity >= 2 && out->edges.capacity >= 1) {
    const double x = within(ball->position[0], self->x_limit), y = within(ball->position[1], self->y_limit);
    *(regista_waypoint*)zoo_element(&out->points, 0) = (regista_waypoint){x, y, 1.0, -1, 0};
    *(regista_waypoint*)zoo_element(&out->points, 1) = (regista_waypoint){x, -y, 0.5, -1, 0};
    out->points.count = 2;
    *(regista_edge*)zoo_element(&out->edges, 0) = (regista_edge){0, 1};
    out->edges.count = 1;
  }
  now.answer = out->points.data;
  now.past[ZOO_ANSWER] = zoo_element(&out->points, out->points.capacity);
  now.past[ZOO_EDGES] = zoo_element(&out->edges, out->edges.capacity);
  now.past[ZOO_CELLS] = zoo_element(&out->cells, out->cells.capacity);
  now.past[ZOO_VERTICES] = zoo_element(&out->vertices, out->vertices.capacity);
  now.past[ZOO_STRUCTURE] = (unsigned char*)out + out->size;
  ZOO_FAULT(&now);
  return now.status;
}

static const regista_positioner calls = {sizeof(regista_positioner), 0, place};
const int32_t zoo_kind = REGISTA_KIND_POSITIONER;
const void* const zoo_calls = &calls;
