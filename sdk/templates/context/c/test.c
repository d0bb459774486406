/* SPDX-License-Identifier: MIT
 *
 * The idea alone. What plugin.c has is tested where it stands, static functions too. */
#undef NDEBUG /* a release build tests as well */
#include <assert.h>

#define REGISTA_BUILD_TAG "test"
#include "plugin.c"

static void begins_below_the_distance(void) {
  assert(!is_near(0, 2.1, 2.0, 0.5));
  assert(is_near(0, 1.9, 2.0, 0.5));
}

static void ends_above_the_margin(void) {
  assert(is_near(1, 2.4, 2.0, 0.5));
  assert(!is_near(1, 2.6, 2.0, 0.5));
}

int main(void) {
  begins_below_the_distance();
  ends_above_the_margin();
  return 0;
}
