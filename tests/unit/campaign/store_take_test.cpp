// SPDX-License-Identifier: MIT
// Matches that were played into one file and come into another.
#include <gmock/gmock.h>

#include <fstream>

#include "campaign/store.hpp"
#include "campaign/stored_row.hpp"
#include "store_fixture.hpp"

namespace regista::campaign {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

class Take : public StoreTest {
 protected:
  // Fixtures and names of metrics have other numbers there than here.
  Take() {
    Store part(part_file, Mode::create, "1.0", Journal::rollback);
    second.score = {0, 7};
    second.hash = "aa";
    second.metrics = metrics_from_json(R"({"shots":[4,5]})");
    said.output = "a plugin said so";
    number(part, "other");
    number(part, "key");
    part.insert(3, {2, 5}, second, 1);
    part.insert(4, {1, 9}, forfeited, 2);
    part.insert(7, {2, 6}, said, 1);
  }

  Store here() const {
    Store out(file, Mode::create, "1.0", Journal::rollback);
    number(out, "key");
    number(out, "other");
    return out;
  }
  Store there() const { return {part_file, Mode::open, "1.0", Journal::rollback}; }

  std::filesystem::path part_file = folder / "part.db";
  MatchResult second = played, said = played;
};

TEST_F(Take, KeepsRowsAndAllThatStandsInThem) {
  {
    Store store = here();
    store.insert(1, {1, 1}, played, 1);
    EXPECT_EQ(store.take(there()), (Taken{3, 0, 0, {}}));
    // At once, and again.
    EXPECT_EQ(store.take(there()), (Taken{0, 3, 0, {}}));
  }
  const Store store(file, Mode::read, "1.0");
  EXPECT_EQ(store.rows(), 4);
  EXPECT_EQ(store.find(3, {1, 5}, Metrics::wanted), second);
  EXPECT_EQ(store.find(4, {2, 9}, Metrics::wanted), forfeited);
  EXPECT_EQ(store.find(7, {1, 6}, Metrics::wanted), said);
  EXPECT_EQ(store.row(3)->job.seed, 5u);
}

TEST_F(Take, LeavesOutWhatNobodyPlanned) {
  Store store(file, Mode::create, "1.0");
  number(store, "other");
  const Taken taken = store.take(there());
  EXPECT_EQ(taken.rows, 1u);
  EXPECT_EQ(taken.refused, 2u);
  EXPECT_THAT(taken.why, ElementsAre("match 3: nothing like it was planned", "match 7: nothing like it was planned"));
  EXPECT_EQ(store.take(there(), Store::Unknown::planned), (Taken{2, 1, 0, {}}));
  EXPECT_EQ(store.rows(), 3);
}

TEST_F(Take, RefusesAnotherResultOfTheSameMatchAndAnotherMatchInARow) {
  Store store = here();
  MatchResult different = second;
  different.hash = "bb";
  store.insert(8, {1, 5}, different, 1);
  store.insert(4, {1, 100}, played, 1);
  const Taken taken = store.take(there());
  EXPECT_EQ(taken.rows, 1u);
  EXPECT_THAT(taken.why, ElementsAre("match 3: the same match has the hash aa there and bb here",
                                     "match 4: its row holds another match"));
}

TEST_F(Take, LeavesOutWhatIsDamaged) {
  {
    SQLite::Database database(part_file.string(), SQLite::OPEN_READWRITE);
    database.exec("UPDATE matches SET home_goals = 1 WHERE row = 3");
    database.exec("UPDATE metrics SET size = size + 1 WHERE row = 7");
  }
  Store store = here();
  const Taken taken = store.take(there());
  EXPECT_EQ(taken.rows, 1u);
  EXPECT_EQ(taken.refused, 2u);
  ASSERT_EQ(taken.why.size(), 2u);
  EXPECT_EQ(taken.why[0], "match 3: its checksum does not fit");
  EXPECT_THAT(taken.why[1], HasSubstr("the checksum of its metrics does not fit"));
  // Nothing of them is here, so that they can be played again.
  EXPECT_EQ(store.rows(), 1);
  EXPECT_EQ(store.find(7, {1, 6}, Metrics::wanted), std::nullopt);
}

TEST_F(Take, LeavesOutNumbersWithoutNames) {
  struct Harm {
    const char *done, *said;
  };
  for (const Harm& harm : {Harm{"UPDATE metric_names SET names = '[]' WHERE id = 1", "metric names 1 does not fit"},
                           Harm{"DELETE FROM metric_names WHERE id = 1", "metric names 1 are missing"}}) {
    SQLite::Database(part_file.string(), SQLite::OPEN_READWRITE).exec(harm.done);
    std::filesystem::remove(file);
    Store store = here();
    const Taken taken = store.take(there());
    EXPECT_EQ(taken.rows, 2u);
    ASSERT_EQ(taken.why.size(), 1u);
    EXPECT_THAT(taken.why[0], AllOf(HasSubstr("match 3: "), HasSubstr(harm.said)));
    EXPECT_EQ(store.find(3, {1, 5}, Metrics::wanted), std::nullopt);
    EXPECT_EQ(store.find(7, {1, 6}, Metrics::wanted), said);
  }
}

// Names whose checksum fits, but which are none: of another program.
TEST_F(Take, LeavesOutNamesThatAreNone) {
  const std::string none = "names";
  SQLite::Database(part_file.string(), SQLite::OPEN_READWRITE)
      .exec("UPDATE metric_names SET names = '" + none +
            "', checksum = " + std::to_string(RowChecksum().bytes(none).value()) + " WHERE id = 1");
  Store store = here();
  const Taken taken = store.take(there());
  EXPECT_EQ(taken.rows, 2u);
  ASSERT_EQ(taken.why.size(), 1u);
  EXPECT_THAT(taken.why[0], HasSubstr("match 3: metrics: "));
  EXPECT_EQ(store.find(3, {1, 5}, Metrics::wanted), std::nullopt);
}

TEST_F(Take, OneThatIsWrittenToIsInUse) {
  const Store writing = there();
  EXPECT_THROW(there(), StoreInUse);
}

}  // namespace
}  // namespace regista::campaign
