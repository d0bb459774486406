// SPDX-License-Identifier: MIT
// libFuzzer target: build with clang and -DREGISTA_FUZZ=ON, run
//   mkdir CORPUS && bin/fuzz_table -max_len=4000 CORPUS
#include <unistd.h>

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "fuzz/table/table_from_bytes.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::string file = "/dev/shm/fuzz_table_" + std::to_string(getpid()) + ".csv";
  const char* wrong = regista::study::check_table_from(file, {reinterpret_cast<const char*>(data), size});
  if (*wrong != '\0') {
    std::fprintf(stderr, "%s\n", wrong);
    std::abort();
  }
  return 0;
}
