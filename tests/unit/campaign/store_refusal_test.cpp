// SPDX-License-Identifier: MIT
// Files that are no results, belong to somebody else, may not be touched or are damaged.
#include <gmock/gmock.h>

#include <fstream>

#include "store_fixture.hpp"

namespace regista::campaign {
namespace {

using testing::HasSubstr;

// Rights of files do not bind the superuser: for as long as this lives, the process is nobody.
class AsNobody {
 public:
  AsNobody() : superuser_(geteuid() == 0) {
    if (superuser_) became_ = seteuid(65534) == 0;
  }
  ~AsNobody() {
    if (superuser_) came_back_ = seteuid(0) == 0;
  }
  AsNobody(const AsNobody&) = delete;
  AsNobody& operator=(const AsNobody&) = delete;
  bool bound() const { return became_; }

 private:
  bool superuser_, became_ = true, came_back_ = true;
};

class StoreRefusalTest : public StoreTest {
 protected:
  std::string refusal(Mode mode) const {
    try {
      Store store(file, mode, "1.0");
    } catch (const StoreRefusal& error) {
      EXPECT_THAT(error.what(), HasSubstr(file.string()));
      EXPECT_THAT(error.what(), testing::Not(HasSubstr("\n")));
      return error.what();
    }
    return "";
  }

  void make_file() {
    Store store(file, Mode::create, "1.0");
    store.insert(1, {number(store, "key"), 1}, forfeited, 1);
    store.insert(2, {number(store, "key"), 2}, played, 1);
  }

  // What reading row 1 says.
  std::string damage() const {
    const Store store(file, Mode::read, "1.0");
    try {
      store.row(1);
    } catch (const StoreError& error) {
      EXPECT_THAT(error.what(), HasSubstr(file.string()));
      return error.what();
    }
    return "";
  }
};

TEST_F(StoreRefusalTest, AFileThatExists) {
  { Store store(file, Mode::create, "1.0"); }
  EXPECT_THAT(refusal(Mode::create), HasSubstr("exists already; --resume continues it"));
}

TEST_F(StoreRefusalTest, AFileThatDoesNotExist) {
  EXPECT_THAT(refusal(Mode::open), HasSubstr("No such file or directory"));
  EXPECT_THAT(refusal(Mode::read), HasSubstr("cannot read"));
  EXPECT_THAT(refusal(Mode::read), HasSubstr("No such file or directory"));
  EXPECT_TRUE(names_in_folder().empty());
  file = folder / "no" / "folder.db";
  EXPECT_THAT(refusal(Mode::create), HasSubstr("No such file or directory"));
}

TEST_F(StoreRefusalTest, WhatIsNotItsOwn) {
  { SQLite::Database(file.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE).exec("CREATE TABLE matches(row)"); }
  for (const Mode mode : {Mode::open, Mode::read}) {
    EXPECT_THAT(refusal(mode), HasSubstr("is a database of another program"));
  }
  std::ofstream(file) << std::string(5000, 'x');
  for (const Mode mode : {Mode::open, Mode::read}) EXPECT_THAT(refusal(mode), HasSubstr("is no database"));
  file = folder;
  EXPECT_NE(refusal(Mode::open), "");
  EXPECT_NE(refusal(Mode::read), "");
}

TEST_F(StoreRefusalTest, ANewerSchema) {
  make_file();
  execute("PRAGMA user_version=7");
  for (const Mode mode : {Mode::open, Mode::read}) {
    EXPECT_THAT(refusal(mode), HasSubstr("was written by a newer Regista, 1.0: its schema is 7, this program reads 2"));
  }
}

TEST_F(StoreRefusalTest, AFileThatMissesATable) {
  for (const char* table : {"matches", "metrics", "metric_names", "remarks"}) {
    make_file();
    execute(std::string("DROP TABLE ") + table);
    for (const Mode mode : {Mode::open, Mode::read}) EXPECT_THAT(refusal(mode), HasSubstr("no such table"));
    std::filesystem::remove(file);
  }
}

TEST_F(StoreRefusalTest, AFileThatIsHeldByAProcess) {
  Store store(file, Mode::create, "1.0");
  EXPECT_THAT(refusal(Mode::open), HasSubstr("is in use by another process"));
}

TEST_F(StoreRefusalTest, ABlankFileHoldsNothingToRead) {
  std::ofstream(file).close();
  EXPECT_THAT(refusal(Mode::read), HasSubstr("holds no results yet"));
  EXPECT_EQ(std::filesystem::file_size(file), 0u);
}

TEST_F(StoreRefusalTest, WithoutTheRightToWriteItIsReadAllTheSame) {
  make_file();
  std::filesystem::permissions(file, std::filesystem::perms(0444));
  std::filesystem::permissions(folder, std::filesystem::perms(0555));
  const AsNobody nobody;
  ASSERT_TRUE(nobody.bound());
  EXPECT_THAT(refusal(Mode::open), HasSubstr("cannot write results to"));
  EXPECT_THAT(refusal(Mode::open), HasSubstr("Permission denied"));
  const Store store(file, Mode::read, "1.0");
  EXPECT_EQ(store.rows(), 2);
  EXPECT_EQ(store.row(2)->decided, played);
  file = folder / "new.db";
  EXPECT_THAT(refusal(Mode::create), HasSubstr("Permission denied"));
}

TEST_F(StoreRefusalTest, WithoutTheRightToRead) {
  make_file();
  std::filesystem::permissions(file, std::filesystem::perms::none);
  const AsNobody nobody;
  ASSERT_TRUE(nobody.bound());
  EXPECT_THAT(refusal(Mode::read), HasSubstr("Permission denied"));
}

TEST_F(StoreRefusalTest, DamagedTextsAreErrorsOfTheStore) {
  make_file();
  EXPECT_EQ(damage(), "");
  execute("UPDATE matches SET failure = '{' WHERE row = 1");
  EXPECT_THAT(damage(), HasSubstr("damaged"));
  Store(file, Mode::open, "1.0");  // opens all the same: other rows may be sound
  {
    const Store store(file, Mode::read, "1.0");
    EXPECT_THROW(store.find(1, {1, 1}, Metrics::left_out), StoreError);
    EXPECT_EQ(store.row(2)->decided, played);
  }
  std::filesystem::remove(file);
  make_file();
  execute("UPDATE fixtures SET job = '[]'");
  EXPECT_THAT(damage(), HasSubstr("match 1: the checksum of what was to be played does not fit"));
  execute("PRAGMA foreign_keys=OFF; DELETE FROM fixtures");
  EXPECT_THAT(damage(), HasSubstr("match 1: what was to be played is missing"));
}

TEST_F(StoreRefusalTest, OfManyDamagedMatchesSomeAreNamedAndTheRestCounted) {
  {
    Store store(file, Mode::create, "1.0");
    for (int i = 1; i <= 14; ++i) store.insert(i, {number(store, "key"), static_cast<std::uint64_t>(i)}, played, 1);
  }
  const std::string named = "match 1: its checksum does not fit; matches 2, 3, 4, 5, 6, 7, 8, 9, 10, 11 cannot be read";
  execute("UPDATE matches SET home_goals = home_goals + 1 WHERE row <= 11");
  EXPECT_THAT(damage(), testing::EndsWith(named + " either"));
  execute("UPDATE matches SET home_goals = home_goals + 1 WHERE row > 11");
  EXPECT_THAT(damage(), testing::EndsWith(named + " either, nor can 3 more"));
}

}  // namespace
}  // namespace regista::campaign
