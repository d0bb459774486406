/* SPDX-License-Identifier: MIT
 * A plugin of another major version, whose list of descriptors never ends. */
#include <regista/abi.h>

static const regista_descriptor descriptor = {
    .size = sizeof(regista_descriptor), .abi_major = 2, .abi_minor = 0, .id = "other_major", .version = "1.0.0"};

const regista_descriptor* regista_plugin_entry(uint32_t host_major, uint32_t host_minor, uint32_t index) {
  (void)host_major;
  (void)host_minor;
  (void)index;
  return &descriptor;
}
