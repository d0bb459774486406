/* SPDX-License-Identifier: MIT
 *
 * The best pair of a free robot and a free task, again and again. */
#include <math.h>
#include <stdlib.h>

#include <regista/c.h>

/* --- The idea: knows nothing of Regista, and test.c tests it alone --- */

enum { NONE = -1 };

static int taken(const int32_t* choice, uint32_t rows, uint32_t column) {
  for (uint32_t row = 0; row < rows; ++row) {
    if (choice[row] == (int32_t)column) return 1;
  }
  return 0;
}

/* Of all pairs of a free row and a free column takes the one of the highest value, again and again, until none is left
 * that is worth `at_least`. Element (row, column) is values[row * stride + column]: finite, or -INFINITY where the pair
 * is forbidden. Writes to choice[row] its column; comes in as NONE. Ties go to the lowest row, then the lowest column.
 */
static void best_pair_first(const double* values, uint32_t rows, uint32_t columns, uint32_t stride, double at_least,
                            int32_t* choice) {
  for (;;) {
    double best = -INFINITY;
    uint32_t best_row = 0, best_column = 0;
    for (uint32_t column = 0; column < columns; ++column) {
      if (taken(choice, rows, column)) continue;
      for (uint32_t row = 0; row < rows; ++row) {
        const double value = values[(size_t)row * stride + column];
        const int first = row < best_row || (row == best_row && column < best_column);
        if (choice[row] != NONE || value < at_least || !(value > best || (value == best && first))) continue;
        best = value;
        best_row = row;
        best_column = column;
      }
    }
    if (best == -INFINITY) return;
    choice[best_row] = (int32_t)best_column;
  }
}

/* --- The glue: the instance, the calls of its kind, what it is called and what can be set --- */

/* An instance works for one robot. */
typedef struct plugin {
  double at_least;
} plugin;

/* out comes in as REGISTA_NO_TASK, which is NONE. */
static int32_t assign(void* instance, const regista_frame* frame, const regista_matrix* utilities, int32_t* out,
                      regista_error* error) {
  const plugin* self = instance;
  (void)frame, (void)error;
  best_pair_first(utilities->values, utilities->rows, utilities->columns, utilities->stride, self->at_least, out);
  return REGISTA_OK;
}

static const regista_assigner calls = {.size = sizeof(regista_assigner), .assign = assign};

static const regista_parameter parameters[] = {{.size = sizeof(regista_parameter),
                                                .type = REGISTA_TYPE_REAL,
                                                .name = "at_least",
                                                .unit = "1",
                                                .doc = "Pairs of a lower utility are not taken",
                                                .minimum = 0.0,
                                                .maximum = 1.0,
                                                .initial = 0.0,
                                                .flags = REGISTA_PARAMETER_TUNABLE}};

static void set(plugin* self, const regista_environment* environment, regista_span values) {
  (void)environment;
  self->at_least = regista_number(values, 0);
}

/* The beginning of a match. */
static void begin(plugin* self, uint64_t seed) { (void)self, (void)seed; }

REGISTA_C_PLUGIN(plugin, REGISTA_KIND_ASSIGNER, calls, parameters, set, begin, .id = "@NAME@", .version = "0.1.0",
                 .summary = "The best pair of a free robot and a free task, again and again", .licence = "MIT",
                 .reads = REGISTA_READS_NOTHING);
