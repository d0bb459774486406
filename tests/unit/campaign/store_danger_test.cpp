// SPDX-License-Identifier: MIT
// What others do to a file of results while it is written or before it is read: they hold its lock, cut it off, write
// over it, or change what was planned.
#include <gmock/gmock.h>

#include <fstream>

#include "store_fixture.hpp"

namespace regista::campaign {
namespace {

using testing::HasSubstr;

class StoreDangerTest : public StoreTest {
 protected:
  // A file of several pages, all of it beyond the log.
  void fill(Store& store, int matches) {
    for (int i = 1; i <= matches; ++i)
      store.insert(i, {number(store, "key"), static_cast<std::uint64_t>(i)}, played, 1);
    execute("PRAGMA wal_checkpoint(FULL)");
    store.insert(matches + 1, {number(store, "key"), 1'000'000}, played, 1);
  }

  template <class Work>
  static std::string gone(Work work) {
    try {
      work();
    } catch (const StoreGone& error) {
      return error.what();
    }
    return "";
  }

  void overwrite(std::streamoff at, const std::string& bytes) const {
    std::fstream out(file, std::ios::binary | std::ios::in | std::ios::out);
    out.seekp(at);
    out << bytes;
  }
};

TEST_F(StoreDangerTest, MatchesWaitWhileAnotherProgramHoldsTheLock) {
  Store store(file, Mode::create, "1.0");
  const MatchKey first{number(store, "key"), 1}, second{number(store, "key"), 2};
  std::vector<Locked> said;
  store.when_locked([&](const Locked& locked) {
    said.push_back(locked);
    return true;
  });
  {
    SQLite::Database other(file.string(), SQLite::OPEN_READWRITE);
    other.exec("BEGIN IMMEDIATE");
    store.insert(1, first, played, 1);
    store.insert(2, second, forfeited, 1);
    EXPECT_FALSE(store.write_waiting());
    EXPECT_EQ(store.rows(), 0);
    EXPECT_EQ(store.find(1, first, Metrics::wanted), played);
    EXPECT_EQ(store.find(2, second, Metrics::wanted), forfeited);
    ASSERT_FALSE(said.empty());
    EXPECT_EQ(said.back().matches, 2u);
    EXPECT_FALSE(said.back().over);
    other.exec("COMMIT");
  }
  EXPECT_TRUE(store.write_waiting());
  EXPECT_TRUE(said.back().over);
  EXPECT_EQ(store.rows(), 2);
  EXPECT_EQ(store.row(1)->decided, played);
  EXPECT_EQ(store.row(2)->decided, forfeited);
  EXPECT_FALSE(store.waiting_is_full());
}

TEST_F(StoreDangerTest, WhatElseIsWrittenComesAfterWhatWaits) {
  Store store(file, Mode::create, "1.0");
  const MatchKey key{number(store, "key"), 1};
  SQLite::Database other(file.string(), SQLite::OPEN_READWRITE);
  other.exec("BEGIN IMMEDIATE");
  store.insert(1, key, played, 1);
  store.when_locked([&](const Locked& locked) {
    if (!locked.over) other.exec("COMMIT");
    return true;
  });
  store.set_meta("schedule", "a plan");
  EXPECT_EQ(store.rows(), 1);
  EXPECT_EQ(store.meta("schedule"), "a plan");
}

TEST_F(StoreDangerTest, AFileThatIsCutOffInPlaceIsGone) {
  Store store(file, Mode::create, "1.0");
  fill(store, 200);
  EXPECT_EQ(gone([&] { store.require_whole_file(); }), "");
  std::filesystem::resize_file(file, 0);
  EXPECT_THAT(gone([&] { store.insert(300, {number(store, "key"), 300}, played, 1); }), HasSubstr("bytes and has 0"));
}

TEST_F(StoreDangerTest, AFileThatBeginsOtherwiseIsGone) {
  Store store(file, Mode::create, "1.0");
  fill(store, 200);
  overwrite(0, "hello");
  EXPECT_THAT(gone([&] { store.insert(300, {number(store, "key"), 300}, played, 1); }), HasSubstr("does not begin as"));
}

TEST_F(StoreDangerTest, AFileThatIsOverwrittenInTheMiddleIsFoundAtTheEnd) {
  Store store(file, Mode::create, "1.0");
  fill(store, 200);
  const auto size = static_cast<std::streamoff>(std::filesystem::file_size(file));
  ASSERT_GT(size, 40'000);
  overwrite(8192, std::string(static_cast<std::size_t>(size) - 8192, '\0'));
  EXPECT_THAT(gone([&] { store.require_whole_file(); }), HasSubstr("something else has written into the file"));
}

TEST_F(StoreDangerTest, APlanThatWasChangedIsDamaged) {
  {
    Store store(file, Mode::create, "1.0");
    store.set_meta("schedule", "12 pairs");
    EXPECT_EQ(store.meta("schedule"), "12 pairs");
  }
  execute("UPDATE meta SET value = '8 pairs' WHERE name = 'schedule'");
  const Store store(file, Mode::read, "1.0");
  EXPECT_EQ(store.meta("program"), "1.0");
  try {
    store.meta("schedule");
    FAIL();
  } catch (const StoreDamaged& error) {
    EXPECT_THAT(error.what(), HasSubstr("the checksum of the plan of its study does not fit"));
  }
}

TEST_F(StoreDangerTest, AnOlderFileIsReadWithARemarkAndGetsChecksumsWhenItIsWrittenTo) {
  {
    Store store(file, Mode::create, "1.0");
    store.set_meta("schedule", "12 pairs");
    EXPECT_EQ(store.remark(), "");
  }
  execute("ALTER TABLE meta DROP COLUMN checksum");
  {
    const Store store(file, Mode::read, "1.0");
    EXPECT_EQ(store.meta("schedule"), "12 pairs");
    EXPECT_THAT(store.remark(), HasSubstr("its plan has no checksum"));
  }
  EXPECT_THAT(Store(file, Mode::open, "1.0").remark(), HasSubstr("its plan has no checksum"));
  const Store store(file, Mode::read, "1.0");
  EXPECT_EQ(store.remark(), "");
  EXPECT_EQ(store.meta("schedule"), "12 pairs");
}

TEST_F(StoreDangerTest, AMatchThatNobodyPlannedIsNamed) {
  Store store(file, Mode::create, "1.0");
  const std::int64_t key = number(store, "key");
  for (const int row : {1, 2, 7}) store.insert(row, {key, static_cast<std::uint64_t>(row)}, played, 1);
  const auto planned = [&](std::int64_t row, const MatchKey& stored) {
    return stored == MatchKey{key, static_cast<std::uint64_t>(row)} && row != 7;
  };
  store.require_planned(1, 6, planned);
  try {
    store.require_planned(1, 7, planned);
    FAIL();
  } catch (const StoreDamaged& error) {
    EXPECT_THAT(error.what(), HasSubstr("match 7: the study did not plan it"));
  }
}

}  // namespace
}  // namespace regista::campaign
