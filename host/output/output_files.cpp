// SPDX-License-Identifier: MIT
#include "output/output_files.hpp"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <system_error>

#include "config/bad_input.hpp"
#include "config/named_files.hpp"
#include "output/own_kind.hpp"
#include "study/recording_place.hpp"
#include "texts/message.hpp"

namespace regista::output {
namespace {

namespace fs = std::filesystem;

// What SQLite keeps beside a file, and would take for its own.
constexpr std::array<std::string_view, 3> companions{"-wal", "-shm", "-journal"};
constexpr int longest_chain_of_links = 40;  // Linux follows as many

fs::path absolute_path(const fs::path& named) {
  std::error_code error;
  const fs::path out = fs::absolute(named, error);
  return error ? named : out;
}

// A link to a file that is not there yet names that file all the same.
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

// The database that SQLite would take this file for a part of; empty when it is beside none.
fs::path database_of(const fs::path& file) {
  const std::string name = file.string();
  for (const std::string_view each : companions) {
    if (!name.ends_with(each)) continue;
    const fs::path database = name.substr(0, name.size() - each.size());
    if (is_database(database)) return database;
  }
  return {};
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

OutputFiles::OutputFiles(const std::vector<GivenOption>& given, std::string work) : work_(std::move(work)) {
  const auto set = std::ranges::find(given, "--set", &GivenOption::name);
  const std::vector<std::string> overrides = set == given.end() ? std::vector<std::string>() : set->values;
  for (const GivenOption& option : given) {
    if (const Reads* const what = std::get_if<Reads>(&option.use)) read(option.values, *what, overrides);
    if (const Writes* const what = std::get_if<Writes>(&option.use)) {
      for (const std::string& file : option.values) write(option.name, file, *what);
    }
  }
}

void OutputFiles::read(const std::vector<std::string>& files, Reads what, const std::vector<std::string>& overrides) {
  Named& named = reads_.emplace_back();
  named.what = what;
  named.overrides = overrides;
  for (const std::string& file : files) {
    if (!file.empty()) named.files.push_back(absolute_path(file));
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

std::vector<OutputFiles::Read> OutputFiles::all_reads() const {
  std::vector<Read> out;
  const auto add = [&](const fs::path& file) {
    out.push_back({Place(file), fmt::format("a file that this {} reads", work_)});
  };
  std::error_code none;
  for (const fs::path& file : documents()) add(file);
  for (const Named& named : reads_) {
    switch (named.what) {
      case Reads::documents:
        break;  // above
      case Reads::results:
        for (const fs::path& file : named.files) {
          add(file);
          for (const std::string_view each : companions) add(file.string() + std::string(each));
        }
        break;
      case Reads::data:
        for (const fs::path& file : named.files) add(file);
        break;
      case Reads::plugins:
        for (const fs::path& folder : named.files) {
          for (fs::directory_iterator each(folder, none), end; !none && each != end; each.increment(none)) {
            if (each->path().extension() == ".so") add(each->path());
          }
        }
        break;
    }
  }
  return out;
}

void OutputFiles::write(const std::string& who, const fs::path& file, Writes what) {
  if (file.empty() || ((what == Writes::page || what == Writes::drawing) && file == "-")) return;
  if (what == Writes::sources) return;  // write_new_folder() touches nothing that is there
  if (what == Writes::figures) {
    folders_.push_back({who, Place(file), {".csv", ".gnuplot", ".svg", ".png"}});
    return;
  }
  Output output{who, Place(file), what};
  const auto known = [&](const Output& other) { return other.what == what && other.place.same(output.place); };
  if (std::ranges::none_of(outputs_, known)) outputs_.push_back(std::move(output));
}

void OutputFiles::write_beside(const fs::path& results, Page page) {
  write("--results", results, Writes::results);
  for (const std::string_view each : companions) {
    outputs_.push_back({"the log of --results", Place(results.string() + std::string(each)), Writes::results});
  }
  folders_.push_back({"the recordings of --results", Place(study::recording_folder(results)), {".mcap"}});
  if (page == Page::none) return;
  // What stands there and is no page of ours is left alone, with a word: that is not this guard's.
  outputs_.push_back({"the page of --results", Place(study::page_file(results)), Writes::results});
  if (page == Page::with_figures) write("the figures of --results", study::figure_folder(results), Writes::figures);
}

void OutputFiles::check_reads(const Output& output, const std::vector<Read>& reads) {
  for (const Read& each : reads) {
    if (!each.place.same(output.place)) continue;
    throw config::BadInput(fmt::format("{} {}: is {}", output.who, shown(output.place.named), each.what));
  }
}

void OutputFiles::check_others(std::size_t output) const {
  const Output& one = outputs_[output];
  for (std::size_t i = 0; i < output; ++i) {
    const Output& other = outputs_[i];
    if (!one.place.same(other.place)) continue;
    throw config::BadInput(fmt::format("{} and {}: both name {}", other.who, one.who, shown(one.place.named)));
  }
}

void OutputFiles::check_folder(const Folder& folder, const std::vector<Output>& outputs,
                               const std::vector<Read>& reads) {
  const auto written_there = [&](const fs::path& file) {
    return file.parent_path() == folder.place.path &&
           std::ranges::find(folder.endings, file.extension().string()) != folder.endings.end();
  };
  for (const Output& each : outputs) {
    if (each.place.same(folder.place))
      throw config::BadInput(fmt::format("{} and {}: both name {}", each.who, folder.who, shown(folder.place.named)));
    if (!written_there(each.place.path)) continue;
    throw config::BadInput(
        fmt::format("{} {}: {} are written to that folder", each.who, shown(each.place.named), folder.who));
  }
  const auto refuse = [&](const fs::path& file, const Read& read) {
    throw config::BadInput(fmt::format("{}: {} is {}", folder.who, shown(file), read.what));
  };
  for (const Read& each : reads) {
    if (written_there(each.place.path)) refuse(each.place.named, each);
  }
  // What is written over by its name may be a link to something else.
  std::error_code failed;
  for (fs::directory_iterator entry(folder.place.path, failed), end; !failed && entry != end; entry.increment(failed)) {
    if (!written_there(folder.place.path / entry->path().filename())) continue;
    std::error_code none;
    if (!entry->is_symlink(none) && entry->hard_link_count(none) < 2) continue;
    const Place place(entry->path());
    for (const Read& each : reads) {
      if (each.place.same(place)) refuse(entry->path(), each);
    }
  }
}

void OutputFiles::check_existing(const Output& output, bool force) {
  const fs::path& file = output.place.path;
  const auto refuse = [&](const std::string& why) {
    throw config::BadInput(fmt::format("{} {}: {}", output.who, shown(output.place.named), why));
  };
  const auto cannot = [&](int error) { refuse("cannot be written there: " + std::generic_category().message(error)); };
  const OwnKind kind = own_kind(output.what);
  std::error_code none;
  const fs::file_status now = fs::status(file, none);
  if (fs::is_directory(now)) cannot(EISDIR);
  // Moved to its place when it is whole, or written where it is.
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
  const std::vector<Read> reads = all_reads();
  const auto check_beside = [](const std::string& who, const Place& place) {
    const fs::path database = database_of(place.path);
    if (database.empty()) return;
    throw config::BadInput(
        fmt::format("{} {}: SQLite would take it for a part of {}", who, shown(place.named), shown(database)));
  };
  for (std::size_t i = 0; i < outputs_.size(); ++i) {
    check_reads(outputs_[i], reads);
    check_others(i);
    if (outputs_[i].what != Writes::results) check_beside(outputs_[i].who, outputs_[i].place);
  }
  for (const Folder& each : folders_) {
    check_beside(each.who, each.place);
    check_folder(each, outputs_, reads);
  }
  for (const Output& each : outputs_) {
    if (each.what != Writes::results) check_existing(each, force);  // those: campaign::Store
  }
}

}  // namespace regista::output
