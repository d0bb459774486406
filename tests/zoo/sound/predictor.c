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
  self->track.covariance[2] += 0.01 * dt;
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
    self->track.covariance[0] = self->track.covariance[2] = 0.1;
    self->track.motion[4] = self->track.motion[6] = 0.1;
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

static int32_t tracks(void* instance, regista_room* out, regista_error* error) {
  zoo_instance* self = (zoo_instance*)instance;
  zoo_moment now = zoo_now(self, NULL, error);
  if (self->known && out->capacity > 0) {
    *(regista_track*)zoo_element(out, 0) = self->track;
    out->count = 1;
  }
  now.answer = out->data;
  now.past[ZOO_ANSWER] = zoo_element(out, out->capacity);
  now.past[ZOO_STRUCTURE] = out + 1;
  ZOO_FAULT(&now);
  return now.status;
}

static const regista_predictor calls = {
    sizeof(regista_predictor), REGISTA_SUBJECT_BALL, predict, correct, absorb, tracks, NULL};
const int32_t zoo_kind = REGISTA_KIND_PREDICTOR;
const void* const zoo_calls = &calls;
