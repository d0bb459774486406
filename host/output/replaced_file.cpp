// SPDX-License-Identifier: MIT
#include "output/replaced_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <string>
#include <system_error>

#include "config/bad_input.hpp"
#include "output/output.hpp"
#include "output/own_kind.hpp"

namespace regista::output {
namespace {

namespace fs = std::filesystem;

// A file without a name that anybody looks for, gone unless it is kept.
class Draft {
 public:
  explicit Draft(const fs::path& beside) : name_(beside.string() + ".XXXXXX") {
    descriptor_ = mkostemp(name_.data(), O_CLOEXEC);
    if (descriptor_ == -1)
      throw config::BadInput(fmt::format("cannot write {}: {}", beside.string(), reason_of(errno)));
    const mode_t mask = umask(0);
    umask(mask);
    fchmod(descriptor_, 0666 & ~mask);  // as any new file; mkostemp's are for their owner alone
  }
  ~Draft() {
    if (descriptor_ != -1) ::close(descriptor_);
    if (!kept_) unlink(name_.c_str());
  }
  Draft(const Draft&) = delete;
  Draft& operator=(const Draft&) = delete;

  // False: errno says why.
  bool fill(std::string_view bytes) {
    while (!bytes.empty()) {
      const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
      if (written == -1 && errno == EINTR) continue;
      if (written <= 0) return false;
      bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    const int descriptor = descriptor_;
    descriptor_ = -1;
    return ::close(descriptor) == 0;
  }
  bool keep_as(const fs::path& file, bool replace) {
    int moved = renameat2(AT_FDCWD, name_.c_str(), AT_FDCWD, file.c_str(), replace ? 0 : RENAME_NOREPLACE);
    if (moved == -1 && (errno == EINVAL || errno == ENOSYS)) moved = std::rename(name_.c_str(), file.c_str());
    kept_ = moved == 0;
    return kept_;
  }

 private:
  std::string name_;
  int descriptor_ = -1;
  bool kept_ = false;
};

}  // namespace

void write_whole(const fs::path& file, std::string_view bytes, Existing existing) {
  std::error_code error;
  const fs::file_status now = fs::status(file, error);
  const auto exists = [&] {
    return config::BadInput(fmt::format("{} exists already; --force replaces it", file.string()));
  };
  if (fs::exists(now)) {
    if (!fs::is_regular_file(now))
      throw config::BadInput(fmt::format("cannot write {}: it is no ordinary file", file.string()));
    if (existing == Existing::refused) throw exists();
    const OwnKind page = own_kind(Writes::page);
    const Found found = bytes.starts_with('<') ? found_in(file, page) : Found::own;
    if (found == Found::database || found == Found::other) {
      throw config::BadInput(fmt::format("cannot write {}: there is a file of another kind, which no {} replaces",
                                         file.string(), page.what));
    }
  }
  // What a link points to is meant, not the link.
  const fs::path place = fs::exists(now) ? fs::canonical(file, error) : file;
  Draft draft(error ? file : place);
  if (!draft.fill(bytes)) throw WriteError(fmt::format("cannot write to {}: {}", file.string(), reason_of(errno)));
  if (draft.keep_as(error ? file : place, existing == Existing::replaced)) return;
  if (errno == EEXIST) throw exists();
  throw WriteError(fmt::format("cannot write to {}: {}", file.string(), reason_of(errno)));
}

}  // namespace regista::output
