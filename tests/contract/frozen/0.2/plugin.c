/* SPDX-License-Identifier: MIT
 *
 * A small plugin of interface 0.2, built against the copy of abi.h beside it and nothing else: an assigner that gives
 * each task, in order, to the free robot that is best at it, and tells its teammates how many it gave. */
#include <stdlib.h>
#include <string.h>

#include <regista/abi.h>

#if REGISTA_ABI_MAJOR != 0 || REGISTA_ABI_MINOR != 2
#error "another abi.h than the copy beside this file"
#endif

typedef struct state {
  const regista_host* host;
  double interval, at_least;
  double next_offer;
  unsigned heard;
} state;

static int32_t assign(void* instance, const regista_frame* frame, const regista_matrix* u, int32_t* out,
                      regista_error* error) {
  state* self = (state*)instance;
  uint8_t given = 0;
  (void)error;
  for (uint32_t j = 0; j < u->columns; ++j) {
    uint32_t best = u->rows;
    for (uint32_t i = 0; i < u->rows; ++i) {
      const double here = u->values[(size_t)i * u->stride + j];
      if (out[i] != REGISTA_NO_TASK || here < self->at_least) continue;
      if (best == u->rows || here > u->values[(size_t)best * u->stride + j]) best = i;
    }
    if (best == u->rows) continue;
    out[best] = (int32_t)j;
    ++given;
  }
  if (frame->time >= self->next_offer) {
    self->next_offer = frame->time + self->interval;
    self->host->offer(self->host->context, &given, 1, 0.5, self->next_offer, REGISTA_MEDIUM_RADIO, 0);
  }
  return REGISTA_OK;
}

static int32_t told(void* instance, uint64_t handle, regista_error* error) {
  (void)instance;
  (void)handle;
  (void)error;
  return REGISTA_OK;
}

static int32_t receive(void* instance, const regista_message* message, regista_error* error) {
  if (message->count != 1) {
    strcpy(error->text, "a message of another length than was sent");
    return REGISTA_FAILED;
  }
  ++((state*)instance)->heard;
  return REGISTA_OK;
}

static const regista_assigner assigner = {sizeof(regista_assigner), 0, assign};
static const regista_mailbox mailbox = {sizeof(regista_mailbox), 0, told, told, receive, NULL};

static const void* table(int32_t kind) {
  if (kind == REGISTA_KIND_ASSIGNER) return &assigner;
  return kind == REGISTA_KIND_MAILBOX ? &mailbox : NULL;
}

static void* create(const regista_environment* environment, const regista_host* host, regista_span values,
                    regista_error* error) {
  state* self = (state*)calloc(1, sizeof *self);
  (void)environment;
  if (self == NULL) {
    strcpy(error->text, "out of memory");
    return NULL;
  }
  self->host = host;
  self->interval = ((const regista_value*)values.data)->number;
  self->at_least = ((const regista_value*)((const char*)values.data + values.stride))->number;
  return self;
}

static int32_t reset(void* instance, uint64_t seed, regista_error* error) {
  state* self = (state*)instance;
  (void)seed;
  (void)error;
  self->next_offer = 0.0;
  self->heard = 0;
  return REGISTA_OK;
}

static const regista_parameter parameters[] = {
    {sizeof(regista_parameter), REGISTA_TYPE_REAL, "interval", "s", "Between two messages", 0.1, 100.0, 5.0, NULL, NULL,
     0, 0},
    {sizeof(regista_parameter), REGISTA_TYPE_REAL, "at_least", "1", "Pairs of a lower utility are not taken", 0.0, 10.0,
     0.0, NULL, NULL, 0, REGISTA_PARAMETER_TUNABLE}};

static const regista_descriptor descriptor = {sizeof(regista_descriptor),
                                              REGISTA_ABI_MAJOR,
                                              REGISTA_ABI_MINOR,
                                              2,
                                              "frozen_0_2",
                                              "1.0.0",
                                              "Tasks in order, each to its best free robot; interface 0.2",
                                              "MIT",
                                              "frozen",
                                              parameters,
                                              sizeof(regista_parameter),
                                              0,
                                              table,
                                              create,
                                              reset,
                                              free,
                                              REGISTA_ABI_MAJOR,
                                              REGISTA_ABI_MINOR,
                                              REGISTA_READS_NOTHING,
                                              0,
                                              NULL};

const regista_descriptor* regista_plugin_entry(uint32_t host_major, uint32_t host_minor, uint32_t index) {
  (void)host_major;
  (void)host_minor;
  return index == 0 ? &descriptor : NULL;
}
