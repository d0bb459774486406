// SPDX-License-Identifier: MIT
#include "campaign/store.hpp"

#include <SQLiteCpp/SQLiteCpp.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>

namespace regista::campaign {
namespace {

using testing::HasSubstr;
using Mode = Store::Mode;

class StoreTest : public testing::Test {
 protected:
  StoreTest() { std::filesystem::create_directory(folder); }
  ~StoreTest() override { std::filesystem::remove_all(folder); }

  std::string refusal(Mode mode) const {
    try {
      Store store(file, mode, "1.0");
    } catch (const StoreRefusal& error) {
      EXPECT_THAT(error.what(), HasSubstr(file.string()));
      return error.what();
    }
    return "";
  }

  std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / ("store-" + std::to_string(getpid()));
  std::filesystem::path file = folder / "results.db";
  Decided played{{3, 1}, "full_time", "9f2c", R"({"packets":[1,2]})", std::nullopt, 1.5};
  Decided forfeited = forfeit({1, "greedy", "assign", 3, 417, "Segmentation fault"}, 0.5);
};

TEST_F(StoreTest, GivesBackWhatWasInserted) {
  {
    Store store(file, Mode::create, "1.0");
    const auto fixture = store.fixture("key", "a vs b");
    store.insert(fixture, 1, played, 1);
    store.insert(fixture, UINT64_MAX, forfeited, 2);
    EXPECT_EQ(store.find(fixture, 1), played);
  }
  Store store(file, Mode::open, "1.1");
  const auto fixture = store.fixture("key", "a vs b");
  EXPECT_EQ(store.find(fixture, 1), played);
  EXPECT_EQ(store.find(fixture, UINT64_MAX), forfeited);
  EXPECT_EQ(store.find(fixture, 2), std::nullopt);
  EXPECT_EQ(store.find(fixture + 1, 1), std::nullopt);
  EXPECT_EQ(store.rows(), 2);
  EXPECT_EQ(store.meta("program"), "1.0");
}

TEST_F(StoreTest, WhatAForfeitHasNotIsNullAndNotZero) {
  {
    Store store(file, Mode::create, "1.0");
    store.insert(store.fixture("key", ""), 1, forfeited, 2);
  }
  SQLite::Database database(file.string());
  SQLite::Statement row(database, "SELECT hash IS NULL AND metrics IS NULL, attempts FROM matches");
  ASSERT_TRUE(row.executeStep());
  EXPECT_EQ(row.getColumn(0).getInt(), 1);
  EXPECT_EQ(row.getColumn(1).getInt(), 2);
}

TEST_F(StoreTest, NeverHoldsAMatchTwice) {
  Store store(file, Mode::create, "1.0");
  const auto fixture = store.fixture("key", "");
  EXPECT_EQ(store.fixture("key", "again"), fixture);
  store.insert(fixture, 1, played, 1);
  EXPECT_THROW(store.insert(fixture, 1, played, 1), StoreError);
  store.insert(store.fixture("other", ""), 1, played, 1);
  EXPECT_EQ(store.rows(), 2);
}

TEST_F(StoreTest, KeepsWhatItIsTold) {
  Store store(file, Mode::create, "1.0");
  EXPECT_EQ(store.meta("schedule"), "");
  store.set_meta("schedule", "one");
  store.set_meta("schedule", "two");
  EXPECT_EQ(store.meta("schedule"), "two");
}

TEST_F(StoreTest, SurvivesTheDeathOfItsProcess) {
  const pid_t child = fork();
  if (child == 0) {
    Store store(file, Mode::create, "1.0");
    const auto fixture = store.fixture("key", "");
    for (std::uint64_t seed = 1; seed <= 50; ++seed) store.insert(fixture, seed, played, 1);
    raise(SIGKILL);
  }
  ASSERT_EQ(waitpid(child, nullptr, 0), child);
  Store store(file, Mode::open, "1.0");
  EXPECT_EQ(store.rows(), 50);
  EXPECT_EQ(store.find(store.fixture("key", ""), 50), played);
}

TEST_F(StoreTest, AFileWithoutTablesIsAsGoodAsNew) {
  std::ofstream(file).close();  // killed at once
  Store store(file, Mode::open, "1.0");
  EXPECT_EQ(store.meta("program"), "1.0");
  EXPECT_EQ(store.rows(), 0);
}

TEST_F(StoreTest, RefusesAFileThatExists) {
  { Store store(file, Mode::create, "1.0"); }
  EXPECT_THAT(refusal(Mode::create), HasSubstr("exists already; --resume continues it"));
}

TEST_F(StoreTest, RefusesAFileThatDoesNotExist) {
  EXPECT_THAT(refusal(Mode::open), HasSubstr("No such file or directory"));
  file = folder / "no" / "folder.db";
  EXPECT_THAT(refusal(Mode::create), HasSubstr("No such file or directory"));
}

TEST_F(StoreTest, RefusesWhatIsNotItsOwn) {
  { SQLite::Database(file.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE).exec("CREATE TABLE matches(row)"); }
  EXPECT_THAT(refusal(Mode::open), HasSubstr("is a database of another program"));
  std::ofstream(file) << std::string(5000, 'x');
  EXPECT_THAT(refusal(Mode::open), HasSubstr("is no database"));
}

TEST_F(StoreTest, RefusesANewerSchema) {
  { Store store(file, Mode::create, "1.0"); }
  { SQLite::Database(file.string(), SQLite::OPEN_READWRITE).exec("PRAGMA user_version=7"); }
  EXPECT_THAT(refusal(Mode::open), HasSubstr("was written by a newer Regista: schema 7, this program knows up to 1"));
}

TEST_F(StoreTest, IsHeldByOneProcess) {
  Store store(file, Mode::create, "1.0");
  EXPECT_THAT(refusal(Mode::open), HasSubstr("is in use by another process"));
}

TEST_F(StoreTest, CanBeReadWhileItIsHeld) {
  Store store(file, Mode::create, "1.0");
  store.insert(store.fixture("key", ""), 1, played, 1);
  SQLite::Database reader(file.string(), SQLite::OPEN_READONLY);
  EXPECT_EQ(reader.execAndGet("SELECT count(*) FROM matches").getInt(), 1);
}

}  // namespace
}  // namespace regista::campaign
