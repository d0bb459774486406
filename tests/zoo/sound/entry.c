/* SPDX-License-Identifier: MIT
 *
 * The descriptor of an animal. Where it is created and destroyed it is sound too, unless the build names a fault for
 * that: ZOO_AT_CREATE, ZOO_AT_DESTROY. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "zoo.h"

#ifdef ZOO_AT_CREATE
void ZOO_AT_CREATE(void);
#endif
#ifdef ZOO_AT_DESTROY
void ZOO_AT_DESTROY(void);
#endif

static const void* table(int32_t kind) { return kind == zoo_kind ? zoo_calls : NULL; }

static void* create(const regista_environment* environment, const regista_host* host, regista_span values,
                    regista_error* error) {
  zoo_instance* self = (zoo_instance*)calloc(1, sizeof *self);
  (void)values;
  if (self == NULL) {
    strcpy(error->text, "out of memory");
    return NULL;
  }
  self->robot = environment->own_number;
  self->x_limit = environment->field_length / 2;
  self->y_limit = environment->field_width / 2;
  self->host = host;
#ifdef ZOO_AT_CREATE
  ZOO_AT_CREATE();
#endif
  return self;
}

static int32_t reset(void* instance, uint64_t seed, regista_error* error) {
  zoo_instance* self = (zoo_instance*)instance;
  (void)seed;
  (void)error;
  self->asked = 0;
  self->known = 0;
  return REGISTA_OK;
}

static void destroy(void* instance) {
#ifdef ZOO_AT_DESTROY
  if (((zoo_instance*)instance)->asked > 0) ZOO_AT_DESTROY();
#endif
  free(instance);
}

static const regista_descriptor descriptor = {sizeof(regista_descriptor),
                                              REGISTA_ABI_MAJOR,
                                              REGISTA_ABI_MINOR,
                                              0,
                                              ZOO_ID,
                                              "1.0.0",
                                              "An animal of the zoo: wrong on purpose",
                                              "MIT",
                                              REGISTA_BUILD_TAG,
                                              NULL,
                                              sizeof(regista_parameter),
                                              0,
                                              table,
                                              create,
                                              reset,
                                              destroy,
                                              REGISTA_ABI_MAJOR,
                                              REGISTA_ABI_MINOR,
                                              REGISTA_READS_ALL,
                                              0,
                                              NULL};

const regista_descriptor* regista_plugin_entry(uint32_t host_major, uint32_t host_minor, uint32_t index) {
  (void)host_major;
  (void)host_minor;
  return index == 0 ? &descriptor : NULL;
}
