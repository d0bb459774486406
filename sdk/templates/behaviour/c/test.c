/* SPDX-License-Identifier: MIT
 *
 * The idea alone. What plugin.c has is tested where it stands, static functions too. */
#undef NDEBUG /* a release build tests as well */
#include <assert.h>

#define REGISTA_BUILD_TAG "test"
#include "plugin.c"

static void keeps_a_place_that_is_far_enough(void) {
  const double ball[2] = {1.0, 0.0};
  const place stand = beside(ball, -2.0, 0.0, 1.0);
  assert(stand.x == -2.0 && stand.y == 0.0 && stand.heading == 0.0);
}

static void goes_straight_away_from_the_ball(void) {
  const double ball[2] = {1.0, 1.0};
  const place stand = beside(ball, 1.0, 1.5, 2.0);
  assert(stand.x == 1.0 && stand.y == 3.0 && stand.heading < 0.0);
}

static void stands_behind_a_ball_that_is_wanted(void) {
  const double ball[2] = {0.5, 0.25};
  const place stand = beside(ball, 0.5, 0.25, 1.0);
  assert(stand.x == -0.5 && stand.y == 0.25 && stand.heading == 0.0);
}

int main(void) {
  keeps_a_place_that_is_far_enough();
  goes_straight_away_from_the_ball();
  stands_behind_a_ball_that_is_wanted();
  return 0;
}
