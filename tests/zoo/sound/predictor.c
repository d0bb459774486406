/* SPDX-License-Identifier: MIT
 *
 * A predictor of the ball: where it was last measured, trusted less and less. */
#include <string.h>

#include "zoo.h"

static int32_t predict(void* instance, double dt, const regista_motion* motion, const regista_frame* last,
                       regista_error* error) {
  zoo_instance* self = (zoo_instance*)instance;
  (void)motion;
  (void)last;
  (void)error;
  self->track.age += dt;
  self->track.covariance[0] += 0.01 * dt;
  self->track.covariance[5] += 0.01 * dt;
  return REGISTA_OK;
}

static int32_t correct(void* instance, regista_span measurements, const regista_visible_area* area,
                       regista_error* error) {
  zoo_instance* self = (zoo_instance*)instance;
  (void)area;
  (void)error;
  for (uint32_t i = 0; i < measurements.count; ++i) {
    const char* const at = (const char*)measurements.data + (size_t)i * measurements.stride;
    const regista_measurement* measured = (const regista_measurement*)at;
    if (measured->kind != REGISTA_MEASURED_BALL) continue;
    memset(&self->track, 0, sizeof self->track);
    self->track.label = 1;
    self->track.x = measured->position[0];
    self->track.y = measured->position[1];
    for (int k = 0; k < 16; k += 5) self->track.covariance[k] = 0.1;
    self->track.weight = 1.0;
    self->known = 1;
  }
  return REGISTA_OK;
}

static int32_t absorb(void* instance, regista_span tracks, double age, regista_error* error) {
  zoo_instance* self = (zoo_instance*)instance;
  (void)error;
  self->known = tracks.count > 0;
  if (self->known) {
    self->track = *(const regista_track*)tracks.data;
    self->track.age += age;
  }
  return REGISTA_OK;
}

static int32_t tracks(void* instance, regista_track* out, uint32_t capacity, uint32_t* count, regista_error* error) {
  zoo_instance* self = (zoo_instance*)instance;
  zoo_moment now = zoo_now(self, NULL, error);
  if (self->known && capacity > 0) {
    out[0] = self->track;
    *count = 1;
  }
  now.answer = out;
  now.past[ZOO_ANSWER] = out + capacity;
  now.past[ZOO_STRUCTURE] = count + 1;
  ZOO_FAULT(&now);
  return now.status;
}

static const regista_predictor calls = {
    sizeof(regista_predictor), REGISTA_SUBJECT_BALL, predict, correct, absorb, tracks};
const int32_t zoo_kind = REGISTA_KIND_PREDICTOR;
const void* const zoo_calls = &calls;
