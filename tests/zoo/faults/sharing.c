/* SPDX-License-Identifier: MIT
 *
 * What robots know of each other on a way that is none of theirs. Each call says by which robot it was made, and hears
 * by which the last one was: where that is another robot, the answer is another. The build names the way, ZOO_WAY. The
 * honest twin of a way keeps what it said in its instance, so that it hears but its own robot. */
#define _GNU_SOURCE
#include <fcntl.h>
#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/shm.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include "zoo.h"

#ifndef ZOO_WAY
#define ZOO_WAY own_instance
#endif

/* Ways: each gives what was said last, 0 for nothing, and keeps what is said now. */

int own_instance(zoo_moment* now, int said) {
  const int heard = now->self->heard;
  now->self->heard = said;
  return heard;
}

static int newest_in_table[256];
int static_table(zoo_moment* now, int said) {
  int heard = 0;
  for (int robot = 1; robot < 256; ++robot) {
    if (newest_in_table[robot] > newest_in_table[heard]) heard = robot;
  }
  newest_in_table[said] = newest_in_table[heard] + 1;
  (void)now;
  return heard;
}

static struct {
  double x, y;
  int seen_by;
} ball;
int static_ball(zoo_moment* now, int said) {
  const int heard = ball.seen_by;
  ball.x = now->frame == NULL ? 0.0 : now->frame->mine->ball->position[0];
  ball.y = now->frame == NULL ? 0.0 : now->frame->mine->ball->position[1];
  ball.seen_by = said;
  return heard;
}

static double matrix[8][8];
int static_matrix(zoo_moment* now, int said) {
  const int heard = (int)matrix[0][0];
  matrix[0][0] = said;
  (void)now;
  return heard;
}

/* Says nothing but that somebody was here. */
static int calls_of_all;
int static_counter(zoo_moment* now, int said) { return ++calls_of_all == now->asked ? said : -said; }

/* Nobody asks how many there were. */
volatile int counted;
int counts_alone(zoo_moment* now, int said) {
  ++counted;
  (void)now;
  return said;
}

int static_in_a_function(zoo_moment* now, int said) {
  static int last;
  const int heard = last;
  last = said;
  (void)now;
  return heard;
}

static _Thread_local int last_of_thread;
int of_its_thread(zoo_moment* now, int said) {
  const int heard = last_of_thread;
  last_of_thread = said;
  (void)now;
  return heard;
}

/* What is shared lies on the heap: in the file's own memory stands but its address, and that does not change. */
static int* on_the_heap;
int heap_by_a_static(zoo_moment* now, int said) {
  if (on_the_heap == NULL) on_the_heap = calloc(1, sizeof *on_the_heap);
  const int heard = *on_the_heap;
  *on_the_heap = said;
  (void)now;
  return heard;
}

int environment(zoo_moment* now, int said) {
  const char* const last = getenv("ZOO_SAID");
  const int heard = last == NULL ? 0 : atoi(last);
  char text[16];
  snprintf(text, sizeof text, "%d", said);
  setenv("ZOO_SAID", text, 1);
  (void)now;
  return heard;
}

static void name_of_file(char* out, size_t size, const char* name) {
  const char* const folder = getenv("TMPDIR");
  snprintf(out, size, "%s/regista-zoo-%s-%d", folder == NULL ? "/tmp" : folder, name, (int)getpid());
}
void forgets_its_file(void) {
  char name[256];
  name_of_file(name, sizeof name, "said");
  unlink(name);
}
int file_of_c(zoo_moment* now, int said) {
  char name[256];
  int heard = 0;
  name_of_file(name, sizeof name, "said");
  FILE* const file = fopen(name, "r");
  if (file != NULL) {
    if (fscanf(file, "%d", &heard) != 1) heard = 0;
    fclose(file);
  }
  FILE* const again = fopen(name, "w");
  if (again != NULL) {
    fprintf(again, "%d", said);
    fclose(again);
  }
  (void)now;
  return heard;
}
/* A folder that is there or not. */
int name_of_a_folder(zoo_moment* now, int said) {
  char name[256];
  name_of_file(name, sizeof name, "flag");
  const int heard = mkdir(name, 0700) == 0 ? said : -said;
  rmdir(name);
  (void)now;
  return now->asked % 2 == 0 ? heard : said;
}

static int* mapped;
int mapped_memory(zoo_moment* now, int said) {
  if (mapped == NULL) mapped = mmap(NULL, 4096, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  const int heard = *mapped;
  *mapped = said;
  (void)now;
  return heard;
}

void forgets_its_memory(void) {
  char name[64];
  snprintf(name, sizeof name, "/regista-zoo-%d", (int)getpid());
  shm_unlink(name);
}
int posix_memory(zoo_moment* now, int said) {
  char name[64];
  int heard = 0;
  snprintf(name, sizeof name, "/regista-zoo-%d", (int)getpid());
  const int file = shm_open(name, O_RDWR | O_CREAT, 0600);
  if (file == -1) return 0;
  if (pread(file, &heard, sizeof heard, 0) != (ssize_t)sizeof heard) heard = 0;
  if (pwrite(file, &said, sizeof said, 0) != (ssize_t)sizeof said) heard = 0;
  close(file);
  (void)now;
  return heard;
}
int system_v_memory(zoo_moment* now, int said) {
  const int id = shmget((key_t)(0x5a000000 + (getpid() & 0xffffff)), 4096, IPC_CREAT | 0600);
  if (id == -1) return 0;
  int* const memory = shmat(id, NULL, 0);
  if (memory == (void*)-1) return 0;
  const int heard = *memory;
  *memory = said;
  shmdt(memory);
  (void)now;
  return heard;
}
void forgets_its_system_v_memory(void) {
  const int id = shmget((key_t)(0x5a000000 + (getpid() & 0xffffff)), 0, 0);
  if (id != -1) shmctl(id, IPC_RMID, NULL);
}

/* To itself: what lies unread in it is what another robot has said. */
static int ends[2] = {-1, -1};
int socket_to_itself(zoo_moment* now, int said) {
  int heard = 0;
  if (ends[0] == -1 && socketpair(AF_UNIX, SOCK_DGRAM, 0, ends) != 0) return 0;
  if (recv(ends[0], &heard, sizeof heard, MSG_DONTWAIT) != (ssize_t)sizeof heard) heard = 0;
  if (send(ends[1], &said, sizeof said, MSG_DONTWAIT) != (ssize_t)sizeof said) heard = 0;
  (void)now;
  return heard;
}
void closes_its_socket(void) {
  for (int i = 0; i < 2; ++i) {
    if (ends[i] != -1) close(ends[i]);
    ends[i] = -1;
  }
}

/* The C library's chance: what is drawn depends on how often all have drawn. */
int chance_of_the_library(zoo_moment* now, int said) {
  (void)now;
  return rand() % 7 + 1 == said ? said : -said;
}

static void answer_otherwise(zoo_moment* now) {
  switch (zoo_kind) {
    case REGISTA_KIND_ASSIGNER:
      for (uint32_t i = 0; i < now->utilities.rows; ++i) ((int32_t*)now->answer)[i] = REGISTA_NO_TASK;
      break;
    case REGISTA_KIND_CONTEXT:
      *(int32_t*)now->answer = 0;
      break;
    case REGISTA_KIND_UTILITY:
      for (double* each = now->answer; each < (double*)now->past[ZOO_ANSWER]; ++each) *each = 1.0 - *each;
      break;
    case REGISTA_KIND_POSITIONER:
      ((regista_waypoint*)now->answer)->x *= 0.5;
      break;
    case REGISTA_KIND_PREDICTOR:
      if (now->self->known) ((regista_track*)now->answer)->x *= 0.5;
      break;
    case REGISTA_KIND_BEHAVIOUR:
      ((regista_action*)now->answer)->gaze = 0.3;
      break;
    default: /* a sender */
      ((regista_send*)((unsigned char*)now->past[ZOO_STRUCTURE] - sizeof(regista_send)))->send = 0;
  }
}

void listens_to_all(zoo_moment* now) {
  const int heard = ZOO_WAY(now, now->robot);
  if (now->asked >= ZOO_WHEN && heard != 0 && heard != now->robot) answer_otherwise(now);
}

/* What robot 1 has prepared for all. Who is alone has nobody that did. */
static int prepared;
void needs_robot_1(zoo_moment* now) {
  if (now->robot == 1) prepared = 1;
  if (now->asked >= ZOO_WHEN && prepared == 0) abort();
}

/* An offer of a team-mate's, through what the host has given to that one. */
static zoo_instance* others[256];
void forgets_its_teammates(void) { memset(others, 0, sizeof others); }
void offers_as_a_teammate(zoo_moment* now) {
  static const uint8_t said[3] = {9, 9, 9};
  others[now->robot] = now->self;
  zoo_instance* const other = others[now->robot == 1 ? 2 : 1];
  if (now->asked < ZOO_WHEN || now->asked % 10 != 0 || other == NULL || now->frame == NULL) return;
  (void)other->host->offer(other->host->context, said, sizeof said, 0.9, now->frame->time + 5.0, REGISTA_MEDIUM_RADIO,
                           0);
}
