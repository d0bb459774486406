// SPDX-License-Identifier: MIT
// libFuzzer target: build with clang and -DREGISTA_FUZZ=ON, run
//   mkdir CORPUS && bin/fuzz_mcap_seeds CORPUS && bin/fuzz_mcap -max_len=20000 CORPUS
#include <sys/mman.h>
#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <string>

#include "fuzz/mcap/examine.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const int file = memfd_create("recording", 0);
  static const std::string path = "/proc/self/fd/" + std::to_string(file);
  if (ftruncate(file, static_cast<off_t>(size)) != 0) std::abort();
  if (pwrite(file, data, size, 0) != static_cast<ssize_t>(size)) std::abort();
  regista::mcap::examine(path);
  return 0;
}
