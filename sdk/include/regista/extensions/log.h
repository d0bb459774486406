/* SPDX-License-Identifier: MIT
 *
 * Extension "regista.log/0", a draft: lines of a plugin for people. The host's side alone; a host that has none gives
 * null, and a plugin does without. C++: <regista/log.hpp>.
 *
 * `regista match` shows the lines on standard error at once, and a recording holds them. A campaign keeps the first
 * warnings and errors of each team with the match. What is logged changes no match: it decides nothing, and nothing
 * tells whether somebody reads it.
 */
/* clang-format off */
#ifndef REGISTA_EXTENSIONS_LOG_H
#define REGISTA_EXTENSIONS_LOG_H

#include <stdint.h>

#define REGISTA_LOG_EXTENSION "regista.log/0"

enum { REGISTA_LOG_DEBUG = 1, REGISTA_LOG_INFO = 2, REGISTA_LOG_WARNING = 3, REGISTA_LOG_ERROR = 4 };

enum {
  REGISTA_LOG_MOST_BYTES = 1000,     /* of one line; what is longer is cut */
  REGISTA_LOG_MOST_LINES = 64,       /* of one instance in one decision, */
  REGISTA_LOG_MOST_OF_MATCH = 262144 /* bytes of one instance in one match; what is more is left out, and the host
                                        says so once */
};

/* Lives as long as the instance that asked for it. */
typedef struct regista_log {
  uint32_t size;
  uint32_t reserved;
  void* context;                     /* first argument of the call below */
  /* One line of UTF-8, `length` bytes or up to the first zero, copied. Only from within the instance's own calls, but nothing is taken
   * in `describe`. The host adds team, robot, tick and plugin. A level that is not named here is read as REGISTA_LOG_INFO. */
  void (*write)(void* context, int32_t level, const char* text, uint32_t length);
} regista_log;

#endif /* REGISTA_EXTENSIONS_LOG_H */
