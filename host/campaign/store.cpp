// SPDX-License-Identifier: MIT
#include "campaign/store.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "campaign/row_checksum.hpp"
#include "campaign/stored_matches.hpp"

namespace regista::campaign {
namespace {

constexpr std::size_t most_named = 10;  // damaged rows

std::string tables() { return StoredFixtures::tables + StoredMatches::tables() + StoredDocuments::tables; }

// Also for what stands in the file but was not written by this program.
template <class Parts, class Work>
auto guarded(Parts& parts, Work work) {
  const auto about = [&](const SQLite::Exception& error) {
    return fmt::format("results in {}: {}", parts.file.name(), reason(error));
  };
  try {
    return work();
  } catch (const SQLite::Exception& error) {
    if (is_of_the_disk(error)) throw StoreDiskError(about(error));
    throw StoreError(about(error));
  } catch (const DamagedRow& row) {
    std::string text;
    try {
      text = parts.damage(row);
    } catch (const SQLite::Exception& error) {
      text = about(error);
    }
    throw StoreDamaged(text);
  } catch (const std::invalid_argument& error) {
    throw StoreDamaged(fmt::format("results in {} are damaged: {}", parts.file.name(), error.what()));
  }
}

}  // namespace

struct Store::Parts {
  Parts(const std::filesystem::path& path, Mode mode, const std::string& version, Journal journal)
      : file(path, mode, version, tables(), journal),
        fixtures(file.database()),
        documents(file.database()),
        matches(opened(file)) {}

  // Also a file of ours may have been changed by others.
  static StoredMatches opened(StoreFile& file) {
    try {
      return StoredMatches(file.database(), file.written_to());
    } catch (const SQLite::Exception& error) {
      file.refuse(error);
    }
  }

  // What is said of one of them: which one, why, and how many there are.
  std::string damage(const DamagedRow& found) {
    std::string out = fmt::format("results in {} are damaged: match {}: {}", file.name(), found.row(), found.what());
    std::vector<std::int64_t> others = matches.damaged_rows();
    std::erase(others, found.row());
    if (others.empty()) return out;
    const std::size_t named = std::min(others.size(), most_named);
    out += fmt::format("; {} {} cannot be read either", others.size() == 1 ? "match" : "matches",
                       fmt::join(others.begin(), others.begin() + static_cast<std::ptrdiff_t>(named), ", "));
    return named == others.size() ? out : out + fmt::format(", nor can {} more", others.size() - named);
  }

  // All that is read between two rows written is read in one transaction: without one, SQLite locks and unlocks the
  // file for every single row.
  void begin_reading() {
    if (std::exchange(reading, true)) return;
    file.database().exec("BEGIN");
  }
  void end_reading() {
    if (!std::exchange(reading, false)) return;
    matches.reset();
    file.database().exec("COMMIT");
  }

  StoreFile file;
  StoredFixtures fixtures;
  StoredDocuments documents;
  StoredMatches matches;
  bool reading = false;
};

Store::Store(const std::filesystem::path& file, Mode mode, const std::string& program_version, Journal journal)
    : parts_(std::make_unique<Parts>(file, mode, program_version, journal)) {}
Store::~Store() = default;
Store::Store(Store&&) noexcept = default;

std::string Store::meta(const std::string& name) const {
  return guarded(*parts_, [&] { return parts_->file.meta(name); });
}

void Store::set_meta(const std::string& name, const std::string& value) {
  guarded(*parts_, [&] {
    parts_->end_reading();
    parts_->file.set_meta(name, value);
  });
}

std::vector<std::int64_t> Store::numbers(std::span<const std::string> keys) const {
  return guarded(*parts_, [&] { return parts_->fixtures.numbers(keys); });
}

std::vector<std::int64_t> Store::add(std::span<const Fixture> fixtures) {
  guarded(*parts_, [&] {
    parts_->end_reading();
    parts_->fixtures.add(fixtures);
  });
  std::vector<std::string> keys;
  for (const Fixture& fixture : fixtures) keys.push_back(fixture.key);
  return numbers(keys);
}

void Store::keep(std::span<const Document> documents) {
  guarded(*parts_, [&] {
    parts_->end_reading();
    parts_->documents.keep(documents);
  });
}

std::vector<Document> Store::documents() const {
  return guarded(*parts_, [&] { return parts_->documents.all(); });
}

std::optional<Decided> Store::find(std::int64_t row, const MatchKey& key, Metrics metrics) const {
  return guarded(*parts_, [&] {
    parts_->begin_reading();
    return parts_->matches.find(row, key, metrics);
  });
}

void Store::insert(std::int64_t row, const MatchKey& key, const Decided& decided, int attempts) {
  guarded(*parts_, [&] {
    parts_->file.require();
    parts_->end_reading();
    SQLite::Transaction transaction(parts_->file.database());
    parts_->matches.insert(row, key, decided, attempts);
    transaction.commit();
  });
}

Taken Store::take(const Store& other, Unknown unknown) {
  Parts& there = *other.parts_;
  const auto theirs = guarded(there, [&] {
    there.begin_reading();
    return there.fixtures.keys();
  });
  if (unknown == Unknown::planned) add(guarded(there, [&] { return there.fixtures.all(); }));
  std::vector<std::string> keys;
  for (const auto& [number, key] : theirs) keys.push_back(key);
  const std::vector<std::int64_t> ours = numbers(keys);
  FixtureNumbers mine;
  for (std::size_t i = 0; i < theirs.size(); ++i) {
    if (ours[i] != 0) mine.emplace(theirs[i].first, ours[i]);
  }
  return guarded(*parts_, [&] {
    parts_->file.require();
    parts_->end_reading();
    SQLite::Transaction transaction(parts_->file.database());
    Taken out = parts_->matches.take(there.matches, mine);
    transaction.commit();
    return out;
  });
}

std::optional<Store::Row> Store::row(std::int64_t row) const {
  return guarded(*parts_, [&]() -> std::optional<Row> {
    parts_->begin_reading();
    const auto found = parts_->matches.row(row);
    if (!found) return std::nullopt;
    Row out{parts_->fixtures.job(found->key.fixture, row), found->decided};
    out.job.seed = found->key.seed;
    return out;
  });
}

match::MetricPaths Store::metric_paths(std::int64_t rows) const {
  return guarded(*parts_, [&] { return parts_->matches.metric_paths(rows); });
}

void Store::require_file() const { parts_->file.require(); }

std::int64_t Store::rows() const {
  return guarded(*parts_, [&] { return parts_->matches.rows(); });
}

}  // namespace regista::campaign
