/* SPDX-License-Identifier: MIT
 *
 * Points on a circle around the ball, evenly, kept on the field, and one before the own goal. */
#include <math.h>
#include <string.h>

#include <regista/c.h>

/* --- The idea: knows nothing of Regista, and test.c tests it alone --- */

enum { MOST_POINTS = 24 };

/* The first point lies straight ahead of the centre, the others follow counter-clockwise. edge: half length and half
 * width of the field. Fills in `count` points. */
static void ring(const double centre[2], double radius, int count, const double edge[2], double (*points)[2]) {
  for (int i = 0; i < count; ++i) {
    const double angle = 2.0 * 3.14159265358979323846 * i / count;
    points[i][0] = fmin(fmax(centre[0] + radius * cos(angle), -edge[0]), edge[0]);
    points[i][1] = fmin(fmax(centre[1] + radius * sin(angle), -edge[1]), edge[1]);
  }
}

/* --- The glue: the instance, the calls of its kind, what it is called and what can be set --- */

/* An instance works for one robot. */
typedef struct plugin {
  double radius; /* m */
  int count;
  double edge[2];
} plugin;

/* The world that the team wants this call to be computed on. */
static const regista_world* world_of(const regista_frame* frame) {
  return frame->knowledge == REGISTA_COMMON ? frame->common : frame->mine;
}

/* The next element of a room, null when it is full. Elements may be larger than this header knows: step by the stride.
 */
static void* add(regista_room* room) {
  return room->count == room->capacity ? NULL : (char*)room->data + (size_t)room->count++ * room->stride;
}

static int32_t place(void* instance, const regista_frame* frame, regista_placement* out, regista_error* error) {
  const plugin* self = instance;
  const regista_ball* ball = world_of(frame)->ball;
  const double centre_of_field[2] = {0.0, 0.0};
  const int known = (ball->flags & REGISTA_BALL_KNOWN) != 0;
  double points[MOST_POINTS][2];
  ring(known ? ball->position : centre_of_field, self->radius, self->count, self->edge, points);
  for (int i = 0; i < self->count; ++i) {
    regista_waypoint* point = add(&out->points);
    regista_edge* edge = add(&out->edges);
    if (point == NULL || edge == NULL) {
      strcpy(error->text, "more points than the host has room for");
      return REGISTA_FAILED;
    }
    *point = (regista_waypoint){.x = points[i][0], .y = points[i][1], .score = 1.0, .task = -1};
    *edge = (regista_edge){.from = (uint32_t)i, .to = (uint32_t)((i + 1) % self->count)};
  }
  /* Without this point, teams that keep the tasks nearest to points keep no defender. */
  regista_waypoint* guard = add(&out->points);
  if (guard != NULL) *guard = (regista_waypoint){.x = -0.75 * self->edge[0], .score = 1.0, .task = -1};
  return REGISTA_OK;
}

static const regista_positioner calls = {.size = sizeof(regista_positioner), .place = place};

static const regista_parameter parameters[] = {{.size = sizeof(regista_parameter),
                                                .type = REGISTA_TYPE_REAL,
                                                .name = "radius",
                                                .unit = "m",
                                                .doc = "Distance of the points from the ball",
                                                .minimum = 0.2,
                                                .maximum = 10.0,
                                                .initial = 1.5,
                                                .flags = REGISTA_PARAMETER_TUNABLE},
                                               {.size = sizeof(regista_parameter),
                                                .type = REGISTA_TYPE_INTEGER,
                                                .name = "count",
                                                .unit = "1",
                                                .doc = "Number of the points on the circle",
                                                .minimum = 3.0,
                                                .maximum = MOST_POINTS,
                                                .initial = 6.0}};

static void set(plugin* self, const regista_environment* environment, regista_span values) {
  self->radius = regista_number(values, 0);
  self->count = (int)regista_number(values, 1);
  self->edge[0] = environment->field_length / 2.0;
  self->edge[1] = environment->field_width / 2.0;
}

/* The beginning of a match. */
static void begin(plugin* self, uint64_t seed) { (void)self, (void)seed; }

REGISTA_C_PLUGIN(plugin, REGISTA_KIND_POSITIONER, calls, parameters, set, begin, .id = "@NAME@", .version = "0.1.0",
                 .summary = "Points on a circle around the ball", .licence = "MIT", .reads = REGISTA_READS_NOTHING);
