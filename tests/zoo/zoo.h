/* SPDX-License-Identifier: MIT
 *
 * What all animals of the zoo share: a sound plugin of each kind (sound/) that hands each of its calls to one fault
 * (faults/), when its own answer stands. The build names the fault, ZOO_FAULT, and the animal, ZOO_ID. */
#ifndef REGISTA_TESTS_ZOO_H
#define REGISTA_TESTS_ZOO_H

#include <string.h>

#include <regista/abi.h>

/* Buffers that the host lends to a call. A kind has those that its call has. */
enum {
  ZOO_ANSWER, /* columns, matrix, points, tracks, granted handles, the action, whether a context holds */
  ZOO_EDGES,  /* the other three of a positioner */
  ZOO_CELLS,
  ZOO_VERTICES,
  ZOO_STRUCTURE, /* regista_placement, regista_send, the room for tracks */
  ZOO_ERROR,
  ZOO_BUFFERS
};

struct zoo_instance;

/* One call of an animal, after its sound part. */
typedef struct zoo_moment {
  struct zoo_instance* self;
  int asked;                  /* calls of this instance so far, this one included */
  int robot;                  /* that it works for */
  const regista_frame* frame; /* null for a predictor */
  regista_matrix utilities;   /* of an assigner, else 0 x 0 */
  void* answer;               /* where the answer is, of the kind's type */
  void* past[ZOO_BUFFERS];    /* the first byte behind each buffer; null where there is none */
  regista_error* error;
  int32_t status; /* what the call returns */
} zoo_moment;

/* Called at the end of every call that asks for an answer. */
void ZOO_FAULT(zoo_moment* now);

/* The call at which most faults act: two seconds into a match. */
enum { ZOO_WHEN = 20 };

/* An instance: what the sound parts remember. */
typedef struct zoo_instance {
  int asked, robot;
  double x_limit, y_limit; /* half the field */
  const regista_host* host;
  int heard; /* what its robot has said last: what the honest twins of faults/sharing.c use */
  int known; /* predictor: has a track */
  regista_track track;
} zoo_instance;

/* The table of calls of the animal's kind: one of sound/. */
extern const int32_t zoo_kind;
extern const void* const zoo_calls;

static inline const regista_world* zoo_world(const regista_frame* frame) {
  return frame->knowledge == REGISTA_COMMON ? frame->common : frame->mine;
}

/* Where an element of a room begins; of as many as it has room for: where it ends. */
static inline void* zoo_element(const regista_room* room, uint32_t index) {
  return (unsigned char*)room->data + (size_t)index * room->stride;
}

/* The moment of a call that has this frame. */
static inline zoo_moment zoo_now(zoo_instance* self, const regista_frame* frame, regista_error* error) {
  zoo_moment now;
  memset(&now, 0, sizeof now);
  now.self = self;
  now.asked = ++self->asked;
  now.robot = self->robot;
  now.frame = frame;
  now.past[ZOO_ERROR] = error + 1;
  now.error = error;
  now.status = REGISTA_OK;
  return now;
}

#endif
