/* SPDX-License-Identifier: MIT
 *
 * The idea alone. What plugin.c has is tested where it stands, static functions too. */
#undef NDEBUG /* a release build tests as well */
#include <assert.h>

#define REGISTA_BUILD_TAG "test"
#include "plugin.c"

static const moving_ball rolling = {
    .x = 1.0, .y = 2.0, .vx = 0.5, .vy = -1.0, .place = 0.01, .cross = 0.02, .velocity = 0.1};

static void keeps_its_velocity(void) {
  moving_ball ball = rolling;
  advance(&ball, 2.0, 1.0);
  assert(ball.x == 2.0 && ball.y == 0.0 && ball.vx == 0.5 && ball.age == 2.0);
}

static void is_less_certain_the_longer_it_is_unseen(void) {
  moving_ball ball = rolling;
  for (int tick = 0; tick < 50; ++tick) {
    const double before = ball.place;
    advance(&ball, 0.1, 1.0);
    assert(ball.place > before);
  }
}

static void learns_a_velocity_from_where_it_is_seen(void) {
  moving_ball ball = {.place = 0.01, .velocity = 1.0};
  for (int tick = 1; tick <= 30; ++tick) {
    advance(&ball, 0.1, 0.1);
    take(&ball, 0.1 * tick, -0.05 * tick, 0.01);
  }
  assert(fabs(ball.x - 3.0) < 0.05 && fabs(ball.vx - 1.0) < 0.05 && fabs(ball.vy + 0.5) < 0.05);
  assert(ball.place < 0.01 && ball.age == 0.0);
}

int main(void) {
  keeps_its_velocity();
  is_less_certain_the_longer_it_is_unseen();
  learns_a_velocity_from_where_it_is_seen();
  return 0;
}
