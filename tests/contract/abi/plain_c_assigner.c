/* SPDX-License-Identifier: MIT
 *
 * A whole plugin in C, from abi.h alone: columns in order, each to its best free row. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <regista/abi.h>

typedef struct best_row {
  double at_least; /* rows below this come last, but come */
} best_row;

static const double* at(const regista_matrix* u, uint32_t row, uint32_t column) {
  return &u->values[(size_t)row * u->stride + column];
}

/* Whether `a` is a better choice than `b` for a column. */
static int better(const best_row* self, double a, double b) {
  const int a_reaches = a >= self->at_least, b_reaches = b >= self->at_least;
  return a_reaches != b_reaches ? a_reaches : a > b;
}

static int32_t assign(void* instance, const regista_frame* frame, const regista_matrix* u, int32_t* out,
                      regista_error* error) {
  const best_row* self = (const best_row*)instance;
  (void)frame;
  (void)error;
  for (uint32_t j = 0; j < u->columns; ++j) {
    uint32_t best = u->rows;
    for (uint32_t i = 0; i < u->rows; ++i) {
      if (out[i] != REGISTA_NO_TASK || *at(u, i, j) == -INFINITY) continue;
      if (best == u->rows || better(self, *at(u, i, j), *at(u, best, j))) best = i;
    }
    if (best < u->rows) out[best] = (int32_t)j;
  }
  return REGISTA_OK;
}

static const regista_assigner calls = {sizeof(regista_assigner), 0, assign};

static const void* table(int32_t kind) { return kind == REGISTA_KIND_ASSIGNER ? &calls : NULL; }

static void* create(const regista_environment* environment, const regista_host* host, regista_span values,
                    regista_error* error) {
  best_row* self = (best_row*)malloc(sizeof *self);
  (void)environment;
  (void)host;
  if (self == NULL) {
    strcpy(error->text, "out of memory");
    return NULL;
  }
  self->at_least = ((const regista_value*)values.data)->number;
  return self;
}

static int32_t reset(void* instance, uint64_t seed, regista_error* error) {
  (void)instance;
  (void)seed;
  (void)error;
  return REGISTA_OK;
}

static const regista_parameter parameters[] = {{sizeof(regista_parameter), REGISTA_TYPE_REAL, "at_least", "1",
                                                "Utility below which a robot comes last", 0.0, 10.0, 0.1, NULL, NULL, 0,
                                                REGISTA_PARAMETER_TUNABLE}};

static const regista_descriptor descriptor = {sizeof(regista_descriptor),
                                              REGISTA_ABI_MAJOR,
                                              REGISTA_ABI_MINOR,
                                              1,
                                              "plain_c",
                                              "1.0.0",
                                              "Columns in order, each to its best free row",
                                              "MIT",
                                              REGISTA_BUILD_TAG,
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
