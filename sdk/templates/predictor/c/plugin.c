/* SPDX-License-Identifier: MIT
 *
 * The ball keeps its velocity: a Kalman filter for which x and y are alike. */
#include <math.h>
#include <stdlib.h>

#include <regista/c.h>

/* --- The idea: knows nothing of Regista, and test.c tests it alone --- */

typedef struct moving_ball {
  double x, y, vx, vy;
  double place, cross, velocity; /* covariance of each axis: m^2, m^2/s, m^2/s^2 */
  double age;                    /* s since it was seen */
} moving_ball;

/* dt s later. noise: how fast the velocity becomes uncertain, m/s^1.5. */
static void advance(moving_ball* ball, double dt, double noise) {
  const double q = noise * noise;
  ball->x += dt * ball->vx;
  ball->y += dt * ball->vy;
  ball->place += dt * (2.0 * ball->cross + dt * (ball->velocity + q * dt / 3.0));
  ball->cross += dt * (ball->velocity + q * dt / 2.0);
  ball->velocity += q * dt;
  ball->age += dt;
}

/* It is seen at (x, y). variance: of each of the two, m^2, > 0. */
static void take(moving_ball* ball, double x, double y, double variance) {
  const double for_place = ball->place / (ball->place + variance),
               for_velocity = ball->cross / (ball->place + variance);
  const double dx = x - ball->x, dy = y - ball->y;
  ball->x += for_place * dx;
  ball->y += for_place * dy;
  ball->vx += for_velocity * dx;
  ball->vy += for_velocity * dy;
  ball->velocity -= for_velocity * ball->cross;
  ball->cross *= 1.0 - for_place;
  ball->place *= 1.0 - for_place;
  ball->age = 0.0;
}

/* --- The glue: the instance, the calls of its kind, what it is called and what can be set --- */

/* An instance works for one robot. */
typedef struct plugin {
  double noise;        /* m/s^1.5 */
  double first_speed;  /* m/s */
  double forget_after; /* s */
  int known;
  moving_ball ball;
} plugin;

/* In no direction is the variance of (xx, xy, yy) larger than this. Nothing is seen better than to 1 mm. */
static double most_variance(const double* of) { return fmax(of[0], of[2]) + fabs(of[1]) + 1e-6; }

static double squared_distance(const plugin* self, const regista_measurement* seen) {
  const double dx = seen->position[0] - self->ball.x, dy = seen->position[1] - self->ball.y;
  return dx * dx + dy * dy;
}

static int32_t predict(void* instance, double dt, const regista_motion* motion, const regista_frame* last,
                       regista_error* error) {
  plugin* self = instance;
  (void)motion, (void)last, (void)error;
  if (!self->known) return REGISTA_OK;
  advance(&self->ball, dt, self->noise);
  if (self->ball.age > self->forget_after) self->known = 0;
  return REGISTA_OK;
}

/* Of several balls in an image it takes the one that is nearest to where it expects its own. */
static int32_t correct(void* instance, regista_span measurements, const regista_visible_area* area,
                       regista_error* error) {
  plugin* self = instance;
  const regista_measurement* best = NULL;
  (void)area, (void)error;
  for (uint32_t i = 0; i < measurements.count; ++i) {
    const regista_measurement* seen = regista_element(measurements, i);
    if (seen->kind != REGISTA_MEASURED_BALL) continue;
    if (best == NULL || (self->known && squared_distance(self, seen) < squared_distance(self, best))) best = seen;
  }
  if (best == NULL) return REGISTA_OK;
  if (self->known) {
    take(&self->ball, best->position[0], best->position[1], most_variance(best->covariance));
  } else {
    self->ball = (moving_ball){.x = best->position[0],
                               .y = best->position[1],
                               .place = most_variance(best->covariance),
                               .velocity = self->first_speed * self->first_speed};
    self->known = 1;
  }
  return REGISTA_OK;
}

/* A packet: this is the ball now, or nobody knows one. */
static int32_t absorb(void* instance, regista_span tracks, double age, regista_error* error) {
  plugin* self = instance;
  (void)error;
  self->known = tracks.count > 0;
  if (!self->known) return REGISTA_OK;
  const regista_track* told = regista_element(tracks, 0);
  self->ball = (moving_ball){.x = told->x,
                             .y = told->y,
                             .vx = told->vx,
                             .vy = told->vy,
                             .place = most_variance(told->covariance),
                             .velocity = most_variance(told->motion + 4),
                             .age = told->age};
  advance(&self->ball, age, self->noise);
  return REGISTA_OK;
}

static int32_t tracks(void* instance, regista_room* out, regista_error* error) {
  const plugin* self = instance;
  const moving_ball* ball = &self->ball;
  (void)error;
  if (!self->known || out->capacity == 0) return REGISTA_OK;
  regista_track* track = out->data;
  *track = (regista_track){.label = 1,
                           .flags = REGISTA_TRACK_VELOCITY,
                           .x = ball->x,
                           .y = ball->y,
                           .vx = ball->vx,
                           .vy = ball->vy,
                           .weight = 1.0,
                           .age = ball->age,
                           .covariance = {ball->place, 0.0, ball->place}};
  track->motion[0] = track->motion[3] = ball->cross;
  track->motion[4] = track->motion[6] = ball->velocity;
  out->count = 1;
  return REGISTA_OK;
}

static const regista_predictor calls = {.size = sizeof(regista_predictor),
                                        .subjects = REGISTA_SUBJECT_BALL,
                                        .predict = predict,
                                        .correct = correct,
                                        .absorb = absorb,
                                        .tracks = tracks};

static const regista_parameter parameters[] = {
    {.size = sizeof(regista_parameter),
     .type = REGISTA_TYPE_REAL,
     .name = "noise",
     .unit = "m/s^1.5",
     .doc = "How fast the velocity becomes uncertain",
     .minimum = 0.01,
     .maximum = 10.0,
     .initial = 1.0,
     .flags = REGISTA_PARAMETER_TUNABLE | REGISTA_PARAMETER_LOG_SCALE},
    {.size = sizeof(regista_parameter),
     .type = REGISTA_TYPE_REAL,
     .name = "first_speed",
     .unit = "m/s",
     .doc = "Standard deviation of each component of the velocity of a ball just found",
     .minimum = 0.1,
     .maximum = 10.0,
     .initial = 1.0,
     .flags = REGISTA_PARAMETER_TUNABLE},
    {.size = sizeof(regista_parameter),
     .type = REGISTA_TYPE_REAL,
     .name = "forget_after",
     .unit = "s",
     .doc = "Time without news after which the ball is lost",
     .minimum = 0.5,
     .maximum = 60.0,
     .initial = 5.0}};

static void set(plugin* self, const regista_environment* environment, regista_span values) {
  (void)environment;
  self->noise = regista_number(values, 0);
  self->first_speed = regista_number(values, 1);
  self->forget_after = regista_number(values, 2);
}

/* The beginning of a match. */
static void begin(plugin* self, uint64_t seed) {
  (void)seed;
  self->known = 0;
}

REGISTA_C_PLUGIN(plugin, REGISTA_KIND_PREDICTOR, calls, parameters, set, begin, .id = "@NAME@", .version = "0.1.0",
                 .summary = "Ball: keeps its velocity", .licence = "MIT", .reads = REGISTA_READS_NOTHING);
