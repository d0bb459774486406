/* SPDX-License-Identifier: MIT
 *
 * Answers by what is not its input: addresses, the clock, the environment, the number of the process. The two best tasks change places,
 * or the ball is not seen. */
#define _GNU_SOURCE
#include <stdint.h>
#include <stdlib.h>
#include <time.h>
#include <unistd.h>

#include "zoo.h"

uint64_t address_on_the_stack(void) {
  int local = 0;
  return (uint64_t)(uintptr_t)&local;
}

uint64_t address_on_the_heap(void) {
  void* const block = malloc(64);
  const volatile uint64_t address = (uint64_t)(uintptr_t)block;
  free(block);
  return address;
}

uint64_t address_of_its_own_data(void) {
  static const int data = 1;
  return (uint64_t)(uintptr_t)&data;
}

uint64_t address_of_a_function_of_the_system(void) { return (uint64_t)(uintptr_t)&getenv; }

uint64_t home_of_the_user(void) {
  uint64_t hash = 0;
  const char* const home = getenv("HOME");
  for (const char* each = home == NULL ? "none" : home; *each != '\0'; ++each) hash = 31 * hash + (unsigned char)*each;
  return hash;
}

uint64_t number_of_the_process(void) { return (uint64_t)getpid(); }

uint64_t the_time(void) {
  struct timespec now;
  clock_gettime(CLOCK_REALTIME, &now);
  return (uint64_t)now.tv_nsec;
}

#ifndef ZOO_SOURCE
#define ZOO_SOURCE address_on_the_stack
#endif

/* A context: holds by chance. */
void decides_by_chance(zoo_moment* now) {
  uint64_t mixed = ZOO_SOURCE() * 0x9e3779b97f4a7c15u + (uint64_t)now->asked;
  mixed ^= mixed >> 32;
  mixed *= 0xd6e8feb86659fd93u;
  if (now->asked >= ZOO_WHEN && (mixed >> 60) < 8) *(int32_t*)now->answer = 0;
}

/* In a third of all processes. */
void dies_now_and_then(zoo_moment* now) {
  if (now->asked == ZOO_WHEN && getpid() % 3 == 0) abort();
}
