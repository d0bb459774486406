// SPDX-License-Identifier: MIT
// Small files in a folder that several machines share, which others replace by renaming while they are read. On network
// file systems what was there before is then stale for a moment (ESTALE, as nfs(5) says): it is not missing.
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

namespace regista::cluster {

// Nothing where there is no such file. Throws std::system_error where it is there and cannot be read.
std::optional<std::string> shared_content(const std::filesystem::path& file);

// The same by reading in another way: 0, or the number of the error (errno).
using ReadOnce = std::function<int(const std::filesystem::path& file, std::string& out)>;
std::optional<std::string> shared_content(const std::filesystem::path& file, const ReadOnce& read,
                                          std::chrono::milliseconds between_tries);

}  // namespace regista::cluster
