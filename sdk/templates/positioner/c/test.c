/* SPDX-License-Identifier: MIT
 *
 * The idea alone. What plugin.c has is tested where it stands, static functions too. */
#undef NDEBUG /* a release build tests as well */
#include <assert.h>

#define REGISTA_BUILD_TAG "test"
#include "plugin.c"

static const double field[2] = {4.5, 3.0};

static void is_even_and_counter_clockwise(void) {
  const double centre[2] = {1.0, 1.0}, x[] = {1.5, 1.0, 0.5, 1.0}, y[] = {1.0, 1.5, 1.0, 0.5};
  double points[4][2];
  ring(centre, 0.5, 4, field, points);
  for (int i = 0; i < 4; ++i) assert(fabs(points[i][0] - x[i]) < 1e-12 && fabs(points[i][1] - y[i]) < 1e-12);
}

static void stays_on_the_field(void) {
  const double centre[2] = {4.4, -2.9};
  double points[12][2];
  ring(centre, 2.0, 12, field, points);
  for (int i = 0; i < 12; ++i) assert(fabs(points[i][0]) <= 4.5 && fabs(points[i][1]) <= 3.0);
}

int main(void) {
  is_even_and_counter_clockwise();
  stays_on_the_field();
  return 0;
}
