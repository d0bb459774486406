// SPDX-License-Identifier: MIT
#include "output/output_files.hpp"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>

#include "config/document_files.hpp"
#include "config/errors.hpp"
#include "config/overlay.hpp"
#include "output/replaced_file.hpp"
#include "study/study.hpp"
#include "texts/message.hpp"

namespace regista::output {
namespace {

namespace fs = std::filesystem;
using config::BadInput;

// Endings of the files that SQLite keeps beside a database. SQLite would use any file with such a name.
constexpr std::array companions{"-wal", "-shm", "-journal"};
constexpr std::array<std::string_view, 1> recording_endings{".mcap"};
constexpr int longest_chain_of_links = 40;  // same limit as in Linux

fs::path absolute_path(const fs::path& named) {
  std::error_code error;
  const fs::path out = fs::absolute(named, error);
  return error ? named : out;
}

// Returns the path with all links resolved, including links to a file that does not exist yet.
fs::path where_it_leads(const fs::path& named) {
  std::error_code error;
  fs::path path = absolute_path(named);
  for (int i = 0; i < longest_chain_of_links && fs::is_symlink(fs::symlink_status(path, error)); ++i) {
    const fs::path target = fs::read_symlink(path, error);
    if (error) break;
    path = path.parent_path() / target;
  }
  const fs::path out = fs::weakly_canonical(path, error);
  return error ? path : out;
}

// Returns the database beside which SQLite would use a file with this name; empty if there is no such database.
fs::path database_of(const fs::path& file) {
  const std::string name = file.string();
  const fs::path database = name.substr(0, std::min(name.rfind('-'), name.size()));
  const bool beside = std::ranges::any_of(companions, [&](const char* each) { return name.ends_with(each); });
  return beside && is_database(database) ? database : fs::path();
}

std::string shown(const fs::path& file) { return texts::one_line(file.string()); }

}  // namespace

OutputFiles::Place::Place(const fs::path& file) : named(file), path(where_it_leads(file)) {
  struct stat about {};
  if (::stat(path.c_str(), &about) == 0) identity.emplace(about.st_dev, about.st_ino);
}

bool OutputFiles::Place::same(const Place& other) const {
  return path == other.path || (identity && identity == other.identity);
}

bool OutputFiles::Place::is_among(const std::vector<Place>& others) const {
  return std::ranges::any_of(others, [this](const Place& each) { return same(each); });
}

OutputFiles::OutputFiles(const std::vector<GivenOption>& given, std::string work) : work_(std::move(work)) {
  const auto set = std::ranges::find(given, "--set", &GivenOption::name);
  const auto overrides = set == given.end() ? std::vector<std::string>() : set->values;
  for (const GivenOption& option : given) {
    if (const Reads* const what = std::get_if<Reads>(&option.use)) read(option.values, *what, overrides);
    if (const Writes* const what = std::get_if<Writes>(&option.use)) {
      for (const std::string& file : option.values) write(option.name, file, *what);
    }
  }
}

void OutputFiles::read(const std::vector<std::string>& files, Reads what, const std::vector<std::string>& overrides) {
  Named& named = reads_.emplace_back(Named{{}, what, overrides});
  for (const std::string& file : files) {
    if (!file.empty()) named.files.push_back(absolute_path(config::own_or_shipped(file)));
  }
}

std::vector<fs::path> OutputFiles::documents() const {
  std::vector<fs::path> out;
  for (const Named& named : reads_) {
    if (named.what == Reads::documents)
      std::ranges::move(config::named_files(named.files, config::typed_overrides(named.overrides)),
                        std::back_inserter(out));
  }
  return out;
}

std::vector<OutputFiles::Place> OutputFiles::all_reads() const {
  std::vector<Place> out;
  for (const fs::path& file : documents()) out.emplace_back(file);
  std::error_code none;
  for (const Named& named : reads_) {
    if (named.what == Reads::documents) continue;  // documents() has returned these files
    for (const fs::path& file : named.files) {
      if (named.what == Reads::plugins) {
        for (fs::directory_iterator each(file, none), end; !none && each != end; each.increment(none)) {
          if (each->path().extension() == ".so") out.emplace_back(each->path());
        }
        continue;
      }
      out.emplace_back(file);
      if (named.what != Reads::results) continue;
      for (const char* each : companions) out.emplace_back(file.string() + each);
    }
  }
  return out;
}

void OutputFiles::write(const std::string& who, const fs::path& file, Writes what) {
  if (file.empty() || ((what == Writes::page || what == Writes::drawing) && file == "-")) return;
  if (what == Writes::sources) return;  // write_new_folder() never touches existing files
  if (what == Writes::figures) return folders_.push_back({who, Place(file), figure_endings});
  Output output{who, Place(file), what};
  const auto known = [&](const Output& other) { return other.what == what && other.place.same(output.place); };
  if (std::ranges::none_of(outputs_, known)) outputs_.push_back(std::move(output));
}

void OutputFiles::write_beside(const fs::path& results, bool page, bool figures) {
  write("--results", results, Writes::results);
  for (const char* each : companions)
    outputs_.push_back({"the log of --results", Place(results.string() + each), Writes::results});
  folders_.push_back({"the recordings of --results", Place(study::recording_folder(results)), recording_endings});
  if (!page) return;
  // This class accepts an existing file that is not a page of Regista. The code that writes the page does not replace
  // such a file, and complains.
  outputs_.push_back({"the page of --results", Place(study::page_file(results)), Writes::results});
  if (figures) write("the figures of --results", study::figure_folder(results), Writes::figures);
}

void OutputFiles::check_folder(const Folder& folder, const std::vector<Place>& reads) const {
  const auto written_there = [&](const fs::path& file) {
    return file.parent_path() == folder.place.path &&
           std::ranges::find(folder.endings, file.extension().string()) != folder.endings.end();
  };
  for (const Output& each : outputs_) {
    if (each.place.same(folder.place))
      throw BadInput(fmt::format("{} and {}: both name {}", each.who, folder.who, shown(folder.place.named)));
    if (!written_there(each.place.path)) continue;
    throw BadInput(fmt::format("{} {}: {} are written to that folder", each.who, shown(each.place.named), folder.who));
  }
  const auto refuse = [&](const fs::path& file) {
    throw BadInput(fmt::format("{}: {} is a file that this {} reads", folder.who, shown(file), work_));
  };
  for (const Place& each : reads) {
    if (written_there(each.path)) refuse(each.named);
  }
  // A file in the folder may be a link to a file that the command reads.
  std::error_code failed;
  for (fs::directory_iterator entry(folder.place.path, failed), end; !failed && entry != end; entry.increment(failed)) {
    if (!written_there(folder.place.path / entry->path().filename())) continue;
    std::error_code none;
    if (!entry->is_symlink(none) && entry->hard_link_count(none) < 2) continue;
    if (Place(entry->path()).is_among(reads)) refuse(entry->path());
  }
}

void OutputFiles::check_existing(const Output& output, bool force) {
  const fs::path& file = output.place.path;
  const auto refuse = [&](const std::string& why) {
    throw BadInput(fmt::format("{} {}: {}", output.who, shown(output.place.named), why));
  };
  const auto cannot = [&](int error) { refuse("cannot be written there: " + reason_of(error)); };
  const OwnKind kind = own_kind(output.what);
  std::error_code none;
  const fs::file_status now = fs::status(file, none);
  if (fs::is_directory(now)) cannot(EISDIR);
  // A new file, and a file that is moved to its place when complete, need a writable folder. Other files must be
  // writable themselves.
  const bool by_folder = kind.moved_to_its_place || !fs::exists(now);
  if (fs::exists(now) && kind.moved_to_its_place && !fs::is_regular_file(now)) refuse("it is no ordinary file");
  if (access(by_folder ? file.parent_path().c_str() : file.c_str(), W_OK) != 0) cannot(errno);
  if (!fs::is_regular_file(now)) return;
  const Found found = found_in(file, kind);
  const std::string advice = kind.advice.empty() ? "" : fmt::format(", {}", kind.advice);
  if (found == Found::database || (found == Found::other && !kind.replaces_others)) {
    refuse(fmt::format("there is a file of another kind, which no {} replaces", kind.what));
  }
  if (force) return;
  if (found == Found::other) refuse(fmt::format("is there, and is no {}; --force replaces it{}", kind.what, advice));
  if (kind.needs_force && found != Found::cheap) refuse("exists already; --force replaces it");
}

void OutputFiles::check(bool force) const {
  if (outputs_.empty() && folders_.empty()) return;
  const std::vector<Place> reads = all_reads();
  const auto check_beside = [](const std::string& who, const Place& place) {
    const fs::path database = database_of(place.path);
    if (database.empty()) return;
    throw BadInput(
        fmt::format("{} {}: SQLite would take it for a part of {}", who, shown(place.named), shown(database)));
  };
  for (auto one = outputs_.begin(); one != outputs_.end(); ++one) {
    const std::string name = shown(one->place.named);
    if (one->place.is_among(reads)) {
      throw BadInput(fmt::format("{} {}: is a file that this {} reads", one->who, name, work_));
    }
    const auto other =
        std::find_if(outputs_.begin(), one, [&](const Output& each) { return each.place.same(one->place); });
    if (other != one) throw BadInput(fmt::format("{} and {}: both name {}", other->who, one->who, name));
    if (one->what != Writes::results) check_beside(one->who, one->place);
  }
  for (const Folder& each : folders_) {
    check_beside(each.who, each.place);
    check_folder(each, reads);
  }
  for (const Output& each : outputs_) {
    if (each.what != Writes::results) check_existing(each, force);  // campaign::Store checks results
  }
}

}  // namespace regista::output
