/* SPDX-License-Identifier: MIT
 *
 * The idea alone. What plugin.c has is tested where it stands, static functions too. */
#undef NDEBUG /* a release build tests as well */
#include <assert.h>

#define REGISTA_BUILD_TAG "test"
#include "plugin.c"

static void is_one_there_and_a_half_where_it_was_asked(void) {
  assert(nearness(0.0, 2.0) == 1.0);
  assert(nearness(2.0, 2.0) == 0.5);
}

static void falls_with_the_distance(void) {
  for (int i = 0; i < 200; ++i) {
    assert(nearness(0.1 * i, 2.0) > nearness(0.1 * (i + 1), 2.0));
    assert(nearness(0.1 * i, 2.0) > 0.0);
  }
}

int main(void) {
  is_one_there_and_a_half_where_it_was_asked();
  falls_with_the_distance();
  return 0;
}
