/* SPDX-License-Identifier: MIT
 *
 * A plugin of each of the seven kinds in plain C, from abi.h alone: the ball and the robots are where they were last
 * heard of, the nearest robot takes a task, walks to it and kicks what lies before it. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <regista/abi.h>

enum { MOST_TRACKS = 16 };

/* What any of the seven remembers. */
typedef struct {
  uint32_t subject;
  int32_t number;
  uint32_t kicks;
  double shortest, farthest, reach;
  uint32_t count;
  regista_track tracks[MOST_TRACKS];
} memory;

static const void* element(regista_span span, uint32_t i) { return (const char*)span.data + (size_t)i * span.stride; }
static void* place_in(const regista_room* room, uint32_t i) { return (char*)room->data + (size_t)i * room->stride; }
static const regista_world* world_of(const regista_frame* frame) {
  return frame->knowledge == REGISTA_COMMON ? frame->common : frame->mine;
}

static int32_t done(void) { return REGISTA_OK; }

/* --- Predictor --- */

static int32_t predict(void* instance, double dt, const regista_motion* motion, const regista_frame* last,
                       regista_error* error) {
  memory* self = instance;
  (void)last, (void)error;
  for (uint32_t i = 0; i < self->count; ++i) {
    self->tracks[i].age += dt;
    self->tracks[i].covariance[0] += 0.05 * dt;
    self->tracks[i].covariance[2] += 0.05 * dt;
  }
  if (self->subject == REGISTA_SUBJECT_SELF && motion != NULL) {
    regista_track* own = &self->tracks[0];
    const double c = cos(own->pose.heading), s = sin(own->pose.heading);
    own->x += c * motion->x - s * motion->y;
    own->y += s * motion->x + c * motion->y;
    own->pose.heading = remainder(own->pose.heading + motion->heading, 2.0 * 3.14159265358979323846);
  }
  return done();
}

static int32_t correct(void* instance, regista_span measurements, const regista_visible_area* area,
                       regista_error* error) {
  memory* self = instance;
  (void)area, (void)error;
  for (uint32_t i = 0; i < measurements.count; ++i) {
    const regista_measurement* seen = element(measurements, i);
    const int own = self->subject == REGISTA_SUBJECT_SELF;
    if (seen->kind == REGISTA_MEASURED_LANDMARK || (own && seen->kind != REGISTA_MEASURED_POSE)) continue;
    if (self->subject == REGISTA_SUBJECT_TEAMMATES || self->subject == REGISTA_SUBJECT_OPPONENTS) continue;
    regista_track* track = &self->tracks[0];
    memset(track, 0, sizeof *track);
    track->label = own ? self->number : 1;
    track->x = seen->position[0];
    track->y = seen->position[1];
    if (own) track->pose.heading = seen->heading;
    track->covariance[0] = track->covariance[2] = 0.01;
    track->weight = 1.0;
    self->count = 1;
  }
  return done();
}

static int32_t absorb(void* instance, regista_span tracks, double age, regista_error* error) {
  memory* self = instance;
  (void)error;
  if (self->subject != REGISTA_SUBJECT_TEAMMATES) self->count = 0;
  for (uint32_t i = 0; i < tracks.count; ++i) {
    const regista_track* told = element(tracks, i);
    uint32_t at = 0;
    while (at < self->count && self->tracks[at].label < told->label) ++at;
    if (at == self->count || self->tracks[at].label != told->label) {
      if (self->count == MOST_TRACKS) break;
      memmove(self->tracks + at + 1, self->tracks + at, (self->count - at) * sizeof *self->tracks);
      ++self->count;
    }
    self->tracks[at] = *told;
    self->tracks[at].age += age;
  }
  return done();
}

static int32_t tracks(void* instance, regista_room* out, regista_error* error) {
  const memory* self = instance;
  (void)error;
  for (uint32_t i = 0; i < self->count && out->count < out->capacity; ++i) {
    memcpy(place_in(out, out->count++), &self->tracks[i], sizeof(regista_track));
  }
  return done();
}

/* --- Context, positioner, utility, assigner --- */

static int32_t holds(void* instance, const regista_frame* frame, int32_t* out, regista_error* error) {
  (void)instance, (void)error;
  *out = world_of(frame)->game->half >= 1;
  return done();
}

static int32_t place(void* instance, const regista_frame* frame, regista_placement* out, regista_error* error) {
  (void)instance, (void)error, (void)frame;
  for (int i = 0; i < 3; ++i) {
    regista_waypoint* point = place_in(&out->points, out->points.count++);
    point->x = i - 1.0;
    point->y = i == 1 ? 1.0 : -1.0;
    point->score = 1.0;
    point->task = -1;
    point->robot = 0;
  }
  for (uint32_t i = 0; i < 2; ++i) {
    regista_edge* edge = place_in(&out->edges, out->edges.count++);
    edge->from = i;
    edge->to = i + 1;
  }
  return done();
}

static int32_t score(void* instance, const regista_frame* frame, const regista_matrix_room* out, regista_error* error) {
  const regista_world* world = world_of(frame);
  (void)instance, (void)error;
  for (uint32_t i = 0; i < out->rows; ++i) {
    const int32_t number = *(const int32_t*)element(world->active, i);
    const regista_robot* robot = element(world->robots, (uint32_t)number - 1);
    for (uint32_t j = 0; j < out->columns; ++j) {
      const regista_task* task = element(frame->tasks, j);
      const double dx = task->after[0] - robot->pose[0], dy = task->after[1] - robot->pose[1];
      out->values[(size_t)i * out->stride + j] = 1.0 / (1.0 + sqrt(dx * dx + dy * dy));
    }
  }
  return done();
}

static int32_t assign(void* instance, const regista_frame* frame, const regista_matrix* utilities, int32_t* out,
                      regista_error* error) {
  (void)instance, (void)frame, (void)error;
  for (uint32_t j = 0; j < utilities->columns; ++j) {
    uint32_t best = utilities->rows;
    double most = -INFINITY;
    for (uint32_t i = 0; i < utilities->rows; ++i) {
      const double value = utilities->values[(size_t)i * utilities->stride + j];
      if (out[i] != REGISTA_NO_TASK || !(value > most)) continue;
      most = value;
      best = i;
    }
    if (best < utilities->rows) out[best] = (int32_t)j;
  }
  return done();
}

/* --- Behaviour --- */

static int32_t act(void* instance, const regista_frame* frame, const regista_body* body, regista_action* out,
                   regista_error* error) {
  const memory* self = instance;
  const int32_t phase = frame->mine->game->phase;
  (void)error;
  if (body->task < 0 || (phase != REGISTA_PHASE_READY && phase != REGISTA_PHASE_PLAYING)) return done();
  const regista_task* task = element(frame->tasks, (uint32_t)body->task);
  const regista_ball* ball = frame->mine->ball;
  const double dx = ball->position[0] - body->pose[0], dy = ball->position[1] - body->pose[1];
  if (phase == REGISTA_PHASE_PLAYING && (body->flags & REGISTA_BODY_SEES_BALL) != 0 && self->kicks > 0 &&
      sqrt(dx * dx + dy * dy) < self->reach) {
    out->kick = 0;
    out->kick_direction = remainder(-body->pose[2], 2.0 * 3.14159265358979323846);
    out->kick_distance = 0.5 * (self->shortest + self->farthest);
    return done();
  }
  out->motion = REGISTA_MOTION_WALK_TO;
  for (int i = 0; i < 3; ++i) out->pose[i] = task->after[i];
  return done();
}

/* --- Sender --- */

static int32_t decide(void* instance, const regista_frame* frame, regista_span events, regista_span offers,
                      const regista_budget* budget, regista_send* out, regista_error* error) {
  (void)instance, (void)frame, (void)events, (void)offers, (void)error;
  out->send = budget->packets_left > 20 && budget->since_own >= 2.0;
  out->reason = REGISTA_REASON_OWN;
  return done();
}

static const char* const reasons[] = {"two_seconds"};
static const regista_predictor predictor = {
    .size = sizeof(regista_predictor),
    .subjects = REGISTA_SUBJECT_SELF | REGISTA_SUBJECT_BALL | REGISTA_SUBJECT_OPPONENTS | REGISTA_SUBJECT_TEAMMATES,
    .predict = predict,
    .correct = correct,
    .absorb = absorb,
    .tracks = tracks};
static const regista_context context = {.size = sizeof(regista_context), .holds = holds};
static const regista_positioner positioner = {.size = sizeof(regista_positioner), .place = place};
static const regista_utility utility = {.size = sizeof(regista_utility), .score = score};
static const regista_assigner assigner = {.size = sizeof(regista_assigner), .assign = assign};
static const regista_behaviour behaviour = {
    .size = sizeof(regista_behaviour), .flags = REGISTA_BEHAVIOUR_PLAYS_BALL, .act = act};
static const regista_sender sender = {
    .size = sizeof(regista_sender), .reason_count = 1, .decide = decide, .reasons = reasons};

static const void* table_predictor(int32_t kind) { return kind == REGISTA_KIND_PREDICTOR ? &predictor : NULL; }
static const void* table_context(int32_t kind) { return kind == REGISTA_KIND_CONTEXT ? &context : NULL; }
static const void* table_positioner(int32_t kind) { return kind == REGISTA_KIND_POSITIONER ? &positioner : NULL; }
static const void* table_utility(int32_t kind) { return kind == REGISTA_KIND_UTILITY ? &utility : NULL; }
static const void* table_assigner(int32_t kind) { return kind == REGISTA_KIND_ASSIGNER ? &assigner : NULL; }
static const void* table_behaviour(int32_t kind) { return kind == REGISTA_KIND_BEHAVIOUR ? &behaviour : NULL; }
static const void* table_sender(int32_t kind) { return kind == REGISTA_KIND_SENDER ? &sender : NULL; }

static void* create(const regista_environment* environment, const regista_host* host, regista_span values,
                    regista_error* error) {
  memory* self = calloc(1, sizeof *self);
  (void)host, (void)values;
  if (self == NULL) {
    strcpy(error->text, "out of memory");
    return NULL;
  }
  self->subject = environment->subject;
  self->number = environment->own_number;
  self->reach = environment->kick_reach;
  self->kicks = environment->kicks.count;
  if (self->kicks > 0) {
    const regista_kick* first = element(environment->kicks, 0);
    self->shortest = first->minimum_distance;
    self->farthest = first->maximum_distance;
  }
  return self;
}

static int32_t reset(void* instance, uint64_t seed, regista_error* error) {
  memory* self = instance;
  (void)seed, (void)error;
  self->count = 0;
  if (self->subject == REGISTA_SUBJECT_SELF) {
    memset(self->tracks, 0, sizeof self->tracks[0]);
    self->tracks[0].label = self->number;
    self->tracks[0].covariance[0] = self->tracks[0].covariance[2] = 1.0;
    self->tracks[0].weight = 1.0;
    self->count = 1;
  }
  return done();
}

#define DESCRIPTOR(kind)                                                                                  \
  {                                                                                                       \
    .size = sizeof(regista_descriptor), .abi_major = REGISTA_ABI_MAJOR, .abi_minor = REGISTA_ABI_MINOR,   \
    .id = BUILT_AS #kind, .version = "1.0.0", .summary = "One of seven kinds, in C", .licence = "MIT",    \
    .build_tag = REGISTA_BUILD_TAG, .parameter_stride = sizeof(regista_parameter), .table = table_##kind, \
    .create = create, .reset = reset, .destroy = free, .reads = REGISTA_READS_FACINGS                     \
  }

static const regista_descriptor descriptors[] = {DESCRIPTOR(predictor), DESCRIPTOR(context),  DESCRIPTOR(positioner),
                                                 DESCRIPTOR(utility),   DESCRIPTOR(assigner), DESCRIPTOR(behaviour),
                                                 DESCRIPTOR(sender)};

const regista_descriptor* regista_plugin_entry(uint32_t host_major, uint32_t host_minor, uint32_t index) {
  (void)host_major, (void)host_minor;
  return index < sizeof descriptors / sizeof descriptors[0] ? &descriptors[index] : NULL;
}
