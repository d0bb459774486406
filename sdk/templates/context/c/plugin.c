/* SPDX-License-Identifier: MIT
 *
 * Holds while the ball is near the own goal, with hysteresis: at the edge the answer does not change to and fro. */
#include <math.h>

#include <regista/c.h>

/* --- The idea: knows nothing of Regista, and test.c tests it alone --- */

/* distance, m: nearer than `near` it is near, and what was near stays so up to `near` + `margin`. */
static int is_near(int was_near, double distance, double near, double margin) {
  return distance < (was_near ? near + margin : near);
}

/* --- The glue: the instance, the calls of its kind, what it is called and what can be set --- */

/* An instance works for one robot. */
typedef struct plugin {
  double near;   /* m */
  double margin; /* m */
  double goal_x;
  int near_now;
} plugin;

/* The world that the team wants this call to be computed on. */
static const regista_world* world_of(const regista_frame* frame) {
  return frame->knowledge == REGISTA_COMMON ? frame->common : frame->mine;
}

static int32_t holds(void* instance, const regista_frame* frame, int32_t* out, regista_error* error) {
  plugin* self = instance;
  const regista_ball* ball = world_of(frame)->ball;
  (void)error;
  if ((ball->flags & REGISTA_BALL_KNOWN) != 0) {
    const double distance = hypot(ball->position[0] - self->goal_x, ball->position[1]);
    self->near_now = is_near(self->near_now, distance, self->near, self->margin);
  } else {
    self->near_now = 0;
  }
  *out = self->near_now;
  return REGISTA_OK;
}

static const regista_context calls = {.size = sizeof(regista_context), .holds = holds};

static const regista_parameter parameters[] = {{.size = sizeof(regista_parameter),
                                                .type = REGISTA_TYPE_REAL,
                                                .name = "near",
                                                .unit = "m",
                                                .doc = "Distance of the ball from the goal below which it holds",
                                                .minimum = 0.1,
                                                .maximum = 20.0,
                                                .initial = 2.5,
                                                .flags = REGISTA_PARAMETER_TUNABLE},
                                               {.size = sizeof(regista_parameter),
                                                .type = REGISTA_TYPE_REAL,
                                                .name = "margin",
                                                .unit = "m",
                                                .doc = "How much farther the ball must be until it ends",
                                                .minimum = 0.0,
                                                .maximum = 5.0,
                                                .initial = 0.5,
                                                .flags = REGISTA_PARAMETER_TUNABLE}};

static void set(plugin* self, const regista_environment* environment, regista_span values) {
  self->near = regista_number(values, 0);
  self->margin = regista_number(values, 1);
  self->goal_x = -environment->field_length / 2.0;
}

/* The beginning of a match. */
static void begin(plugin* self, uint64_t seed) {
  (void)seed;
  self->near_now = 0;
}

REGISTA_C_PLUGIN(plugin, REGISTA_KIND_CONTEXT, calls, parameters, set, begin, .id = "@NAME@", .version = "0.1.0",
                 .summary = "Holds while the ball is near the own goal", .licence = "MIT",
                 .reads = REGISTA_READS_NOTHING);
