// SPDX-License-Identifier: MIT
#include "cluster/shared_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <system_error>
#include <thread>

#include "process/descriptor.hpp"

namespace regista::cluster {
namespace {

constexpr int most_tries = 50;
int read_once(const std::filesystem::path& file, std::string& out) {
  out.clear();
  const process::FileDescriptor opened(::open(file.c_str(), O_RDONLY | O_CLOEXEC));
  if (opened.number == -1) return errno;
  std::array<char, 65536> part;
  for (;;) {
    const ssize_t size = ::read(opened.number, part.data(), part.size());
    if (size == 0) return 0;
    if (size > 0)
      out.append(part.data(), static_cast<std::size_t>(size));
    else if (errno != EINTR)
      return errno;
  }
}

}  // namespace

std::optional<std::string> shared_content(const std::filesystem::path& file) {
  return shared_content(file, read_once, std::chrono::milliseconds(100));
}

std::optional<std::string> shared_content(const std::filesystem::path& file, const ReadOnce& read,
                                          std::chrono::milliseconds between_tries) {
  std::string out;
  for (int i = 1;; ++i) {
    const int error = read(file, out);
    if (error == 0) return out;
    if (error == ENOENT || error == ENOTDIR) return std::nullopt;
    if (error != ESTALE || i == most_tries) throw std::system_error(error, std::generic_category(), file.string());
    std::this_thread::sleep_for(between_tries);
  }
}

}  // namespace regista::cluster
