/* SPDX-License-Identifier: MIT
 *
 * How good it is for a robot to be near its task. */
#include <math.h>

#include <regista/c.h>

/* --- The idea: knows nothing of Regista, and test.c tests it alone --- */

/* In (0, 1]: 1 at the distance 0, a half at `half_at`. distance >= 0 and half_at > 0, both in m. */
static double nearness(double distance, double half_at) { return half_at / (half_at + distance); }

/* --- The glue: the instance, the calls of its kind, what it is called and what can be set --- */

/* An instance works for one robot. */
typedef struct plugin {
  double half_at; /* m */
} plugin;

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
    const int32_t* number = regista_element(world->active, row);
    const regista_robot* robot = regista_element(world->robots, (uint32_t)*number - 1);
    for (uint32_t column = 0; column < out->columns; ++column) {
      const regista_task* task = regista_element(frame->tasks, column);
      const double distance = hypot(task->after[0] - robot->pose[0], task->after[1] - robot->pose[1]);
      out->values[(size_t)row * out->stride + column] = nearness(distance, self->half_at);
    }
  }
  return REGISTA_OK;
}

static const regista_utility calls = {.size = sizeof(regista_utility), .score = score};

static const regista_parameter parameters[] = {{.size = sizeof(regista_parameter),
                                                .type = REGISTA_TYPE_REAL,
                                                .name = "half_at",
                                                .unit = "m",
                                                .doc = "Distance at which half of the utility is left",
                                                .minimum = 0.1,
                                                .maximum = 20.0,
                                                .initial = 2.0,
                                                .flags = REGISTA_PARAMETER_TUNABLE}};

static void set(plugin* self, const regista_environment* environment, regista_span values) {
  (void)environment;
  self->half_at = regista_number(values, 0);
}

/* The beginning of a match. */
static void begin(plugin* self, uint64_t seed) { (void)self, (void)seed; }

REGISTA_C_PLUGIN(plugin, REGISTA_KIND_UTILITY, calls, parameters, set, begin, .id = "@NAME@", .version = "0.1.0",
                 .summary = "Nearness of the robot to the task", .licence = "MIT", .reads = REGISTA_READS_NOTHING);
