/* SPDX-License-Identifier: MIT
 *
 * The idea alone. What plugin.c has is tested where it stands, static functions too. */
#undef NDEBUG /* a release build tests as well */
#include <assert.h>

#define REGISTA_BUILD_TAG "test"
#include "plugin.c"

static void takes_the_highest_value_and_then_the_highest_that_is_left(void) {
  const double values[] = {0.8, 0.9, 0.1, 0.7};
  int32_t choice[] = {NONE, NONE};
  best_pair_first(values, 2, 2, 2, 0.0, choice);
  assert(choice[0] == 1 && choice[1] == 0);
}

static void leaves_a_forbidden_pair(void) {
  const double values[] = {-INFINITY, -INFINITY};
  int32_t choice[] = {NONE, NONE};
  best_pair_first(values, 2, 1, 1, 0.0, choice);
  assert(choice[0] == NONE && choice[1] == NONE);
}

static void leaves_what_is_not_worth_it(void) {
  const double values[] = {0.9, 0.0, 0.0, 0.2};
  int32_t choice[] = {NONE, NONE};
  best_pair_first(values, 2, 2, 2, 0.5, choice);
  assert(choice[0] == 0 && choice[1] == NONE);
}

int main(void) {
  takes_the_highest_value_and_then_the_highest_that_is_left();
  leaves_a_forbidden_pair();
  leaves_what_is_not_worth_it();
  return 0;
}
