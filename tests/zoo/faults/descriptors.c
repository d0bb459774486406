/* SPDX-License-Identifier: MIT
 *
 * Closes, opens and fills files that are not its own. */
#define _GNU_SOURCE
#include <fcntl.h>
#include <string.h>
#include <unistd.h>

#include "zoo.h"

void closes_everything(zoo_moment* now) {
  if (now->asked != ZOO_WHEN) return;
  for (int descriptor = 0; descriptor <= 100; ++descriptor) close(descriptor);
}

void leaves_files_open(zoo_moment* now) {
  if (now->asked != ZOO_WHEN || now->robot != 1) return;
  for (int i = 0; i < 200; ++i) {
    if (open("/dev/null", O_RDONLY) == -1) return;
  }
}

static void write_lines(int descriptor, int lines) {
  char line[1024];
  memset(line, 'z', sizeof line);
  line[sizeof line - 1] = '\n';
  for (int i = 0; i != lines; ++i) {
    if (write(descriptor, line, sizeof line) < 0) return;
  }
}

/* ZOO_DESCRIPTOR: into which. */
#ifndef ZOO_DESCRIPTOR
#define ZOO_DESCRIPTOR 2
#endif
void writes_a_megabyte(zoo_moment* now) {
  if (now->asked == ZOO_WHEN && now->robot == 1) write_lines(ZOO_DESCRIPTOR, 1024);
}

void writes_without_end(zoo_moment* now) {
  if (now->asked != ZOO_WHEN) return;
  for (;;) write_lines(ZOO_DESCRIPTOR, -1);
}

void writes_into_every_file(zoo_moment* now) {
  if (now->asked != ZOO_WHEN || now->robot != 1) return;
  for (int descriptor = 3; descriptor < 64; ++descriptor) {
    if (write(descriptor, "{\"kind\":", 8) < 0) continue;
  }
}
