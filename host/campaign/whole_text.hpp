// SPDX-License-Identifier: MIT
// Whole texts of files and pipes.
#pragma once

#include <unistd.h>

#include <array>
#include <cerrno>
#include <string>
#include <string_view>

namespace regista::campaign {

// All of a file, wherever it stands: who shares it is not disturbed.
inline std::string everything_in(int file) {
  std::string out;
  std::array<char, 4096> buffer;
  for (;;) {
    const ssize_t count = ::pread(file, buffer.data(), buffer.size(), static_cast<off_t>(out.size()));
    if (count == -1 && errno == EINTR) continue;
    if (count <= 0) return out;
    out.append(buffer.data(), static_cast<std::size_t>(count));
  }
}

// False when not all of it could be written.
inline bool write_all(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t count = ::write(descriptor, text.data(), text.size());
    if (count == -1 && errno == EINTR) continue;
    if (count == -1) return false;
    text.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

}  // namespace regista::campaign
