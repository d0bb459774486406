/* SPDX-License-Identifier: MIT
 *
 * Starts a thread at one call, which does its harm later, in whoever's call that is. The build says what, ZOO_THREAD,
 * and after how many microseconds, ZOO_LATER. */
#define _GNU_SOURCE
#include <pthread.h>
#include <signal.h>
#include <stdlib.h>
#include <unistd.h>

#include "zoo.h"

#ifndef ZOO_THREAD
#define ZOO_THREAD crash
#endif
#ifndef ZOO_LATER
#define ZOO_LATER 2000
#endif

static volatile int behind;
static volatile unsigned long counted;

void crash(void) {
  volatile int* volatile nothing = NULL;
  *nothing = 1;
}
void end_itself(void) { abort(); }
void leave(void) { exit(0); }
void leave_at_once(void) { _exit(3); }
void kill_all(void) { kill(getpid(), SIGKILL); }
void stop_all(void) { kill(getpid(), SIGSTOP); }
void burn(void) {
  for (;;) ++counted;
}
void sleep_on(void) {
  for (;;) sleep(3600);
}
void crash_when_behind(void) {
  while (!behind) usleep(100);
  crash();
}

static void* later(void* nothing) {
  usleep(ZOO_LATER);
  ZOO_THREAD();
  return nothing;
}

/* One thread for each process. */
void starts_a_thread(zoo_moment* now) {
  static int started;
  pthread_t thread;
  behind = now->frame != NULL && now->frame->mine->game->own_score < now->frame->mine->game->opponent_score;
  if (now->asked != ZOO_WHEN || started) return;
  started = 1;
  if (pthread_create(&thread, NULL, later, NULL) == 0) pthread_detach(thread);
}

void crashes_when_behind(zoo_moment* now) {
  if (now->asked >= ZOO_WHEN && now->frame->mine->game->own_score < now->frame->mine->game->opponent_score) crash();
}
