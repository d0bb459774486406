/* SPDX-License-Identifier: MIT
 *
 * The idea alone. What plugin.c has is tested where it stands, static functions too. */
#undef NDEBUG /* a release build tests as well */
#include <assert.h>

#define REGISTA_BUILD_TAG "test"
#include "plugin.c"

static void waits_for_its_period_without_news(void) {
  assert(!due(10.0, 2.0, 9.9, 0, 100, 90.0));
  assert(due(10.0, 2.0, 10.0, 0, 100, 110.0));
}

static void news_do_not_wait(void) {
  assert(due(10.0, 2.0, 2.0, 1, 100, 100.0));
  assert(!due(10.0, 2.0, 1.9, 1, 100, 100.0));
}

static void news_wait_while_too_much_was_spent(void) {
  assert(!due(10.0, 2.0, 9.9, 1, 99, 100.0));
  assert(due(10.0, 2.0, 10.0, 1, 99, 100.0));
}

static void spends_nothing_that_is_not_there(void) {
  assert(!due(10.0, 2.0, 100.0, 1, 0, 0.0));
  assert(!due(10.0, 2.0, 100.0, 1, -1, -1.0));
}

int main(void) {
  waits_for_its_period_without_news();
  news_do_not_wait();
  news_wait_while_too_much_was_spent();
  spends_nothing_that_is_not_there();
  return 0;
}
