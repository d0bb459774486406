/* SPDX-License-Identifier: MIT
 * abi.h is plain C11 and has the layout that plugins were built with. */
#include "layout.h"

const regista_descriptor* regista_plugin_entry(uint32_t host_major, uint32_t host_minor, uint32_t index) {
  (void)host_major;
  (void)host_minor;
  (void)index;
  return NULL;
}
