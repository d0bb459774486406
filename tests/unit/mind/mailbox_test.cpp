// SPDX-License-Identifier: MIT
// Offers from a plugin to a packet, and segments from a packet to a plugin: every way an offer can end, exactly once,
// and never within one of the plugin's own calls.
#include "mind/world/mailboxes.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>

#include "in_process.hpp"
#include "regista/utility.hpp"

namespace regista::mind {
namespace {

using Bytes = std::vector<std::uint8_t>;

// Does in its calls what the test says, and writes down what it is told.
struct Box {
  static constexpr auto id = "box", version = "1.0.0", summary = "Watched by a test";
  static inline std::function<void(Box&)> in_score, in_dropped, in_transmitted, in_receive, in_destroy;

  void setup(const Environment&, Mailbox given) { mailbox = given; }
  ~Box() {
    if (in_destroy) in_destroy(*this);
  }
  void score(const Frame&, Utilities) {
    during([this] { in_score(*this); });
  }
  void transmitted(std::uint64_t handle) {
    during([&] {
      log += "t" + std::to_string(handle) + " ";
      if (in_transmitted) in_transmitted(*this);
    });
  }
  void dropped(std::uint64_t handle) {
    during([&] {
      log += "d" + std::to_string(handle) + " ";
      if (in_dropped) in_dropped(*this);
    });
  }
  void receive(const Message& message) {
    during([&] {
      log += "r" + std::to_string(message.sender()) + ":";
      for (const std::uint8_t byte : message.bytes()) log += std::to_string(byte) + ",";
      log += " ";
      sent = message.time_sent();
      heard = message.time_heard();
      if (in_receive) in_receive(*this);
    });
  }

  std::string describe(std::span<const std::uint8_t> bytes) const {
    if (inside) throw std::logic_error("called from within its own call");
    ++asked;
    if (in_describe) in_describe(*this);
    return std::to_string(bytes.size()) + " bytes";
  }

  template <class Body>
  void during(Body&& body) {
    if (inside) throw std::logic_error("called from within its own call");
    inside = true;
    body();
    inside = false;
  }

  static inline int asked = 0;  // to describe bytes
  static inline std::function<void(const Box&)> in_describe;
  Mailbox mailbox;
  std::string log;
  double sent = 0.0, heard = 0.0;
  bool inside = false;
};

// Takes no messages.
struct Mute {
  static constexpr auto id = "mute", version = "1.0.0", summary = "Says and hears nothing";
  void score(const Frame&, Utilities) {}
};

class MailboxTest : public testing::Test {
 protected:
  MailboxTest() { Box::asked = 0; }
  ~MailboxTest() override {
    Box::in_score = Box::in_dropped = Box::in_transmitted = Box::in_receive = Box::in_destroy = nullptr;
  }

  // A robot's mailboxes with one box.
  struct Robot {
    explicit Robot(std::size_t packet_size = 128, bool journal = false) : mailboxes(packet_size, journal) { add(); }
    void add() { add<Box>(); }
    void add_mute() { add<Mute>(); }
    template <class Class>
    void add() {
      regista_environment environment{};
      environment.own_number = 1;
      const auto instance = in_process<Class, utility>(environment, mailboxes.open());
      mailboxes.connect(instance);
      instances.push_back(instance);
    }
    // Runs `body` within a call of box number `which`.
    void within(std::function<void(Box&)> body, std::size_t which = 0) {
      Box::in_score = std::move(body);
      regista_frame frame{};
      plugin::Utility(instances[which]).score(frame, 1, 1);
    }
    std::string log(std::size_t which = 0) {
      std::string out;
      within([&](Box& box) { std::swap(out, box.log); }, which);
      return out;
    }
    std::uint64_t offer(Bytes bytes, double expiry = 100.0, std::uint64_t replaces = 0, std::size_t which = 0) {
      std::uint64_t handle = 0;
      within([&](Box& box) { handle = box.mailbox.offer(bytes, 0.5, expiry, replaces); }, which);
      return handle;
    }
    std::vector<std::uint64_t> pending() {
      std::vector<std::uint64_t> out;
      for (const regista_offer& each : mailboxes.pending()) out.push_back(each.handle);
      return out;
    }

    Mailboxes mailboxes;
    std::vector<std::shared_ptr<plugin::Instance>> instances;
  };
  using Handles = std::vector<std::uint64_t>;
};

TEST_F(MailboxTest, AnOfferTravelsToTheSamePlaceOfATeammate) {
  Robot one, two;
  one.add();
  two.add();
  const std::uint64_t handle = one.offer({7, 8, 9}, 100.0, 0, 1);
  ASSERT_GT(handle, 0u);
  const auto pending = one.mailboxes.pending();
  ASSERT_EQ(pending.size(), 1u);
  EXPECT_EQ(pending[0].bytes, 5u) << "with its heading";
  EXPECT_EQ(pending[0].urgency, 0.5);
  EXPECT_EQ(pending[0].expiry, 100.0);

  Report report;
  report.sender = 3;
  Bytes packet;
  encode(report, packet);
  one.mailboxes.load(Handles{handle}, packet);
  EXPECT_EQ(one.log(1), "t1 ");
  EXPECT_EQ(one.log(0), "");
  EXPECT_TRUE(one.pending().empty());

  std::vector<Segment> segments;
  ASSERT_TRUE(decode(packet, {.team_size = 7, .role_count = 1, .context_count = 1, .size = 128}, segments));
  ASSERT_EQ(segments.size(), 1u);
  two.mailboxes.deliver(segments[0], 0, 3, 1.5, 1.6);
  EXPECT_EQ(two.log(0), "");
  two.within(
      [](Box& box) {
        EXPECT_EQ(box.log, "r3:7,8,9, ");
        EXPECT_EQ(box.sent, 1.5);
        EXPECT_EQ(box.heard, 1.6);
      },
      1);
}

TEST_F(MailboxTest, PlacesThatDoNotExistHearNothing) {
  Robot robot;
  const Bytes bytes{1};
  robot.mailboxes.deliver({1, bytes}, 0, 2, 0.0, 0.0);
  robot.mailboxes.deliver({255, bytes}, 1, 2, 0.0, 0.0);
  EXPECT_EQ(robot.log(), "");
}

TEST_F(MailboxTest, ReplacingDropsTheOldOneWithNotice) {
  Robot robot;
  const auto first = robot.offer({1});
  const auto second = robot.offer({2}, 100.0, first);
  EXPECT_EQ(robot.pending(), Handles{second});
  EXPECT_EQ(robot.log(), "d1 ");
  EXPECT_NE(robot.offer({3}, 100.0, first), 0u) << "replacing what is gone is a plain offer";
  EXPECT_EQ(robot.pending().size(), 2u);
  EXPECT_EQ(robot.log(), "");
}

TEST_F(MailboxTest, ARefusedReplacementLeavesTheOldOne) {
  Robot robot;
  const auto first = robot.offer({1});
  EXPECT_EQ(robot.offer(Bytes(200), 100.0, first), 0u);
  EXPECT_EQ(robot.pending(), Handles{first});
}

TEST_F(MailboxTest, NobodyReplacesOrWithdrawsTheOffersOfOthers) {
  Robot robot;
  robot.add();
  const auto first = robot.offer({1}, 100.0, 0, 0);
  const auto second = robot.offer({2}, 100.0, first, 1);
  robot.within([&](Box& box) { box.mailbox.withdraw(first); }, 1);
  EXPECT_EQ(robot.pending(), (Handles{first, second}));
}

TEST_F(MailboxTest, WithdrawingDropsWithNotice) {
  Robot robot;
  const auto handle = robot.offer({1});
  robot.within([&](Box& box) {
    box.mailbox.withdraw(handle);
    box.mailbox.withdraw(handle);  // ignored
    box.mailbox.withdraw(77);
    EXPECT_EQ(box.log, "") << "not within its own call";
  });
  EXPECT_TRUE(robot.pending().empty());
  EXPECT_EQ(robot.log(), "d1 ");
}

TEST_F(MailboxTest, ExpiredOffersAreDroppedWhenTheirTimeHasCome) {
  Robot robot;
  robot.mailboxes.begin(1.0);
  EXPECT_EQ(robot.offer({1}, 1.0), 0u) << "expired already";
  robot.offer({1}, 2.0);
  robot.offer({2}, 3.0);
  robot.mailboxes.begin(1.9);
  EXPECT_EQ(robot.log(), "");
  robot.mailboxes.begin(2.0);
  EXPECT_EQ(robot.log(), "d1 ");
  EXPECT_EQ(robot.pending(), Handles{2});
  robot.mailboxes.begin(10.0);
  EXPECT_EQ(robot.log(), "d2 ");
  EXPECT_TRUE(robot.pending().empty());
}

TEST_F(MailboxTest, MayOfferAndWithdrawWhileTold) {
  Robot robot;
  const auto kept = robot.offer({1}, 100.0);
  robot.offer({2}, 2.0);
  robot.offer({3}, 2.0);
  robot.offer({4}, 2.0);
  // The first notice withdraws an earlier offer and makes a new one.
  Box::in_dropped = [&](Box& box) {
    Box::in_dropped = nullptr;
    box.mailbox.withdraw(kept);
    EXPECT_EQ(box.mailbox.offer(Bytes{9}, 1.0, 50.0), 5u);
  };
  robot.mailboxes.begin(2.0);
  EXPECT_EQ(robot.log(), "d2 d3 d4 ") << "all that expired, none skipped";
  EXPECT_EQ(robot.pending(), Handles{5});
  EXPECT_EQ(robot.log(), "d1 ");
}

TEST_F(MailboxTest, APluginThatOffersWhenToldComesToAnEnd) {
  Robot robot;
  robot.offer({1}, 2.0);
  Box::in_dropped = [](Box& box) { box.mailbox.withdraw(box.mailbox.offer(Bytes{1}, 1.0, 50.0)); };
  robot.mailboxes.begin(2.0);
  robot.mailboxes.begin(2.1);
  EXPECT_EQ(robot.log(), "d1 d2 ");
  Box::in_dropped = nullptr;
}

TEST_F(MailboxTest, MayOfferAgainWhenTransmitted) {
  Robot robot;
  const auto first = robot.offer({1});
  Box::in_transmitted = [](Box& box) { EXPECT_NE(box.mailbox.offer(Bytes{2}, 0.5, 50.0), 0u); };
  Bytes packet(30);
  robot.mailboxes.load(Handles{first}, packet);
  EXPECT_EQ(packet.size(), 33u);
  EXPECT_EQ(robot.pending(), Handles{2});
}

TEST_F(MailboxTest, RefusesWhatNoPacketCanTakeAndWhatMakesNoSense) {
  Robot robot;  // 128 bytes, less 55 of the largest core, less 2 of heading
  robot.within([](Box& box) {
    EXPECT_EQ(box.mailbox.bytes_free(), 71u);
    EXPECT_EQ(box.mailbox.offer(Bytes(72), 0.5, 10.0), 0u);
    EXPECT_NE(box.mailbox.offer(Bytes(71), 0.5, 10.0), 0u);
    EXPECT_NE(box.mailbox.offer(Bytes{}, 0.5, 10.0), 0u) << "an empty segment is one";
    EXPECT_EQ(box.mailbox.offer(Bytes(1), -0.1, 10.0), 0u);
    EXPECT_EQ(box.mailbox.offer(Bytes(1), 1.1, 10.0), 0u);
    EXPECT_EQ(box.mailbox.offer(Bytes(1), std::nan(""), 10.0), 0u);
    EXPECT_EQ(box.mailbox.offer(Bytes(1), 0.5, std::nan("")), 0u);
    EXPECT_EQ(box.mailbox.offer(Bytes(1), 0.5, 10.0, 0, 5), 0u) << "a medium that does not exist";
  });
  Robot small(56), large(1024);
  small.within([](Box& box) { EXPECT_EQ(box.mailbox.bytes_free(), 0u); });
  large.within([](Box& box) { EXPECT_EQ(box.mailbox.bytes_free(), 255u); });
}

TEST_F(MailboxTest, AnInstanceMayHaveSixtyFourOffersPending) {
  Robot robot;
  robot.add();
  for (int k = 0; k < 64; ++k) EXPECT_NE(robot.offer({1}), 0u);
  EXPECT_EQ(robot.offer({1}), 0u);
  EXPECT_NE(robot.offer({1}, 100.0, 7), 0u) << "in the place of another";
  EXPECT_NE(robot.offer({1}, 100.0, 0, 1), 0u) << "the other instance";
  EXPECT_EQ(robot.pending().size(), 65u);
}

TEST_F(MailboxTest, WhatDoesNotFitStaysPending) {
  Robot robot;
  const auto first = robot.offer(Bytes(60)), second = robot.offer(Bytes(60)), third = robot.offer(Bytes(1));
  Bytes packet(55);
  EXPECT_EQ(robot.mailboxes.bytes_free(), 73u);
  robot.mailboxes.load(Handles{first, second, third, 99}, packet);
  EXPECT_EQ(packet.size(), 55u + 62u + 3u);
  EXPECT_EQ(robot.pending(), Handles{second});
  EXPECT_EQ(robot.log(), "t1 t3 ");
  EXPECT_EQ(Robot(55).mailboxes.bytes_free(), 0u);
}

// --- What recorders and reports are told -----------------------------------------------------------------------------

class JournalTest : public MailboxTest {
 protected:
  // "offered 1 box 0 [7,8] 'two bytes'; dropped 1 expired", of what happened since the last begin().
  static std::string told(Robot& robot) {
    robot.mailboxes.complete_journal();
    std::string out;
    for (const SegmentEvent& event : robot.mailboxes.journal()) {
      if (!out.empty()) out += "; ";
      out += word(event.kind);
      if (event.handle != 0) out += ' ' + std::to_string(event.handle);
      if (event.why != SegmentEvent::Why::none) out += std::string(" ") + word(event.why);
      if (event.replaced_by != 0) out += " by " + std::to_string(event.replaced_by);
      if (event.sender != 0) out += " from " + std::to_string(event.sender);
    }
    return out;
  }
  static std::vector<std::int64_t> plural(Robot& robot) {
    const SegmentCounts counts = robot.mailboxes.take_counts();
    return {counts.offered, counts.refused, counts.sent, counts.dropped, counts.heard, counts.bytes};
  }
  using Counts = std::vector<std::int64_t>;
};

TEST_F(JournalTest, FollowsEachOfferToItsEnd) {
  Robot robot(128, true);
  robot.mailboxes.begin(1.0);
  const auto first = robot.offer({7, 8}, 3.0);
  const auto second = robot.offer({9}, 100.0, first);
  robot.within([&](Box& box) { box.mailbox.withdraw(second); });
  const auto third = robot.offer({1, 2, 3});
  const auto fourth = robot.offer({4}, 2.0);
  Bytes packet(55);
  robot.mailboxes.load(Handles{third, 99}, packet);
  EXPECT_EQ(told(robot),
            "offered 1; dropped 1 replaced by 2; offered 2; dropped 2 withdrawn; offered 3; offered 4; sent 3");
  const SegmentEvent& offered = robot.mailboxes.journal()[0];
  EXPECT_EQ(offered.bytes, (Bytes{7, 8}));
  EXPECT_EQ(offered.length, 2u);
  EXPECT_EQ(std::tuple(offered.time, offered.place, offered.urgency, offered.expiry), std::tuple(1.0, 0, 0.5, 3.0));
  EXPECT_STREQ(offered.plugin, "box");
  EXPECT_EQ(offered.text, "2 bytes");
  EXPECT_EQ(plural(robot), (Counts{4, 0, 1, 2, 0, 5}));

  robot.mailboxes.begin(2.0);
  EXPECT_EQ(told(robot), "dropped " + std::to_string(fourth) + " expired");
  EXPECT_EQ(robot.mailboxes.journal()[0].time, 2.0);
  EXPECT_EQ(plural(robot), (Counts{0, 0, 0, 1, 0, 0}));
  robot.mailboxes.begin(2.1);
  EXPECT_EQ(told(robot), "");
  EXPECT_EQ(plural(robot), (Counts{0, 0, 0, 0, 0, 0}));
}

TEST_F(JournalTest, SaysWhichSegmentOfItsPacketItIs) {
  Robot robot(128, true);
  const auto first = robot.offer({1}), large = robot.offer(Bytes(71)), third = robot.offer({3});
  robot.mailboxes.begin(1.0);
  Bytes packet(60);
  robot.mailboxes.load(Handles{third, large, first}, packet);
  std::vector<std::pair<std::uint64_t, int>> sent;
  for (const SegmentEvent& event : robot.mailboxes.journal()) {
    if (event.kind == SegmentEvent::Kind::sent) sent.emplace_back(event.handle, event.at);
  }
  EXPECT_EQ(sent, (std::vector<std::pair<std::uint64_t, int>>{{third, 0}, {first, 1}})) << "the large one does not fit";
}

TEST_F(JournalTest, SaysWhyAnOfferIsRefused) {
  Robot robot(128, true);
  robot.mailboxes.begin(1.0);
  robot.within([](Box& box) {
    box.mailbox.offer(Bytes(72), 0.5, 10.0);
    box.mailbox.offer(Bytes(300), 0.5, 10.0);
    box.mailbox.offer(Bytes(1), 1.1, 10.0);
    box.mailbox.offer(Bytes(1), 0.5, 1.0);
    for (int k = 0; k < 65; ++k) box.mailbox.offer(Bytes(1), 0.5, 10.0);
  });
  robot.mailboxes.complete_journal();
  std::string why;
  for (const SegmentEvent& event : robot.mailboxes.journal()) {
    if (event.kind == SegmentEvent::Kind::refused) why += std::string(word(event.why)) + ' ';
  }
  EXPECT_EQ(why, "too_long too_long senseless expired too_many_pending ");
  const SegmentEvent &long_one = robot.mailboxes.journal()[0], &huge = robot.mailboxes.journal()[1];
  EXPECT_EQ(std::tuple(long_one.length, long_one.bytes.size(), long_one.text), std::tuple(72u, 72u, "72 bytes"));
  EXPECT_EQ(std::tuple(huge.length, huge.bytes.size(), huge.text), std::tuple(300u, 0u, ""));
  EXPECT_EQ(plural(robot), (Counts{64, 5, 0, 0, 0, 0}));
}

TEST_F(JournalTest, SaysWhatCameAndWhatWentNowhere) {
  Robot robot(128, true);
  robot.add_mute();
  robot.mailboxes.begin(2.0);
  const Bytes bytes{5, 6};
  robot.mailboxes.deliver({0, bytes}, 0, 3, 1.5, 1.75);
  robot.mailboxes.deliver({1, bytes}, 1, 3, 1.5, 1.75);
  robot.mailboxes.deliver({9, bytes}, 2, 3, 1.5, 1.75);
  robot.mailboxes.wrong_length(4, 1.25, 1.5);
  EXPECT_EQ(told(robot),
            "heard from 3; undelivered no_mailbox from 3; undelivered unknown_place from 3; "
            "undelivered wrong_length from 4");
  const std::span<const SegmentEvent> journal = robot.mailboxes.journal();
  EXPECT_EQ(journal[0].bytes, bytes);
  EXPECT_EQ(std::tuple(journal[0].time, journal[0].time_sent, journal[0].time_heard), std::tuple(2.0, 1.5, 1.75));
  EXPECT_EQ(std::tuple(journal[0].at, journal[1].at, journal[2].at), std::tuple(0, 1, 2));
  EXPECT_STREQ(journal[1].plugin, "mute");
  EXPECT_STREQ(journal[2].plugin, "");
  EXPECT_EQ(journal[3].place, -1);
  EXPECT_EQ(plural(robot), (Counts{0, 0, 0, 0, 1, 0}));
}

TEST_F(JournalTest, WhatIsOfferedWhileItIsCreatedStandsWithTheFirstDecision) {
  Robot robot(128, true);
  robot.offer({1});
  robot.mailboxes.begin(0.0);
  EXPECT_EQ(told(robot), "offered 1");
  robot.mailboxes.begin(0.1);
  EXPECT_EQ(told(robot), "");
}

TEST_F(JournalTest, NothingIsOfferedOrWithdrawnWhileBytesAreDescribed) {
  Robot robot(128, true);
  robot.mailboxes.begin(1.0);
  const auto first = robot.offer({1});
  Box::in_describe = [&](const Box& box) {
    for (int i = 0; i < 100; ++i) EXPECT_EQ(box.mailbox.offer(Bytes{2}, 0.5, 100.0), 0u);
    box.mailbox.withdraw(first);
  };
  EXPECT_EQ(told(robot), "offered 1");
  Box::in_describe = nullptr;
  EXPECT_EQ(robot.mailboxes.pending().size(), 1u);
  EXPECT_EQ(plural(robot), (Counts{1, 0, 0, 0, 0, 0}));
}

TEST_F(JournalTest, ADescriptionThatFailsIsToldAndEndsNothing) {
  Robot robot(128, true);
  robot.mailboxes.begin(1.0);
  robot.offer({1});
  Box::in_describe = [](const Box&) { throw std::runtime_error("lost for words"); };
  robot.mailboxes.complete_journal();
  Box::in_describe = nullptr;
  EXPECT_EQ(robot.mailboxes.journal()[0].text, "describe failed: lost for words");
}

TEST_F(JournalTest, ADecisionIsToldUpToAThousandEvents) {
  Robot robot(128, true);
  robot.mailboxes.begin(1.0);
  std::uint64_t last = 0;
  for (int i = 0; i < 5000; ++i) last = robot.offer({1}, 100.0, last);
  EXPECT_EQ(robot.mailboxes.journal().size(), 1024u);
  EXPECT_EQ(plural(robot)[0], 5000u);
}

TEST_F(JournalTest, NobodyRecordsNobodyIsAsked) {
  Robot robot;
  robot.mailboxes.begin(1.0);
  robot.offer({1});
  robot.offer(Bytes(200));
  robot.mailboxes.wrong_length(4, 1.0, 1.0);
  EXPECT_EQ(told(robot), "");
  EXPECT_EQ(plural(robot), (Counts{1, 1, 0, 0, 0, 0}));
  EXPECT_EQ(Box::asked, 0);
}

TEST_F(MailboxTest, AnInstanceMayWithdrawWhileItIsDestroyed) {
  Box::in_destroy = [](Box& box) { box.mailbox.withdraw(1); };
  {
    Robot robot;
    robot.add();
    robot.offer({1});
    robot.instances.clear();  // the mailboxes are the last to hold them
  }
  Box::in_destroy = nullptr;
}

}  // namespace
}  // namespace regista::mind
