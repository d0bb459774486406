// SPDX-License-Identifier: MIT
// What teams spent in matches, read without the other numbers of these.
#include <gmock/gmock.h>

#include <map>
#include <optional>
#include <string>

#include "campaign/stored_row.hpp"
#include "match/metric_numbers.hpp"
#include "store_fixture.hpp"

namespace regista::campaign {
namespace {

using match::Side;
using testing::HasSubstr;

class StorePackets : public StoreTest {
 protected:
  StorePackets() {
    for (MatchResult* const each : {&game, &whole, &half}) *each = played;
    game.metrics = metrics_from_json(
        R"({"shots": [4, 5], "packets": [28, 34], "packets_share": [30, 30.123456], "packets_over_share": [-2, 3.876544]})");
    whole.metrics = metrics_from_json(R"({"packets": [700, 800], "packets_share": [null, null], "shots": [1, 2]})");
    half.metrics = metrics_from_json(
        R"({"packets": [7, 8], "packets_share": [null, 3], "packets_over_share": [null, 5], "shots": [1, 2]})");
  }

  // By the seeds 1 to 4, in the rows 1, 3, 5 and 7.
  std::map<int, MatchResult> all() const { return {{1, game}, {2, whole}, {3, half}, {4, forfeited}}; }
  void make_file(const std::filesystem::path& path) const {
    Store store(path, Mode::create, "1.0");
    const auto fixture = number(store, "key");
    for (const auto& [seed, decided] : all()) store.insert(2 * seed - 1, {fixture, seed_of(seed)}, decided, 1);
  }
  static std::uint64_t seed_of(int seed) { return static_cast<std::uint64_t>(seed); }

  static MatchResult found(const Store& store, int seed, Metrics metrics) {
    return store.find(2 * seed - 1, {1, seed_of(seed)}, metrics).value();
  }

  // Of all matches, whatever is read of them.
  void expect_the_same_packets(const Store& store) const {
    for (const int seed : {4, 1, 2, 3, 1}) {
      const MatchResult decided = found(store, seed, Metrics::packets);
      EXPECT_EQ(decided.hash, all().at(seed).hash);
      for (const char* const name : match::packet_metrics) {
        for (const Side side : match::both_sides) {
          EXPECT_EQ(decided.metrics.of_side(side, name), all().at(seed).metrics.of_side(side, name)) << seed << name;
        }
      }
    }
  }

  int stored() const { return SQLite::Database(file.string()).execAndGet("SELECT count(*) FROM packets").getInt(); }

  MatchResult game, whole, half;
};

TEST_F(StorePackets, AreThoseOfTheMatch) {
  make_file(file);
  const Store store(file, Mode::read, "1.0");
  expect_the_same_packets(store);
  for (const auto& [seed, decided] : all()) EXPECT_EQ(found(store, seed, Metrics::wanted), decided);
}

TEST_F(StorePackets, ComeAlone) {
  make_file(file);
  EXPECT_EQ(stored(), 3);  // a forfeit has none
  const Store store(file, Mode::read, "1.0");
  for (const int seed : {1, 2, 3, 4}) {
    EXPECT_EQ(found(store, seed, Metrics::packets).metrics.of_side(Side::home, "shots"), std::nullopt) << seed;
  }
}

TEST_F(StorePackets, ComeWithTheMatchIntoAnotherFile) {
  make_file(folder / "part.db");
  {
    Store store(file, Mode::create, "1.0");
    number(store, "key");
    EXPECT_EQ(store.take(Store(folder / "part.db", Mode::open, "1.0")).rows, 4u);
    expect_the_same_packets(store);
  }
  EXPECT_EQ(stored(), 3);
}

TEST_F(StorePackets, OfFilesThatWereBegunBeforeThereWasATable) {
  make_file(file);
  execute("DROP TABLE packets");
  {
    Store store(file, Mode::open, "1.0");
    expect_the_same_packets(store);
    store.insert(9, {1, 9}, game, 1);
    EXPECT_EQ(store.find(9, {1, 9}, Metrics::packets), game);
  }
  Store later(folder / "later.db", Mode::create, "1.0");
  number(later, "key");
  EXPECT_EQ(later.take(Store(file, Mode::read, "1.0")).rows, 5u);
  expect_the_same_packets(later);
}

TEST_F(StorePackets, OfAMatchThatWasTakenOutByOthersAreWrittenAgain) {
  make_file(file);
  execute("DELETE FROM matches WHERE row = 1");
  execute("DELETE FROM metrics WHERE row = 1");
  Store store(file, Mode::open, "1.0");
  store.insert(1, {1, 1}, game, 1);
  expect_the_same_packets(store);
}

TEST_F(StorePackets, ThatAreDamagedAreNotTold) {
  struct Harm {
    std::string done, said;
  };
  const std::string few = "\x02\x02";
  const std::string checksum = std::to_string(RowChecksum().whole(1).bytes(few).value());
  for (const Harm& harm :
       {Harm{"UPDATE packets SET numbers = zeroblob(6)", "match 1: the checksum of its packets does not fit"},
        Harm{"UPDATE packets SET numbers = x'0202', checksum = " + checksum, "match 1: packets: fewer numbers"}}) {
    std::filesystem::remove(file);
    make_file(file);
    execute(harm.done);
    const Store store(file, Mode::read, "1.0");
    try {
      found(store, 1, Metrics::packets);
      ADD_FAILURE() << harm.done;
    } catch (const StoreDamaged& error) {
      EXPECT_THAT(error.what(), HasSubstr(harm.said));
    }
    EXPECT_EQ(found(store, 4, Metrics::packets), forfeited);
    EXPECT_EQ(found(store, 1, Metrics::wanted), game);
  }
}

TEST_F(StorePackets, ThatAreDamagedAreNotTakenOver) {
  make_file(file);
  execute("UPDATE packets SET checksum = checksum + 1 WHERE row = 1");
  Store other(folder / "other.db", Mode::create, "1.0");
  number(other, "key");
  const Taken taken = other.take(Store(file, Mode::read, "1.0"));
  EXPECT_EQ(taken.rows, 3u);
  EXPECT_THAT(taken.why, testing::ElementsAre("match 1: the checksum of its packets does not fit"));
  EXPECT_EQ(other.find(1, {1, 1}, Metrics::packets), std::nullopt);
}

}  // namespace
}  // namespace regista::campaign
