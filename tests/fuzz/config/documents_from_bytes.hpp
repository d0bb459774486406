// SPDX-License-Identifier: MIT
// What must hold for any bytes at all: they are refused with one line, or read; and what was read, shown and read again
// is the same. Shared by the fuzzer and the test that runs over the corpus.
#pragma once

#include <string_view>

namespace regista::config {

// A document, and after each 0x1e, a byte no document may hold, an override "path=value". Returns what is wrong, ""
// for nothing. Reads no files except those that values name.
const char* check_documents_from(std::string_view bytes);

}  // namespace regista::config
