/* SPDX-License-Identifier: MIT
 *
 * Extension "regista.told/0", a draft: what robots of the own team said last, as they said it, whether this robot
 * itself sees the ball, and whom it is about to pass to. A frame has all of that too, but carried forward to now and
 * fused with the rest; systems that decide by what was communicated, and senders that ask what others must believe,
 * need it as it was. The host's side only: what regista_host.extension gives. A host that has none gives null, and a
 * plugin does without. C++: <regista/told.hpp>.
 */
/* clang-format off */
#ifndef REGISTA_EXTENSIONS_TOLD_H
#define REGISTA_EXTENSIONS_TOLD_H

#include <stdint.h>

#define REGISTA_TOLD_EXTENSION "regista.told/0"

enum {
  REGISTA_TOLD_BALL = 1,             /* the sender told of a ball that it had seen itself */
  REGISTA_TOLD_FALLEN = 2
};

/* Of the core of a packet, as all who heard it decoded it: in fixed point. Field frame of the own team. */
typedef struct regista_told_packet {
  uint32_t size;                     /* set by the caller: what it has room for */
  uint32_t flags;                    /* REGISTA_TOLD_* */
  double time_sent;                  /* s of match time */
  double pose[3];                    /* x, y, heading */
  double velocity[2];
  double target[2];                  /* where it said to walk to */
  int32_t role;                      /* -1 = none */
  int32_t context;
  double role_since;                 /* s of match time */
  double ball[2], ball_velocity[2];  /* 0 without a ball */
  double ball_age;                   /* s since the sender saw it, when the packet left */
} regista_told_packet;

/* Lives as long as the instance that asked for it. */
typedef struct regista_told {
  uint32_t size;
  uint32_t reserved;
  void* context;                     /* first argument of the calls below */
  /* The newest packet of the robot with this shirt number; of the own number the last one that this robot sent. 1, or 0
   * and nothing is written: none was heard, or there is no such robot. */
  int32_t (*packet)(void* context, int32_t number, regista_told_packet* out);
  /* 1: the robot sees a ball in the image of this decision. A false detection counts, too. */
  int32_t (*sees_ball)(void* context);
  /* The teammate for which the kick of this decision is meant, as its behaviour said (regista.pass/0); 0 = nobody, and
   * before it has acted. A sender decides after it. */
  int32_t (*receiver)(void* context);
} regista_told;

#endif /* REGISTA_EXTENSIONS_TOLD_H */
