/* SPDX-License-Identifier: MIT
 *
 * Stands at the place of its task, away from the ball, and looks at it. */
#include <math.h>

#include <regista/c.h>

/* --- The idea: knows nothing of Regista, and test.c tests it alone --- */

typedef struct place {
  double x, y, heading;
} place;

/* The point nearest to (x, y) that is not nearer to the ball than `distance`, facing the ball. Where the ball itself is
 * wanted, the point is behind it, towards the own goal. */
static place beside(const double ball[2], double x, double y, double distance) {
  const double dx = x - ball[0], dy = y - ball[1], away = hypot(dx, dy);
  place out = {x, y, 0.0};
  if (away < 1e-6) {
    out.x = ball[0] - distance;
    out.y = ball[1];
  } else if (away < distance) {
    out.x = ball[0] + dx * distance / away;
    out.y = ball[1] + dy * distance / away;
  }
  out.heading = atan2(ball[1] - out.y, ball[0] - out.x);
  return out;
}

/* --- The glue: the instance, the calls of its kind, what it is called and what can be set --- */

/* An instance works for one robot. */
typedef struct plugin {
  double distance; /* m */
  double own_half; /* x below which a robot stands in the own half, with room to spare */
} plugin;

/* Called in every phase. On entry the robot stands and looks ahead; whoever walks in Set is penalised. */
static int32_t act(void* instance, const regista_frame* frame, const regista_body* body, regista_action* out,
                   regista_error* error) {
  const plugin* self = instance;
  const regista_ball* ball = frame->mine->ball;
  const int32_t phase = frame->mine->game->phase;
  (void)error;
  if (body->task < 0 || (phase != REGISTA_PHASE_READY && phase != REGISTA_PHASE_PLAYING)) return REGISTA_OK;
  const regista_task* task = regista_element(frame->tasks, (uint32_t)body->task);
  place stand = {task->after[0], task->after[1], task->after[2]};
  if ((ball->flags & REGISTA_BALL_KNOWN) != 0) {
    const double direction = atan2(ball->position[1] - body->pose[1], ball->position[0] - body->pose[0]);
    stand = beside(ball->position, stand.x, stand.y, self->distance);
    out->gaze = remainder(direction - body->pose[2], 2.0 * 3.14159265358979323846);
  }
  if (phase == REGISTA_PHASE_READY) stand.x = fmin(stand.x, self->own_half);
  out->motion = REGISTA_MOTION_WALK_TO;
  out->pose[0] = stand.x;
  out->pose[1] = stand.y;
  out->pose[2] = stand.heading;
  return REGISTA_OK;
}

static const regista_behaviour calls = {.size = sizeof(regista_behaviour), .act = act};

static const regista_parameter parameters[] = {
    {.size = sizeof(regista_parameter),
     .type = REGISTA_TYPE_REAL,
     .name = "distance",
     .unit = "m",
     .doc = "Never nearer to the ball; opponents of a set play have to keep 0.75 m, and a body is 0.3 m wide",
     .minimum = 0.3,
     .maximum = 5.0,
     .initial = 1.1,
     .flags = REGISTA_PARAMETER_TUNABLE}};

static void set(plugin* self, const regista_environment* environment, regista_span values) {
  self->distance = regista_number(values, 0);
  self->own_half = -environment->robot_radius - 0.2;
}

/* The beginning of a match. */
static void begin(plugin* self, uint64_t seed) { (void)self, (void)seed; }

REGISTA_C_PLUGIN(plugin, REGISTA_KIND_BEHAVIOUR, calls, parameters, set, begin, .id = "@NAME@", .version = "0.1.0",
                 .summary = "Stands at the place of its task, away from the ball, and looks at it", .licence = "MIT",
                 .reads = REGISTA_READS_FACINGS);
