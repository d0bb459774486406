// SPDX-License-Identifier: MIT
#include "output/replaced_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <system_error>
#include <utility>

#include "config/errors.hpp"
#include "mcap/encoding.hpp"
#include "recording/decision_log.hpp"
#include "recording/field_svg.hpp"
#include "report/experiment_report.hpp"
#include "report/match_summary.hpp"
#include "report/tuning_report.hpp"

namespace regista::output {
namespace {

namespace fs = std::filesystem;
using config::BadInput;

constexpr std::string_view database = "SQLite format 3";

// Returns the rights that the user's mask leaves for a new file. mkostemp() and mkdtemp() give rights only to the owner
// of a file, so the rights must be set afterwards.
mode_t masked(mode_t rights) {
  const mode_t mask = umask(0);
  umask(mask);
  return rights & ~mask;
}

// Renames a file or folder. On failure, returns false with the reason in errno.
bool moved(const std::string& from, const fs::path& to, bool replace) {
  if (renameat2(AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), replace ? 0 : RENAME_NOREPLACE) == 0) return true;
  return (errno == EINVAL || errno == ENOSYS) && std::rename(from.c_str(), to.c_str()) == 0;
}

// A temporary file. The destructor removes the file unless keep_as() has renamed it.
class Draft {
 public:
  explicit Draft(const fs::path& beside) : name_(beside.string() + ".XXXXXX") {
    descriptor_ = mkostemp(name_.data(), O_CLOEXEC);
    if (descriptor_ == -1) throw BadInput(fmt::format("cannot write {}: {}", beside.string(), reason_of(errno)));
    fchmod(descriptor_, masked(0666));
  }
  ~Draft() {
    if (descriptor_ != -1) ::close(descriptor_);
    if (!kept_) unlink(name_.c_str());
  }
  Draft(const Draft&) = delete;
  Draft& operator=(const Draft&) = delete;

  // fill() and keep_as() return false on failure, with the reason in errno.
  bool fill(std::string_view bytes) {
    while (!bytes.empty()) {
      const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
      if (written == -1 && errno == EINTR) continue;
      if (written <= 0) return false;
      bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    return ::close(std::exchange(descriptor_, -1)) == 0;
  }
  bool keep_as(const fs::path& file, bool replace) { return kept_ = moved(name_, file, replace); }

 private:
  std::string name_;
  int descriptor_ = -1;
  bool kept_ = false;
};

// A temporary folder. The destructor removes the folder unless keep_as() has renamed it.
class DraftFolder {
 public:
  explicit DraftFolder(const fs::path& place)
      : path_((place.parent_path() / ("." + place.filename().string() + ".XXXXXX")).string()) {
    if (mkdtemp(path_.data()) == nullptr) {
      const int error = errno;
      const std::string message = fmt::format("cannot make {}: {}", place.string(), reason_of(error));
      if (error == ENOSPC || error == EDQUOT) throw WriteError(message);
      throw BadInput(message);
    }
    chmod(path_.c_str(), masked(0777));
  }
  ~DraftFolder() {
    std::error_code none;
    if (!kept_) fs::remove_all(path_, none);
  }
  DraftFolder(const DraftFolder&) = delete;
  DraftFolder& operator=(const DraftFolder&) = delete;

  // add() and keep_as() return false on failure, with the reason in errno.
  bool add(const NewFile& file) const {
    std::error_code failed;
    const fs::path path = fs::path(path_) / file.name;
    fs::create_directories(path.parent_path(), failed);
    std::FILE* const out = std::fopen(path.c_str(), "wbxe");
    if (out == nullptr) return false;
    const bool written = std::fwrite(file.bytes.data(), 1, file.bytes.size(), out) == file.bytes.size();
    const int error = errno;
    if (std::fclose(out) != 0) return false;
    if (!written) errno = error;
    return written;
  }
  bool keep_as(const fs::path& place) { return kept_ = moved(path_, place, false); }

 private:
  std::string path_;
  bool kept_ = false;
};

// Removes files with the names of a study's figures, and no others. Files that cannot be removed stay.
void remove_study_figures(const fs::path& folder) {
  std::error_code error;
  std::vector<fs::path> found;
  for (const fs::directory_entry& each : fs::directory_iterator(folder, error)) {
    const fs::path& file = each.path();
    const std::string stem = file.stem().string();
    if ((report::is_experiment_figure(stem) || report::is_tuning_figure(stem)) &&
        std::ranges::find(figure_endings, file.extension().string()) != figure_endings.end() &&
        fs::is_regular_file(each.symlink_status(error)))
      found.push_back(file);
  }
  for (const fs::path& each : found) fs::remove(each, error);
}

}  // namespace

std::string reason_of(int error) { return std::generic_category().message(error); }

void occupy_standard_streams() {
  // /dev/null is opened for reading, so that writing to the stream fails as before.
  for (int expected = STDIN_FILENO; expected <= STDERR_FILENO; ++expected) {
    if (fcntl(expected, F_GETFD) == -1) open("/dev/null", O_RDONLY);  // open() takes the lowest free number: `expected`
  }
}

void print(std::string_view text) {
  errno = 0;
  if (std::fwrite(text.data(), 1, text.size(), stdout) != text.size() || std::fflush(stdout) != 0) {
    const int error = errno;
    const std::string message = fmt::format("cannot write to standard output: {}", reason_of(error));
    if (error == EPIPE) throw ReaderGone(message);
    throw WriteError(message);
  }
}

OutputFile::OutputFile(const std::filesystem::path& path)
    : name_(path.string()), file_(std::fopen(path.c_str(), "wb")) {
  if (file_ == nullptr) throw config::BadInput(fmt::format("cannot write {}: {}", name_, reason_of(errno)));
}

OutputFile::~OutputFile() {
  if (file_ != nullptr) std::fclose(file_);
}

void OutputFile::write(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), file_) != text.size()) fail();
}

void OutputFile::close() {
  std::FILE* const file = std::exchange(file_, nullptr);
  if (std::fclose(file) != 0) fail();
}

void OutputFile::fail() const { throw WriteError(fmt::format("cannot write to {}: {}", name_, reason_of(errno))); }

OwnKind own_kind(Writes what) {
  switch (what) {
    case Writes::recording:
      return {.what = "recording", .begins = mcap::magic.substr(0, mcap::version_in_magic), .needs_force = true};
    case Writes::decisions:
      return {.what = "log of decisions", .begins = recording::decision_log_begin};
    case Writes::metrics:
      return {.what = "table of metrics", .begins = report::metrics_csv_head, .moved_to_its_place = true};
    case Writes::match_table:  // see report::experiment_report()
      return {.what = "table of matches", .begins = "row,arm", .replaces_others = true};
    case Writes::summary_table:  // see report::experiment_summary_csv()
      return {.what = "table of means", .begins = "measure,unit,arm", .replaces_others = true};
    case Writes::search_table:  // see report::tuning_csv()
      return {.what = "table of a search", .begins = "evaluation,pairs_from,", .replaces_others = true};
    case Writes::tuned_team:
      return {.what = "team that a tuning wrote",
              .begins = report::tuned_file_begin,
              .replaces_others = true,
              .moved_to_its_place = true,
              .advice = "--output names another file"};
    case Writes::page:
      return {.what = "page or picture", .begins = "<", .needs_force = true, .moved_to_its_place = true};
    case Writes::drawing:
      return {.what = "drawing of roles",
              .begins = "<",
              .needs_force = true,
              .cheap = recording::roles_svg_begin,
              .moved_to_its_place = true};
    case Writes::results:
    case Writes::figures:
    case Writes::sources:
      break;
  }
  assert(false);
  return {};
}

bool is_database(const fs::path& file) {
  std::array<char, database.size()> begin{};
  std::ifstream in(file, std::ios::binary);
  return in.read(begin.data(), begin.size()) && std::string_view(begin.data(), begin.size()) == database;
}

Found found_in(const fs::path& file, const OwnKind& kind) {
  std::error_code none;
  if (fs::file_size(file, none) == 0) return Found::nothing;
  std::string beginning(std::max({kind.begins.size(), database.size(), kind.cheap.size()}), '\0');
  std::ifstream in(file, std::ios::binary);
  in.read(beginning.data(), static_cast<std::streamsize>(beginning.size()));
  beginning.resize(static_cast<std::size_t>(in.gcount()));
  if (!kind.cheap.empty() && beginning.starts_with(kind.cheap)) return Found::cheap;
  if (beginning.starts_with(kind.begins)) return Found::own;
  return beginning.starts_with(database) ? Found::database : Found::other;
}

void write_whole(const fs::path& file, std::string_view bytes, Existing existing) {
  std::error_code error;
  const fs::file_status now = fs::status(file, error);
  const auto exists = [&] { return BadInput(fmt::format("{} exists already; --force replaces it", file.string())); };
  if (fs::exists(now)) {
    if (!fs::is_regular_file(now))
      throw BadInput(fmt::format("cannot write {}: it is no ordinary file", file.string()));
    if (existing == Existing::refused) throw exists();
    const OwnKind page = own_kind(Writes::page);
    const Found found = bytes.starts_with('<') ? found_in(file, page) : Found::own;
    if (found == Found::database || found == Found::other) {
      throw BadInput(fmt::format("cannot write {}: there is a file of another kind, which no {} replaces",
                                 file.string(), page.what));
    }
  }
  // If the file is a link, the function writes the target of the link.
  const fs::path canonical = fs::exists(now) ? fs::canonical(file, error) : file, place = error ? file : canonical;
  Draft draft(place);
  if (draft.fill(bytes) && draft.keep_as(place, existing == Existing::replaced)) return;
  if (errno == EEXIST) throw exists();
  throw WriteError(fmt::format("cannot write to {}: {}", file.string(), reason_of(errno)));
}

void write_new_folder(const fs::path& folder, std::span<const NewFile> files) {
  const auto exists = [&] { return BadInput(fmt::format("{} exists already", folder.string())); };
  std::error_code none;
  if (fs::exists(fs::symlink_status(folder, none))) throw exists();
  const fs::path parent = folder.has_parent_path() ? folder.parent_path() : fs::path(".");
  if (!fs::is_directory(parent, none)) {
    throw BadInput(fmt::format("cannot make {}: there is no folder {}", folder.string(), parent.string()));
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

void write_figures(const std::vector<report::Figure>& figures, const FigureOptions& options) {
  if (!options.folder) return;
  const fs::path& folder = *options.folder;
  std::error_code error;
  fs::create_directory(folder, error);
  if (error || !fs::is_directory(folder)) {
    throw config::BadInput(fmt::format("cannot make the folder {}: {}", folder.string(),
                                       error ? error.message() : "there is a file of this name"));
  }
  if (options.only_these) remove_study_figures(folder);
  for (const report::Figure& each : figures) {
    write_whole(folder / (each.name + ".csv"), each.csv, options.existing);
    write_whole(folder / (each.name + ".svg"), svg(each, report::Medium::file).str(), options.existing);
  }
}

}  // namespace regista::output
