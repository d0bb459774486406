/* SPDX-License-Identifier: MIT
 *
 * Lets the system end the process a moment later, in whoever's call that is. */
#define _GNU_SOURCE
#include <signal.h>
#include <string.h>
#include <sys/time.h>
#include <time.h>

#include "zoo.h"

enum { ZOO_SOON = 2000 }; /* microseconds: before the match is over */

static void start(int which) {
  const struct itimerval soon = {{0, 0}, {0, ZOO_SOON}};
  setitimer(which, &soon, NULL);
}

void sets_an_alarm(zoo_moment* now) {
  if (now->asked == ZOO_WHEN) start(ITIMER_REAL);
}

void sets_an_alarm_of_processor_time(zoo_moment* now) {
  if (now->asked == ZOO_WHEN) start(ITIMER_PROF);
}

void makes_a_timer(zoo_moment* now) {
  struct sigevent event;
  const struct itimerspec soon = {{0, 0}, {0, ZOO_SOON * 1000L}};
  timer_t timer;
  if (now->asked != ZOO_WHEN) return;
  memset(&event, 0, sizeof event);
  event.sigev_notify = SIGEV_SIGNAL;
  event.sigev_signo = SIGTERM;
  if (timer_create(CLOCK_MONOTONIC, &event, &timer) == 0) timer_settime(timer, 0, &soon, NULL);
}
