/* SPDX-License-Identifier: MIT
 * A utility in plain C to which every robot is equally good for every task: the smallest complete plugin. */
#include <regista/abi.h>
#include <stdlib.h>

typedef struct {
  double value;
} indifferent;

static int32_t score(void* instance, const regista_frame* frame, const regista_matrix_room* out, regista_error* error) {
  (void)frame;
  (void)error;
  for (uint32_t i = 0; i < out->rows; ++i)
    for (uint32_t j = 0; j < out->columns; ++j)
      out->values[(size_t)i * out->stride + j] = ((const indifferent*)instance)->value;
  return REGISTA_OK;
}

static const void* table(int32_t kind) {
  static const regista_utility utility = {sizeof(regista_utility), 0, score};
  return kind == REGISTA_KIND_UTILITY ? &utility : NULL;
}

static void* create(const regista_environment* environment, const regista_host* host, regista_span values,
                    regista_error* error) {
  (void)environment;
  (void)host;
  (void)error;
  indifferent* self = malloc(sizeof *self);
  if (self) self->value = ((const regista_value*)values.data)->number;
  return self;
}

static int32_t reset(void* instance, uint64_t seed, regista_error* error) {
  (void)instance;
  (void)seed;
  (void)error;
  return REGISTA_OK;
}

static const regista_parameter parameters[] = {{.size = sizeof(regista_parameter),
                                                .type = REGISTA_TYPE_REAL,
                                                .name = "value",
                                                .unit = "1",
                                                .doc = "the utility of every pair",
                                                .minimum = 0.0,
                                                .maximum = 1.0,
                                                .initial = 0.5}};

static const regista_descriptor descriptor = {.size = sizeof(regista_descriptor),
                                              .abi_major = REGISTA_ABI_MAJOR,
                                              .abi_minor = REGISTA_ABI_MINOR,
                                              .parameter_count = 1,
                                              .id = "indifferent",
                                              .version = "1.0.0",
                                              .summary = "Every robot is equally good for every task",
                                              .licence = "MIT",
                                              .build_tag = REGISTA_BUILD_TAG,
                                              .parameters = parameters,
                                              .parameter_stride = sizeof(regista_parameter),
                                              .table = table,
                                              .create = create,
                                              .reset = reset,
                                              .destroy = free,
                                              .minimum_major = REGISTA_ABI_MAJOR,
                                              .minimum_minor = REGISTA_ABI_MINOR,
                                              .reads = REGISTA_READS_NOTHING};

const regista_descriptor* regista_plugin_entry(uint32_t host_major, uint32_t host_minor, uint32_t index) {
  (void)host_major;
  (void)host_minor;
  return index == 0 ? &descriptor : NULL;
}
