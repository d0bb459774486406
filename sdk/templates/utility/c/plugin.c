/* SPDX-License-Identifier: MIT
 *
 * How good it is for a robot to be near its task. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <regista/abi.h>

/* --- The idea: knows nothing of Regista, and test.c tests it alone --- */

/* In (0, 1]: 1 at the distance 0, a half at `half_at`. distance >= 0 and half_at > 0, both in m. */
static double nearness(double distance, double half_at) { return half_at / (half_at + distance); }

/* --- The glue: the instance, the calls of its kind, what it is called and what can be set --- */

/* An instance works for one robot. */
typedef struct plugin {
  double half_at; /* m */
} plugin;

/* Elements of arrays may be larger than this header knows: step by their stride. */
static const void* element(regista_span span, uint32_t i) { return (const char*)span.data + (size_t)i * span.stride; }

/* The world that the team wants this call to be computed on. */
static const regista_world* world_of(const regista_frame* frame) {
  return frame->knowledge == REGISTA_COMMON ? frame->common : frame->mine;
}

/* Rows are the active robots, columns the tasks. */
static int32_t score(void* instance, const regista_frame* frame, const regista_matrix_room* out, regista_error* error) {
  const plugin* self = instance;
  const regista_world* world = world_of(frame);
  (void)error;
  for (uint32_t row = 0; row < out->rows; ++row) {
    const int32_t* number = element(world->active, row);
    const regista_robot* robot = element(world->robots, (uint32_t)*number - 1);
    for (uint32_t column = 0; column < out->columns; ++column) {
      const regista_task* task = element(frame->tasks, column);
      const double distance = hypot(task->after[0] - robot->pose[0], task->after[1] - robot->pose[1]);
      out->values[(size_t)row * out->stride + column] = nearness(distance, self->half_at);
    }
  }
  return REGISTA_OK;
}

static const regista_utility calls = {.size = sizeof(regista_utility), .score = score};

static const void* table(int32_t kind) { return kind == REGISTA_KIND_UTILITY ? &calls : NULL; }

static const regista_parameter parameters[] = {{.size = sizeof(regista_parameter),
                                                .type = REGISTA_TYPE_REAL,
                                                .name = "half_at",
                                                .unit = "m",
                                                .doc = "Distance at which half of the utility is left",
                                                .minimum = 0.1,
                                                .maximum = 20.0,
                                                .initial = 2.0,
                                                .flags = REGISTA_PARAMETER_TUNABLE}};

static double value(regista_span values, uint32_t i) {
  return ((const regista_value*)((const char*)values.data + (size_t)i * values.stride))->number;
}

static void* create(const regista_environment* environment, const regista_host* host, regista_span values,
                    regista_error* error) {
  plugin* self = calloc(1, sizeof *self);
  (void)host;
  if (self == NULL) {
    strcpy(error->text, "out of memory");
    return NULL;
  }
  self->half_at = value(values, 0);
  (void)environment;
  return self;
}

/* The beginning of a match. */
static int32_t reset(void* instance, uint64_t seed, regista_error* error) {
  (void)instance, (void)seed, (void)error;
  return REGISTA_OK;
}

static const regista_descriptor descriptor = {.size = sizeof(regista_descriptor),
                                              .abi_major = REGISTA_ABI_MAJOR,
                                              .abi_minor = REGISTA_ABI_MINOR,
                                              .parameter_count = sizeof parameters / sizeof parameters[0],
                                              .id = "@NAME@",
                                              .version = "0.1.0",
                                              .summary = "Nearness of the robot to the task",
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
  (void)host_major, (void)host_minor;
  return index == 0 ? &descriptor : NULL;
}
