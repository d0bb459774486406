// SPDX-License-Identifier: MIT
#include "campaign/stored_setup.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <set>
#include <stdexcept>
#include <string_view>
#include <system_error>

#include "campaign/stored_row.hpp"
#include "config/document_files.hpp"
#include "config/errors.hpp"
#include "mcap/encoding.hpp"
#include "texts/message.hpp"

namespace regista::campaign {
namespace {

std::int64_t checksum_of(std::string_view path, std::int64_t size, std::string_view content) {
  return RowChecksum().bytes(path).whole(size).bytes(content).value();
}

std::int64_t checksum_of(const std::string& key, const std::string& job) {
  return RowChecksum().bytes(key).bytes(job).value();
}

}  // namespace

void write_documents(SQLite::Database& database, std::span<const Document> documents) {
  database.exec(documents_table);
  database.exec("DELETE FROM documents");
  SQLite::Statement add(database, "INSERT OR IGNORE INTO documents(path, size, content, checksum) VALUES(?, ?, ?, ?)");
  mcap::Compressor compressor;
  for (const Document& each : documents) {
    std::string frame;
    std::optional<std::int64_t> size;
    std::optional<Blob> content;
    if (each.content) {
      compressor.append(frame, *each.content);
      size = static_cast<std::int64_t>(each.content->size());
      content = Blob{frame};
    }
    put(add, each.path, size, content, checksum_of(each.path, size.value_or(0), frame));
  }
}

std::vector<Document> read_documents(SQLite::Database& database) {
  std::vector<Document> out;
  if (!database.tableExists("documents")) return out;
  SQLite::Statement each(database, "SELECT path, size, content, checksum FROM documents ORDER BY path");
  mcap::Decompressor decompressor;
  while (each.executeStep()) {
    Document& document = out.emplace_back();
    document.path = each.getColumn(0).getString();
    const bool kept = !each.getColumn(2).isNull();
    const std::int64_t size = each.getColumn(1).getInt64();  // null gives 0
    const std::string_view frame = blob_of(each.getColumn(2));
    if (checksum_of(document.path, size, frame) != each.getColumn(3).getInt64()) {
      throw std::invalid_argument(fmt::format("the checksum of the document {} does not fit", document.path));
    }
    if (!kept) continue;
    try {
      decompressor.decompress(frame, static_cast<std::uint64_t>(size), document.content.emplace());
    } catch (const mcap::Malformed& error) {
      throw std::invalid_argument(fmt::format("the document {}: {}", document.path, error.why));
    }
  }
  return out;
}

void StoredFixtures::add(std::span<const Fixture> fixtures) {
  SQLite::Statement add(database_, "INSERT OR IGNORE INTO fixtures(key, job, checksum) VALUES(?, ?, ?)");
  for (const Fixture& fixture : fixtures) {
    const std::string job = to_json(fixture.job);
    put(add, fixture.key, job, checksum_of(fixture.key, job));
  }
}

void StoredFixtures::check() {
  if (std::exchange(checked_, true)) return;
  SQLite::Statement each(database_, "SELECT id, key, job, checksum FROM fixtures");
  while (each.executeStep()) {
    if (checksum_of(each.getColumn(1).getString(), each.getColumn(2).getString()) == each.getColumn(3).getInt64())
      continue;
    throw std::invalid_argument(fmt::format("the checksum of fixture {} does not fit", each.getColumn(0).getInt64()));
  }
}

std::vector<std::int64_t> StoredFixtures::numbers(std::span<const std::string> keys) {
  check();
  std::vector<std::int64_t> out;
  SQLite::Statement select(database_, "SELECT id FROM fixtures WHERE key = ?");
  for (const std::string& key : keys) {
    select.bindNoCopy(1, key);
    out.push_back(select.executeStep() ? select.getColumn(0).getInt64() : 0);
    select.reset();
  }
  return out;
}

std::vector<std::pair<std::int64_t, std::string>> StoredFixtures::keys() {
  check();
  std::vector<std::pair<std::int64_t, std::string>> out;
  SQLite::Statement each(database_, "SELECT id, key FROM fixtures ORDER BY id");
  while (each.executeStep()) out.emplace_back(each.getColumn(0).getInt64(), each.getColumn(1).getString());
  return out;
}

std::vector<Fixture> StoredFixtures::all() {
  check();
  std::vector<Fixture> out;
  SQLite::Statement each(database_, "SELECT key, job FROM fixtures ORDER BY id");
  while (each.executeStep())
    out.push_back({each.getColumn(0).getString(), job_from_json(each.getColumn(1).getString())});
  return out;
}

Job StoredFixtures::job(std::int64_t number, std::int64_t row) {
  SQLite::Statement select(database_, "SELECT key, job, checksum FROM fixtures WHERE id = ?");
  select.bind(1, number);
  if (!select.executeStep()) throw DamagedRow(row, "what was to be played is missing");
  const std::string job = select.getColumn(1).getString();
  if (checksum_of(select.getColumn(0).getString(), job) != select.getColumn(2).getInt64()) {
    throw DamagedRow(row, "the checksum of what was to be played does not fit");
  }
  return reading_row(row, "", [&] { return job_from_json(job); });
}

namespace {

namespace fs = std::filesystem;

constexpr std::uintmax_t largest = std::uintmax_t{16} << 20, most = std::uintmax_t{64} << 20;  // bytes
constexpr std::string_view shared_object = "\x7f\x45LF";  // first bytes of an ELF file

bool is_plain(const std::string& name) {
  const fs::path path = name;
  return path.is_absolute() && path.has_filename() && !name.starts_with("//") && path == path.lexically_normal() &&
         name.find('\0') == std::string::npos;
}

// Throws if a copy would be written outside of the root or through a link: a file of results may come from a stranger.
void require_sound(const std::vector<Document>& documents) {
  std::set<std::string> paths;
  for (const Document& each : documents) paths.insert(each.path);
  for (const Document& each : documents) {
    bool sound = is_plain(each.path);
    for (fs::path folder = fs::path(each.path).parent_path(); sound && folder != folder.parent_path();
         folder = folder.parent_path()) {
      sound = !paths.contains(folder.string());
    }
    if (!sound) throw std::invalid_argument("no document has the path " + texts::in_quotes(each.path));
  }
}

}  // namespace

std::vector<Document> documents_in(std::span<const fs::path> files) {
  std::vector<Document> out;
  std::set<std::string> seen;
  std::uintmax_t sum = 0;
  for (const fs::path& file : files) {
    Document document{fs::absolute(file).lexically_normal().string(), std::nullopt};
    if (!seen.insert(document.path).second) continue;
    std::error_code none;
    const std::uintmax_t size = fs::file_size(file, none);
    if (none) continue;  // the file was deleted after it was read
    if (size <= largest && sum + size <= most) {
      std::optional<std::string> content = config::file_content(file);
      if (content && !content->starts_with(shared_object)) {
        sum += content->size();
        document.content = std::move(content);
      }
    }
    out.push_back(std::move(document));
  }
  std::ranges::sort(out, {}, &Document::path);
  return out;
}

Job in_copies(Job job, const fs::path& root, const fs::path& given_in) {
  for (std::string* name : {&job.teams[0], &job.teams[1], &job.rules, &job.robot, &job.disturbance,
                            &job.home_disturbance, &job.away_disturbance, &job.opening}) {
    const fs::path path = fs::path(*name).lexically_normal();
    if (!path.is_absolute()) continue;
    const fs::path copy = root / path.relative_path();
    std::error_code none;
    if (fs::exists(copy, none)) *name = copy.string();
  }
  for (std::string& each : job.plugins) each = (given_in / each).lexically_normal().string();
  return job;
}

DocumentCopies::DocumentCopies(std::vector<Document> documents) {
  require_sound(documents);
  for (const Document& each : documents) {
    const fs::path file = at(each.path);
    fs::create_directories(file.parent_path());
    if (each.content) {
      std::ofstream out(file, std::ios::binary);
      if (!(out << *each.content).flush()) {
        throw std::system_error(errno, std::generic_category(), "no room for a copy of " + each.path);
      }
    } else {
      fs::create_symlink(each.path, file);
    }
  }
}

fs::path DocumentCopies::at(const fs::path& path) const { return root_.path() / path.relative_path(); }

fs::path DocumentCopies::folder(const fs::path& given_in) const {
  fs::path out = at(given_in);
  fs::create_directories(out);
  return out;
}

StoredSetup::StoredSetup(const Job& stored, const plugin::Catalogue& catalogue,
                         const std::function<std::vector<Document>()>& documents)
    : catalogue_(catalogue), job_(stored), changed_(set_up()), missing_(changed_) {
  if (changed_.empty()) return;
  std::vector<Document> begun_with = documents();
  if (begun_with.empty()) return;
  const std::filesystem::path given_in = std::filesystem::current_path();
  copies_.emplace(std::move(begun_with));
  job_ = in_copies(stored, copies_->root(), given_in);
  std::filesystem::current_path(copies_->folder(given_in));
  missing_ = set_up();
}

// Prepares the match of job_. Returns in words an error or the changes of the inputs; empty if all are unchanged.
std::string StoredSetup::set_up() {
  prepared_ = {};
  try {
    prepared_ = match_setup(job_, catalogue_, KeyNames::former_too);
  } catch (const config::Error& error) {
    return error.what();
  } catch (const config::BadInput& error) {
    return error.what();
  }
  return what_changed(job_, prepared_, catalogue_, program_hash(), mathematics_fingerprint(),
                      copies_ ? copies_->root().string() : "");
}

}  // namespace regista::campaign
