// SPDX-License-Identifier: MIT
#include "output/new_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <system_error>

#include "config/bad_input.hpp"
#include "output/output.hpp"

namespace regista::output {
namespace {

namespace fs = std::filesystem;

// The rights that the user's mask leaves of these.
mode_t masked(mode_t rights) {
  const mode_t mask = umask(0);
  umask(mask);
  return rights & ~mask;
}

// A folder under a name that nobody looks for, gone unless it is kept.
class DraftFolder {
 public:
  explicit DraftFolder(const fs::path& place)
      : path_((place.parent_path() / ("." + place.filename().string() + ".XXXXXX")).string()) {
    if (mkdtemp(path_.data()) == nullptr) {
      const int error = errno;
      path_.clear();
      const std::string message = fmt::format("cannot make {}: {}", place.string(), reason_of(error));
      if (error == ENOSPC || error == EDQUOT) throw WriteError(message);
      throw config::BadInput(message);
    }
    chmod(path_.c_str(), masked(0777));  // as any new folder; mkdtemp's are for their owner alone
  }
  ~DraftFolder() {
    std::error_code none;
    if (!path_.empty()) fs::remove_all(path_, none);
  }
  DraftFolder(const DraftFolder&) = delete;
  DraftFolder& operator=(const DraftFolder&) = delete;

  // Both: false, and errno says why.
  bool add(const NewFile& file) const {
    std::error_code failed;
    fs::create_directories((fs::path(path_) / file.name).parent_path(), failed);
    std::FILE* const out = std::fopen((fs::path(path_) / file.name).c_str(), "wbxe");
    if (out == nullptr) return false;
    const bool written = std::fwrite(file.bytes.data(), 1, file.bytes.size(), out) == file.bytes.size();
    const int error = errno;
    if (std::fclose(out) != 0) return false;
    if (!written) errno = error;
    return written;
  }
  bool keep_as(const fs::path& place) {
    int moved = renameat2(AT_FDCWD, path_.c_str(), AT_FDCWD, place.c_str(), RENAME_NOREPLACE);
    if (moved == -1 && (errno == EINVAL || errno == ENOSYS)) moved = std::rename(path_.c_str(), place.c_str());
    if (moved == 0) path_.clear();
    return moved == 0;
  }

 private:
  std::string path_;
};

}  // namespace

void write_new_folder(const fs::path& folder, std::span<const NewFile> files) {
  const auto exists = [&] { return config::BadInput(fmt::format("{} exists already", folder.string())); };
  std::error_code none;
  if (fs::exists(fs::symlink_status(folder, none))) throw exists();
  const fs::path parent = folder.has_parent_path() ? folder.parent_path() : fs::path(".");
  if (!fs::is_directory(parent, none)) {
    throw config::BadInput(fmt::format("cannot make {}: there is no folder {}", folder.string(), parent.string()));
  }
  DraftFolder draft(folder);
  for (const NewFile& file : files) {
    if (!draft.add(file))
      throw WriteError(fmt::format("cannot write {}: {}", (folder / file.name).string(), reason_of(errno)));
  }
  if (draft.keep_as(folder)) return;
  if (errno == EEXIST || errno == ENOTEMPTY) throw exists();
  throw WriteError(fmt::format("cannot make {}: {}", folder.string(), reason_of(errno)));
}

}  // namespace regista::output
