/* SPDX-License-Identifier: MIT
 *
 * What every plugin in C would write for itself: reading arrays of the host, and the end of the file, where the
 * instance is made and the plugin says what it is. C11, no state. A plugin needs nothing of it: <regista/abi.h> is the
 * interface. */
#ifndef REGISTA_C_H
#define REGISTA_C_H

#include <stdlib.h>
#include <string.h>

#include <regista/abi.h>

/* Element i of an array of the host. Elements may be larger than this header knows: hence the stride. */
static inline const void* regista_element(regista_span span, uint32_t i) {
  return (const char*)span.data + (size_t)i * span.stride;
}

/* The value of parameter i, in the order in which the plugin declares them: a number, or 0 and 1 of a boolean. */
static inline double regista_number(regista_span values, uint32_t i) {
  return ((const regista_value*)regista_element(values, i))->number;
}

/* A file with one plugin ends with this, and a semicolon.
 *
 *   type        of an instance; it comes zeroed from calloc, and is freed when the host is done with it
 *   kind, calls REGISTA_KIND_..., and the table of that kind, an object
 *   parameters  an array of regista_parameter
 *   set         static void set(type* self, const regista_environment* environment, regista_span values)
 *   begin       static void begin(type* self, uint64_t seed): a match begins; the instance may have played one before
 *   ...         fields of regista_descriptor: .id, .version, .summary, .licence and .reads at least */
#define REGISTA_C_PLUGIN(type, kind, calls, parameters_, set, begin, ...)                                              \
  static const void* regista_c_table(int32_t asked) { return asked == (kind) ? &(calls) : NULL; }                      \
  static void* regista_c_create(const regista_environment* environment, const regista_host* host, regista_span values, \
                                regista_error* error) {                                                                \
    type* self = calloc(1, sizeof *self);                                                                              \
    (void)host;                                                                                                        \
    if (self == NULL) {                                                                                                \
      strcpy(error->text, "out of memory");                                                                            \
      return NULL;                                                                                                     \
    }                                                                                                                  \
    set(self, environment, values);                                                                                    \
    return self;                                                                                                       \
  }                                                                                                                    \
  static int32_t regista_c_reset(void* instance, uint64_t seed, regista_error* error) {                                \
    (void)error;                                                                                                       \
    begin(instance, seed);                                                                                             \
    return REGISTA_OK;                                                                                                 \
  }                                                                                                                    \
  static const regista_descriptor regista_c_descriptor = {                                                             \
      .size = sizeof(regista_descriptor),                                                                              \
      .abi_major = REGISTA_ABI_MAJOR,                                                                                  \
      .abi_minor = REGISTA_ABI_MINOR,                                                                                  \
      .minimum_major = REGISTA_ABI_MAJOR,                                                                              \
      .minimum_minor = REGISTA_ABI_MINOR,                                                                              \
      .build_tag = REGISTA_BUILD_TAG,                                                                                  \
      .parameters = (parameters_),                                                                                     \
      .parameter_count = sizeof(parameters_) / sizeof(regista_parameter),                                              \
      .parameter_stride = sizeof(regista_parameter),                                                                   \
      .table = regista_c_table,                                                                                        \
      .create = regista_c_create,                                                                                      \
      .reset = regista_c_reset,                                                                                        \
      .destroy = free,                                                                                                 \
      __VA_ARGS__};                                                                                                    \
  const regista_descriptor* regista_plugin_entry(uint32_t host_major, uint32_t host_minor, uint32_t index) {           \
    (void)host_major, (void)host_minor;                                                                                \
    return index == 0 ? &regista_c_descriptor : NULL;                                                                  \
  }                                                                                                                    \
  typedef type regista_c_instance

#endif
