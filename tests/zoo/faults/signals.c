/* SPDX-License-Identifier: MIT
 *
 * Ends its process in the middle of a call. */
#define _GNU_SOURCE
#include <setjmp.h>
#include <signal.h>
#include <stdlib.h>
#include <unistd.h>

#include "zoo.h"

void writes_to_null(zoo_moment* now) {
  volatile int* volatile nothing = NULL;
  if (now->asked == ZOO_WHEN) *nothing = 1;
}

void aborts(zoo_moment* now) {
  if (now->asked == ZOO_WHEN) abort();
}

void exits(zoo_moment* now) {
  if (now->asked == ZOO_WHEN) exit(0);
}

void exits_at_once(zoo_moment* now) {
  if (now->asked == ZOO_WHEN) _exit(0);
}

/* ZOO_SIGNAL: which; to the whole process, as other people would. */
#ifndef ZOO_SIGNAL
#define ZOO_SIGNAL SIGKILL
#endif
void sends_itself_a_signal(zoo_moment* now) {
  if (now->asked == ZOO_WHEN) kill(getpid(), ZOO_SIGNAL);
}

/* As an instruction of its own would: to the thread. */
void raises_a_signal(zoo_moment* now) {
  if (now->asked == ZOO_WHEN) raise(ZOO_SIGNAL);
}

static volatile int deeper = 1;

static int depth(volatile char* caller) {
  volatile char room[4096];
  room[0] = caller == NULL ? 1 : caller[0];
  return deeper ? depth(room) + room[0] : 0;
}

void overflows_the_stack(zoo_moment* now) {
  if (now->asked == ZOO_WHEN) depth(NULL);
}

static jmp_buf earlier;
static volatile int returns;

/* Goes back to where an earlier call of it stood, which has returned since. */
void jumps_out_of_the_call(zoo_moment* now) {
  if (now->asked == ZOO_WHEN - 1 && setjmp(earlier) != 0) abort();
  if (now->asked == ZOO_WHEN && returns++ == 0) longjmp(earlier, 1);
}
