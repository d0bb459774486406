/* SPDX-License-Identifier: MIT
 *
 * Changes what belongs to the process, and makes others. */
#define _GNU_SOURCE
#include <signal.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <unistd.h>

#include "zoo.h"

/* Three, once for each process. */
static int first(zoo_moment* now) { return now->asked == ZOO_WHEN && now->robot == 2; }

void forks_and_leaves_them(zoo_moment* now) {
  for (int i = 0; first(now) && i < 3; ++i) {
    if (fork() == 0) {
      for (;;) pause();
    }
  }
}

/* The children go on as if they were the host. */
void forks_and_both_return(zoo_moment* now) {
  if (!first(now)) return;
  if (fork() == 0) return;
  if (fork() == 0) return;
}

/* Out of its process group and session, and not its parent's child. */
void forks_a_daemon(zoo_moment* now) {
  if (!first(now) || fork() != 0) return;
  setsid();
  if (fork() != 0) _exit(0);
  for (;;) pause();
}

void becomes_another_program(zoo_moment* now) {
  if (now->asked == ZOO_WHEN) execl("/bin/true", "true", (char*)NULL);
}

void changes_the_folder(zoo_moment* now) {
  if (now->asked == ZOO_WHEN && chdir("/") != 0) abort();
}

static void ignore(int number) { (void)number; }

/* ZOO_SIGNAL: of which. */
#ifndef ZOO_SIGNAL
#define ZOO_SIGNAL SIGSEGV
#endif
void takes_a_handler(zoo_moment* now) {
  if (now->asked == ZOO_WHEN) signal(ZOO_SIGNAL, ignore);
}

void blocks_signals(zoo_moment* now) {
  sigset_t all;
  if (now->asked != ZOO_WHEN) return;
  sigfillset(&all);
  sigprocmask(SIG_SETMASK, &all, NULL);
}

void lowers_a_limit(zoo_moment* now) {
  const struct rlimit nothing = {0, 0};
  if (now->asked == ZOO_WHEN) setrlimit(RLIMIT_NOFILE, &nothing);
}
