// SPDX-License-Identifier: MIT
// What a file of results gives back: to the process that writes it, to the next one, and to those who only read.
#include "campaign/store.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/file.h>
#include <sys/wait.h>

#include <csignal>
#include <fstream>
#include <iterator>

#include "process/file_descriptor.hpp"
#include "store_fixture.hpp"

namespace regista::campaign {
namespace {

using testing::ElementsAre;

TEST_F(StoreTest, GivesBackWhatWasInserted) {
  {
    Store store(file, Mode::create, "1.0");
    const auto fixture = number(store, "key");
    store.insert(1, {fixture, 1}, played, 1);
    store.insert(2, {fixture, UINT64_MAX}, forfeited, 2);
    EXPECT_EQ(store.find(1, {fixture, 1}, Metrics::wanted), played);
  }
  Store store(file, Mode::open, "1.1");
  const auto fixture = number(store, "key");
  EXPECT_EQ(store.find(1, {fixture, 1}, Metrics::wanted), played);
  EXPECT_EQ(store.find(2, {fixture, UINT64_MAX}, Metrics::wanted), forfeited);
  EXPECT_EQ(store.find(1, {fixture, 2}, Metrics::wanted), std::nullopt);
  EXPECT_EQ(store.find(1, {fixture + 1, 1}, Metrics::wanted), std::nullopt);
  EXPECT_EQ(store.rows(), 2);
  EXPECT_EQ(store.meta("program"), "1.0");
}

TEST_F(StoreTest, FindsAMatchWhereverItStands) {
  Store store(file, Mode::create, "1.0");
  const auto fixture = number(store, "key"), other = number(store, "other");
  MatchResult second = played;
  second.score = {0, 7};
  store.insert(1, {fixture, 5}, played, 1);
  store.insert(9, {other, 5}, second, 1);
  // At its place, at one that is empty, and at one that another match has.
  for (const std::int64_t row : {1, 4, 9}) {
    EXPECT_EQ(store.find(row, {fixture, 5}, Metrics::wanted), played) << row;
    EXPECT_EQ(store.find(row, {other, 5}, Metrics::wanted), second) << row;
    EXPECT_EQ(store.find(row, {fixture, 6}, Metrics::wanted), std::nullopt) << row;
  }
  // Whoever has looked at the place of another match does not stand in the way of those who write.
  store.insert(10, {fixture, 6}, played, 1);
  EXPECT_EQ(store.rows(), 3);
}

// Rows are read by one statement that goes on from row to row: whatever was asked for before, and whatever was written
// or went wrong meanwhile, what is asked for next is found.
TEST_F(StoreTest, FindsMatchesInAnyOrder) {
  Store store(file, Mode::create, "1.0");
  const auto fixture = number(store, "key");
  const auto match = [&](std::uint64_t row) {
    MatchResult out = played;
    out.score = {static_cast<int>(row), 0};
    return out;
  };
  const auto insert = [&](std::uint64_t row) {
    store.insert(static_cast<std::int64_t>(row), {fixture, row}, match(row), 1);
  };
  const auto find = [&](std::uint64_t row) {
    return store.find(static_cast<std::int64_t>(row), {fixture, row}, Metrics::wanted);
  };
  for (const std::uint64_t row : {1u, 3u, 4u, 5u, 8u}) insert(row);
  for (const std::uint64_t row : {1u, 3u, 4u, 5u, 8u}) EXPECT_EQ(find(row), match(row)) << row;  // over gaps
  EXPECT_EQ(find(9), std::nullopt);
  EXPECT_EQ(find(4), match(4));  // back
  EXPECT_EQ(find(4), match(4));  // again
  EXPECT_EQ(find(5), match(5));
  EXPECT_EQ(find(6), std::nullopt);  // the gap
  EXPECT_EQ(find(8), match(8));

  // What is added where the statement comes next, and behind its end.
  EXPECT_EQ(find(1), match(1));
  insert(2);
  EXPECT_EQ(find(2), match(2));
  EXPECT_EQ(find(8), match(8));
  EXPECT_EQ(find(9), std::nullopt);
  insert(9);
  EXPECT_EQ(find(9), match(9));

  // Other questions in between.
  EXPECT_EQ(find(3), match(3));
  EXPECT_EQ(store.row(1)->decided, match(1));
  EXPECT_EQ(store.find(100, {fixture, 8}, Metrics::wanted), match(8));
  EXPECT_EQ(find(4), match(4));
  EXPECT_THROW(insert(4), StoreError);
  EXPECT_EQ(find(5), match(5));
  // A row of its own, a row that is written, and that one.
  EXPECT_EQ(store.row(9)->decided, match(9));
  insert(10);
  EXPECT_EQ(find(10), match(10));
  EXPECT_EQ(store.row(INT64_MAX), std::nullopt);
}

TEST_F(StoreTest, ADamagedRowHidesNoOther) {
  {
    Store store(file, Mode::create, "1.0");
    const auto fixture = number(store, "key");
    for (const std::uint64_t row : {1u, 2u, 3u, 4u})
      store.insert(static_cast<std::int64_t>(row), {fixture, row}, played, 1);
  }
  execute("UPDATE matches SET home_goals = 9 WHERE row = 2");
  execute("UPDATE metrics SET numbers = zeroblob(10) WHERE row = 3");
  const Store store(file, Mode::read, "1.0");
  const auto fixture = store.numbers(std::vector<std::string>{"key"}).front();
  EXPECT_EQ(store.find(1, {fixture, 1}, Metrics::wanted), played);
  EXPECT_THROW(store.find(2, {fixture, 2}, Metrics::wanted), StoreError);
  EXPECT_THROW(store.find(3, {fixture, 3}, Metrics::wanted), StoreError);
  EXPECT_EQ(store.find(4, {fixture, 4}, Metrics::wanted), played);
  EXPECT_THROW(store.find(3, {fixture, 3}, Metrics::wanted), StoreError);
  EXPECT_TRUE(store.find(3, {fixture, 3}, Metrics::left_out));
  EXPECT_EQ(store.find(4, {fixture, 4}, Metrics::wanted), played);
}

TEST_F(StoreTest, LeavesMetricsOutWhereTheyAreNotWanted) {
  Store store(file, Mode::create, "1.0");
  const auto fixture = number(store, "key");
  store.insert(1, {fixture, 1}, played, 1);
  MatchResult without = played;
  without.metrics = {};
  EXPECT_EQ(store.find(1, {fixture, 1}, Metrics::left_out), without);
  EXPECT_EQ(store.find(7, {fixture, 1}, Metrics::left_out), without);
  EXPECT_EQ(store.find(1, {fixture, 1}, Metrics::wanted), played);
}

TEST_F(StoreTest, WhatAForfeitHasNotIsNullAndNotZero) {
  {
    Store store(file, Mode::create, "1.0");
    const auto fixture = number(store, "key");
    store.insert(1, {fixture, 1}, forfeited, 2);
    store.insert(2, {fixture, 2}, played, 1);
  }
  SQLite::Database database(file.string());
  SQLite::Statement row(database,
                        "SELECT hash IS NULL, failure IS NULL, attempts, (SELECT count(*) FROM metrics "
                        "WHERE metrics.row = matches.row) FROM matches ORDER BY row");
  for (const bool is_forfeit : {true, false}) {
    ASSERT_TRUE(row.executeStep());
    EXPECT_EQ(row.getColumn(0).getInt(), is_forfeit ? 1 : 0);
    EXPECT_EQ(row.getColumn(1).getInt(), is_forfeit ? 0 : 1);
    EXPECT_EQ(row.getColumn(2).getInt(), is_forfeit ? 2 : 1);
    EXPECT_EQ(row.getColumn(3).getInt(), is_forfeit ? 0 : 1);
  }
}

TEST_F(StoreTest, NeverHoldsAMatchOrAPlaceTwice) {
  Store store(file, Mode::create, "1.0");
  const auto fixture = number(store, "key"), other = number(store, "other");
  EXPECT_NE(fixture, other);
  store.insert(1, {fixture, 1}, played, 1);
  EXPECT_THROW(store.insert(2, {fixture, 1}, played, 1), StoreError);  // the match
  EXPECT_THROW(store.insert(1, {fixture, 2}, played, 1), StoreError);  // the place
  EXPECT_EQ(store.rows(), 1);
  // What was refused left nothing behind, and the store is as good as before.
  store.insert(2, {other, 1}, played, 1);
  EXPECT_EQ(store.find(2, {other, 1}, Metrics::wanted), played);
  EXPECT_EQ(store.rows(), 2);
}

TEST_F(StoreTest, FixturesHaveOneNumberEach) {
  Store store(file, Mode::create, "1.0");
  const std::vector<Store::Fixture> first{{"x", job_of("x.yaml", "b.yaml")}, {"y", job_of("y.yaml", "b.yaml")}};
  const auto numbers = store.add(first);
  ASSERT_EQ(numbers.size(), 2u);
  EXPECT_NE(numbers[0], numbers[1]);
  const std::vector<Store::Fixture> second{{"y", job_of("other.yaml", "b.yaml")}, {"z", {}}, {"x", {}}, {"y", {}}};
  const auto more = store.add(second);
  EXPECT_THAT(more,
              ElementsAre(numbers[1], testing::Not(testing::AnyOf(0, numbers[0], numbers[1])), numbers[0], numbers[1]));
  EXPECT_THAT(store.numbers(std::vector<std::string>{"z", "nobody", "x"}), ElementsAre(more[1], 0, numbers[0]));
  // A fixture stays what it was when it was added.
  store.insert(1, {numbers[1], 4}, played, 1);
  EXPECT_EQ(store.row(1)->job.teams[0], "y.yaml");
}

TEST_F(StoreTest, ARowTellsWhatWasPlayed) {
  {
    Store store(file, Mode::create, "1.0");
    const auto fixture = number(store, "key");
    store.insert(3, {fixture, UINT64_MAX}, played, 1);
    store.insert(5, {fixture, 2}, forfeited, 1);
  }
  const Store store(file, Mode::read, "1.0");
  Job job = job_of("a.yaml", "b.yaml");
  job.seed = UINT64_MAX;
  const auto third = store.row(3), fifth = store.row(5);
  ASSERT_TRUE(third && fifth);
  EXPECT_EQ(third->job, job);
  EXPECT_EQ(third->decided, played);
  job.seed = 2;
  EXPECT_EQ(fifth->job, job);
  EXPECT_EQ(fifth->decided, forfeited);
  for (const std::int64_t row : {-1, 0, 1, 4, 6}) EXPECT_FALSE(store.row(row)) << row;
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
    const auto fixture = number(store, "key");
    for (std::uint64_t seed = 1; seed <= 50; ++seed) {
      store.insert(static_cast<std::int64_t>(seed), {fixture, seed}, played, 1);
    }
    raise(SIGKILL);
  }
  ASSERT_EQ(waitpid(child, nullptr, 0), child);
  {  // the log is still there, and is read as well
    const Store reader(file, Mode::read, "1.0");
    EXPECT_EQ(reader.rows(), 50);
    EXPECT_EQ(reader.row(50)->decided, played);
  }
  Store store(file, Mode::open, "1.0");
  EXPECT_EQ(store.rows(), 50);
  EXPECT_EQ(store.find(50, {number(store, "key"), 50}, Metrics::wanted), played);
}

TEST_F(StoreTest, AFileWithoutTablesIsAsGoodAsNew) {
  std::ofstream(file).close();  // killed at once
  Store store(file, Mode::open, "1.0");
  EXPECT_EQ(store.meta("program"), "1.0");
  EXPECT_EQ(store.rows(), 0);
}

TEST_F(StoreTest, IsReadBesideTheProcessThatWritesIt) {
  Store writer(file, Mode::create, "1.0");
  const auto fixture = number(writer, "key");
  writer.insert(1, {fixture, 1}, played, 1);
  const Store reader(file, Mode::read, "1.0"), another(file, Mode::read, "1.0");
  EXPECT_EQ(reader.rows(), 1);
  writer.insert(2, {fixture, 2}, forfeited, 1);
  EXPECT_EQ(reader.rows(), 2);
  EXPECT_EQ(reader.find(2, {fixture, 2}, Metrics::wanted), forfeited);
  EXPECT_EQ(another.row(1)->decided, played);
  EXPECT_EQ(writer.find(1, {fixture, 1}, Metrics::wanted), played);
}

TEST_F(StoreTest, ReadingChangesNothing) {
  {
    Store store(file, Mode::create, "1.0");
    store.insert(1, {number(store, "key"), 1}, played, 1);
  }
  const auto content = [&] {
    std::ifstream stream(file, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(stream), {});
  };
  const std::string before = content();
  {
    const Store reader(file, Mode::read, "1.1");
    EXPECT_EQ(reader.rows(), 1);
    EXPECT_THAT(names_in_folder(), ElementsAre("results.db"));
  }
  EXPECT_THAT(names_in_folder(), ElementsAre("results.db"));
  EXPECT_EQ(content(), before);
}

TEST_F(StoreTest, AReaderCannotWrite) {
  { Store store(file, Mode::create, "1.0"); }
  Store reader(file, Mode::read, "1.0");
  EXPECT_THROW(reader.set_meta("program", "2.0"), StoreError);
  EXPECT_THROW(number(reader, "key"), StoreError);
  EXPECT_EQ(reader.meta("program"), "1.0");
}

// Signs that mean something in an address, as which SQLite may take a path.
TEST_F(StoreTest, PathsMayHoldAnySign) {
  for (const char* name : {"a b.db", "a?mode=memory.db", "a#b.db", "a%20b.db", "100%.db", "ü&=;+\".db", "file:x.db"}) {
    file = folder / name;
    {
      Store store(file, Mode::create, "1.0");
      store.insert(1, {number(store, "key"), 1}, played, 1);
    }
    EXPECT_TRUE(std::filesystem::exists(file)) << name;
    { EXPECT_EQ(Store(file, Mode::read, "1.0").rows(), 1) << name; }
    { EXPECT_EQ(Store(file, Mode::open, "1.0").rows(), 1) << name; }
    std::filesystem::remove(file);
    EXPECT_TRUE(std::filesystem::is_empty(folder)) << name;
  }
}

TEST_F(StoreTest, NoNameInTheCurrentFolderMeansSomethingElse) {
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::current_path(folder);
  for (const char* name : {":memory:", "file::memory:", "results.db"}) {
    {
      Store store(name, Mode::create, "1.0");
      store.insert(1, {number(store, "key"), 1}, played, 1);
    }
    { EXPECT_EQ(Store(name, Mode::open, "1.0").rows(), 1) << name; }
    { EXPECT_EQ(Store(name, Mode::read, "1.0").rows(), 1) << name; }
  }
  std::filesystem::current_path(before);
}

// On network file systems flock() and the locks of SQLite are the same: whoever has both is in its own way.
TEST_F(StoreTest, UsesNoLockOfTheOtherKind) {
  for (const Journal journal : {Journal::log, Journal::rollback}) {
    std::filesystem::remove(file);
    Store store(file, Mode::create, "1.0", journal);
    store.insert(1, {number(store, "key"), 1}, played, 1);
    const process::FileDescriptor other(::open(file.c_str(), O_RDWR | O_CLOEXEC));
    EXPECT_EQ(::flock(other.number, LOCK_EX | LOCK_NB), 0);
    store.insert(2, {number(store, "key"), 2}, played, 1);
    EXPECT_THROW(Store(file, Mode::open, "1.0", journal), StoreInUse);
  }
}

}  // namespace
}  // namespace regista::campaign
