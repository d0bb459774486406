// SPDX-License-Identifier: MIT
// libFuzzer target: build with clang and -DREGISTA_FUZZ=ON, run
//   bin/fuzz_config -max_len=20000 NEW_CORPUS tests/fixtures/config/corpus
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include "fuzz/config/documents_from_bytes.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const char* wrong = regista::config::check_documents_from({reinterpret_cast<const char*>(data), size});
  if (*wrong != '\0') {
    std::fprintf(stderr, "%s\n", wrong);
    std::abort();
  }
  return 0;
}
