/* SPDX-License-Identifier: MIT
 * Opens the plugin `indifferent` as a host would and checks what it answers. */
#include <dlfcn.h>
#include <regista/abi.h>
#include <stdio.h>
#include <string.h>

#define REQUIRE(condition)                              \
  if (!(condition)) {                                   \
    fprintf(stderr, "does not hold: %s\n", #condition); \
    return 1;                                           \
  }

typedef const regista_descriptor* entry_function(uint32_t, uint32_t, uint32_t);

int main(int argument_count, char** arguments) {
  REQUIRE(argument_count == 2);
  void* library = dlopen(arguments[1], RTLD_NOW | RTLD_LOCAL);
  if (!library) fprintf(stderr, "%s\n", dlerror());
  REQUIRE(library);
  entry_function* entry;
  void* symbol = dlsym(library, REGISTA_ENTRY_NAME);
  memcpy(&entry, &symbol, sizeof entry);
  REQUIRE(entry);

  const regista_descriptor* plugin = entry(REGISTA_ABI_MAJOR, REGISTA_ABI_MINOR, 0);
  REQUIRE(plugin && !entry(REGISTA_ABI_MAJOR, REGISTA_ABI_MINOR, 1));
  REQUIRE(plugin->size == sizeof *plugin && plugin->abi_major == REGISTA_ABI_MAJOR &&
          plugin->abi_minor == REGISTA_ABI_MINOR);
  REQUIRE(!strcmp(plugin->id, "indifferent"));
  REQUIRE(strlen(plugin->build_tag) > 0);
  REQUIRE(!plugin->table(REGISTA_KIND_SENDER));
  const regista_utility* utility = plugin->table(REGISTA_KIND_UTILITY);
  REQUIRE(utility);

  regista_error error = {""};
  const regista_value value = {.number = 0.25};
  void* instance = plugin->create(NULL, NULL, (regista_span){&value, 1, sizeof value}, &error);
  REQUIRE(instance);
  REQUIRE(plugin->reset(instance, 1, &error) == REGISTA_OK);
  double values[2][4] = {{0}}; /* the last column lies beyond the matrix */
  const regista_matrix_room matrix = {.values = &values[0][0], .rows = 2, .columns = 3, .stride = 4};
  REQUIRE(utility->score(instance, NULL, &matrix, &error) == REGISTA_OK);
  for (int row = 0; row < 2; ++row) {
    for (int column = 0; column < 3; ++column) REQUIRE(values[row][column] == 0.25);
    REQUIRE(values[row][3] == 0.0);
  }
  plugin->destroy(instance);
  return 0;
}
