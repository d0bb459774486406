// SPDX-License-Identifier: MIT
// Whole minds that talk to each other: what leaves one arrives in the others, and nothing else does.
#include "mind/mind.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <string>
#include <tuple>

#include "config/rules.hpp"
#include "mind/world/packet.hpp"
#include "team.hpp"

namespace regista::mind {
namespace {

// A team whose packets arrive at the next decision; nobody moves.
class Squad {
 public:
  explicit Squad(const TeamPlan& plan, std::vector<int> numbers, const MindOptions& telling = {}) {
    for (const int number : numbers) minds_.emplace_back(plan, number, 7, plugin::CallTracing{}, telling);
    outcomes_.resize(minds_.size());
  }
  // Percepts of robot `index` are changed by `given`.
  template <class Change>
  void decide(double time, Change&& change) {
    std::vector<std::vector<std::uint8_t>> next;
    for (std::size_t i = 0; i < minds_.size(); ++i) {
      Percepts given = percepts(time);
      change(i, given);
      std::vector<HeardPacket> heard;
      for (const auto& [from, bytes] : air_) {
        if (from != i) heard.push_back({time, bytes});
      }
      minds_[i].think(given, heard, outcomes_[i]);
    }
    air_.clear();
    for (std::size_t i = 0; i < minds_.size(); ++i) {
      if (outcomes_[i].send) air_.emplace_back(i, outcomes_[i].packet);
    }
  }
  Mind& mind(std::size_t index) { return minds_[index]; }
  const Outcome& outcome(std::size_t index) const { return outcomes_[index]; }

 private:
  std::vector<Mind> minds_;
  std::vector<Outcome> outcomes_;
  std::vector<std::pair<std::size_t, std::vector<std::uint8_t>>> air_;
};

constexpr PacketLimits limits{.team_size = 7, .role_count = 10, .context_count = 1, .size = 128};

Report sent_by(const Outcome& outcome) {
  std::vector<Segment> segments;
  const auto report = decode(outcome.packet, limits, segments);
  EXPECT_TRUE(report);
  return report.value_or(Report{});
}

// By a clock that leaves so much of a match, with so many packets left; a game of less than the whole begins in play.
bool sends_evenly(double seconds, double match_time_left, int packets_left) {
  config::Team page = team();
  page.contexts.front().sender = use("even");
  config::Rules rules;
  rules.durations.ready = rules.durations.set = 0.0;
  rules.messages.short_games = config::ShortGames::share;
  config::fit_packets(rules, seconds, true);
  const auto plan = plan_of(page, rules);
  Mind mind(*plan, 3, 1);
  Percepts given = percepts(1.0);
  given.game.match_time_left = match_time_left;
  given.game.packets_left = packets_left;
  Outcome outcome;
  mind.think(given, {}, outcome);
  return outcome.send;
}

// Of 1200 packets in 1200 s one is due in each second, in a whole match and in a game of 30 s.
TEST(MindTest, ASenderIsToldWhatIsLeftOfTheShareOfTheGame) {
  EXPECT_TRUE(sends_evenly(1200.0, 1186.0, 1186));
  EXPECT_FALSE(sends_evenly(1200.0, 1186.0, 1185));
  EXPECT_TRUE(sends_evenly(30.0, 1186.0, 16));  // 14 s played, 16 of 30 s left
  EXPECT_FALSE(sends_evenly(30.0, 1186.0, 15));
  EXPECT_TRUE(sends_evenly(30.0, 1200.0, 30));
  EXPECT_FALSE(sends_evenly(30.0, 1200.0, 31));  // more than the environment's budget
  EXPECT_FALSE(sends_evenly(30.0, 1170.0, 30));  // over
  EXPECT_TRUE(sends_evenly(1200.0, 1170.0, 1170));
}

TEST(MindTest, APacketTellsWhatItsSenderKnows) {
  const auto plan = plan_of(team());
  Mind mind(*plan, 3, 1);
  Outcome out;
  Percepts given = percepts(0.0);
  given.placed = placed(-1.0, 0.5, 0.0);
  given.balls.push_back({{1.0, 0.0}, 0.05, 0.05});
  for (int i = 0; i < 7; ++i) given.robots.push_back({{1.0 + i, 2.0}, 0.1, 0.1, i == 0});
  mind.think(given, {}, out);
  ASSERT_TRUE(out.send);
  const Report told = sent_by(out);
  EXPECT_EQ(told.sender, 3);
  EXPECT_EQ(told.time_sent, 0.0);
  EXPECT_NEAR(told.pose.x, -1.0, 1e-3);
  EXPECT_NEAR(told.pose.y, 0.5, 1e-3);
  EXPECT_TRUE(told.playing);
  ASSERT_TRUE(told.ball);
  EXPECT_NEAR(told.ball->position.x(), 0.0, 1e-3);
  EXPECT_NEAR(told.ball->position.y(), 0.5, 1e-3);
  EXPECT_EQ(told.opponent_count, 5u) << "six seen, five fit";
  EXPECT_EQ(told.role, out.role);
  EXPECT_EQ(told.role, 1) << "the only active robot takes the required role";
  EXPECT_EQ(told.context, 0);
  EXPECT_LE(out.packet.size(), 128u);
  // What the team knows of this robot is what the packet says.
  mind.think(percepts(0.1), {}, out);
  EXPECT_NE(mind.world().common().robot(3).flags & REGISTA_ROBOT_KNOWN, 0u);
  EXPECT_EQ(mind.world().common().robot(3).pose[0], told.pose.x);
}

TEST(MindTest, TeammatesHearEachOtherAndAgree) {
  const auto plan = plan_of(team());
  Squad squad(*plan, {1, 2, 3});
  const auto put = [](std::size_t i, Percepts& given) {
    if (given.time == 0.0) given.placed = placed(-2.0 + static_cast<double>(i), 0.0);
  };
  for (int k = 0; k < 20; ++k) squad.decide(0.1 * k, put);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(squad.mind(i).world().mine().active, (std::vector<std::int32_t>{1, 2, 3}));
    EXPECT_EQ(squad.mind(i).world().common().active, (std::vector<std::int32_t>{1, 2, 3}));
    EXPECT_EQ(squad.outcome(i).assignment, squad.outcome(0).assignment);
    EXPECT_GE(squad.outcome(i).role, 0);
    for (std::size_t j = 0; j < i; ++j) EXPECT_NE(squad.outcome(i).role, squad.outcome(j).role);
  }
  EXPECT_EQ(squad.outcome(0).role, 0) << "robot 1 keeps the goal";
}

TEST(MindTest, PluginsMayAskWhatWasSaidAsItWasSaid) {
  config::Team page = team();
  page.contexts[0].terms.push_back({"asker", use("asker"), 0.1, {}});
  page.role_lists[0].roles[0].group = 4;
  page.role_lists[0].roles[1].offset = false;
  const auto plan = plan_of(page);
  Squad squad(*plan, {2, 3}, {.drawings = true});
  std::vector<std::string> lines;
  for (int i = 0; i < 4; ++i) {
    squad.decide(1.0 + 0.5 * i, [&](std::size_t index, Percepts& given) {
      if (i == 0) given.placed = placed(index == 0 ? 0.0 : -2.5, 0.0);
      if (i == 1 && index == 1) given.odometry.x = 0.7;  // robot 3 walks on and has not said so yet
      if (i == 2) given.balls.push_back({{1.0, 0.0}, 0.1, 0.1});
    });
    for (const LogLine& line : squad.mind(0).log()) lines.emplace_back(line.text);
  }
  const std::string first = "3 at -2.500000 sent 1.000000";
  EXPECT_EQ(lines,
            (std::vector<std::string>{"roles: 4 1 walks, -1 0", "none, blind, left 1200", first + ", blind, left 1200",
                                      first + ", sees, left 1200", "3 at -1.800000 sent 2.000000, blind, left 1200"}));
}

// Gossip tells its number once a packet and scores by the sum of what it heard.
TEST(MindTest, OffersTravelBetweenMinds) {
  const auto plan = plan_of(team());
  Squad squad(*plan, {2, 3, 5});
  const auto nothing = [](std::size_t, Percepts&) {};
  // Packets leave at 0, 1 and 2 s and arrive one decision later; the offer of each is pending since the decision
  // before.
  for (int k = 0; k <= 21; ++k) squad.decide(0.1 * k, nothing);
  EXPECT_EQ(squad.mind(0).decision().utility.terms()[1][0], 3.0 * (3 + 5));
  EXPECT_EQ(squad.mind(1).decision().utility.terms()[1][0], 3.0 * (2 + 5));
  EXPECT_EQ(squad.mind(2).decision().utility.terms()[1][0], 3.0 * (2 + 3));
}

TEST(MindTest, AJournalTellsOfSegmentsAndChangesNothing) {
  const auto plan = plan_of(team());
  Squad squad(*plan, {2, 3, 5}), recorded(*plan, {2, 3, 5}, MindOptions{.segments = true});
  const auto nothing = [](std::size_t, Percepts&) {};
  SegmentCounts counted, told;
  for (int k = 0; k <= 45; ++k) {
    squad.decide(0.1 * k, nothing);
    recorded.decide(0.1 * k, nothing);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(recorded.outcome(i).packet, squad.outcome(i).packet);
      EXPECT_EQ(recorded.outcome(i).assignment, squad.outcome(i).assignment);
      EXPECT_TRUE(squad.mind(i).segments().empty());
      const SegmentCounts now = recorded.outcome(i).segments, without = squad.outcome(i).segments;
      EXPECT_EQ(std::tuple(now.offered, now.refused, now.sent, now.dropped, now.heard),
                std::tuple(without.offered, without.refused, without.sent, without.dropped, without.heard));
      counted.offered += now.offered, counted.sent += now.sent;
      counted.dropped += now.dropped, counted.heard += now.heard;
      for (const SegmentEvent& event : recorded.mind(i).segments()) {
        EXPECT_STREQ(event.plugin, "gossip");
        EXPECT_EQ(event.time, 0.1 * k);
        if (event.kind == SegmentEvent::Kind::offered) ++told.offered;
        if (event.kind == SegmentEvent::Kind::sent) ++told.sent;
        if (event.kind == SegmentEvent::Kind::dropped) ++told.dropped;
        if (event.kind == SegmentEvent::Kind::heard) ++told.heard;
      }
    }
  }
  EXPECT_EQ(told.offered, counted.offered);
  EXPECT_EQ(told.sent, counted.sent);
  EXPECT_EQ(told.dropped, counted.dropped);
  EXPECT_EQ(told.heard, counted.heard);
  EXPECT_GT(told.dropped, 5u) << "an offer lives for 0.35 s, a packet leaves once a second";
  EXPECT_GT(told.sent, 5u);
  EXPECT_EQ(told.heard, 2 * told.sent) << "by both of the others";
}

TEST(MindTest, AJournalTellsOfSegmentsThatDoNotEndWithTheirPacket) {
  const auto plan = plan_of(team());
  Mind mind(*plan, 3, 1, {}, MindOptions{.segments = true});
  std::vector<std::uint8_t> good, cut, own;
  encode(report(4, 0.9), good);
  append_segment({200, std::vector<std::uint8_t>{1, 2}}, good);
  cut = good;
  cut.pop_back();
  encode(report(3, 0.9), own);
  own.push_back(200);
  const std::vector<HeardPacket> heard{{0.95, good}, {0.96, cut}, {0.97, own}};
  Outcome out;
  mind.think(percepts(1.0), heard, out);
  std::vector<std::tuple<std::string, int, double, double>> seen;
  for (const SegmentEvent& event : mind.segments()) {
    if (event.kind == SegmentEvent::Kind::undelivered) {
      seen.emplace_back(word(event.why), event.sender, event.time_sent, event.time_heard);
    }
  }
  const std::vector<std::tuple<std::string, int, double, double>> expected{{"unknown_place", 4, 0.9, 0.95},
                                                                           {"wrong_length", 4, 0.9, 0.96}};
  EXPECT_EQ(seen, expected) << "what claims to be one's own is noise";
}

// Whatever the predictors' luck: what is common is the same in all robots, what is their own is not.
TEST(MindTest, LuckIsSharedInWhatIsCommonAlone) {
  config::Team page = team();
  page.self = page.ball = page.opponents = page.teammates = use("lucky");
  const auto plan = plan_of(page);
  Mind one(*plan, 2, 1), two(*plan, 5, 1), other_match(*plan, 5, 2);
  Report told = report(3, 0.0, 1.0, 2.0);
  told.ball = ReportedBall{{0.5, 0.5}, {0, 0}, 0.1, 0.0};
  told.opponent_count = 1;
  std::vector<std::uint8_t> bytes;
  encode(told, bytes);
  const HeardPacket packet{0.1, bytes};
  Outcome out;
  for (Mind* each : {&one, &two, &other_match}) {
    Percepts given = percepts(0.1);
    given.placed = placed(0.0, 0.0);
    each->think(given, {&packet, 1}, out);
  }
  const DistributedWorldModel &a = one.world().common(), &b = two.world().common(), &c = other_match.world().common();
  EXPECT_EQ(a.robot(3).pose[0], b.robot(3).pose[0]);
  EXPECT_EQ(a.ball_state.position[0], b.ball_state.position[0]);
  ASSERT_EQ(a.opponents.size(), 1u);
  EXPECT_EQ(a.opponents[0].position[0], b.opponents[0].position[0]);
  EXPECT_NE(a.robot(3).pose[0], c.robot(3).pose[0]);
  EXPECT_NE(one.world().local().pose().x, two.world().local().pose().x);
}

TEST(MindTest, NoiseChangesNothing) {
  const auto plan = plan_of(team());
  Mind mind(*plan, 3, 1), untouched(*plan, 3, 1);
  const auto encoded = [](const Report& each) {
    std::vector<std::uint8_t> bytes;
    encode(each, bytes);
    return bytes;
  };
  Report future = report(4, 50.0), too_high = report(4, 1.0), own = report(3, 0.95, 2.0);
  too_high.role = 10;
  std::vector<std::vector<std::uint8_t>> noise{
      {}, {1, 2, 3}, std::vector<std::uint8_t>(128, 0xff), encoded(future), encoded(too_high), encoded(own)};
  noise.push_back(encoded(report(4, 1.0)));
  noise.back().pop_back();
  std::vector<HeardPacket> heard;
  for (const auto& bytes : noise) heard.push_back({1.0, bytes});
  Outcome out, expected;
  for (int k = 0; k < 30; ++k) {
    const Percepts given = percepts(1.0 + 0.1 * k);
    mind.think(given, heard, out);
    untouched.think(given, {}, expected);
    EXPECT_EQ(out.packet, expected.packet);
    EXPECT_EQ(out.assignment, expected.assignment);
    EXPECT_EQ(mind.world().mine().active, std::vector<std::int32_t>{3});
    EXPECT_EQ(mind.world().common().active, untouched.world().common().active) << "what the team knows of oneself";
  }
  // And what is none still arrives.
  const auto good = encoded(report(4, 3.9));
  const HeardPacket packet{4.0, good};
  mind.think(percepts(4.0), {&packet, 1}, out);
  EXPECT_EQ(mind.world().mine().active, (std::vector<std::int32_t>{3, 4}));
}

TEST(MindTest, SpeaksOnlyInPlayAndWhenNotPenalised) {
  config::Team page = team();
  page.contexts[0].sender = use("steady", {{"period", "0"}});
  const auto plan = plan_of(page);
  Mind mind(*plan, 2, 1);
  Outcome out;
  double time = 0.0;
  const auto sends = [&](Phase phase, bool penalised) {
    Percepts given = percepts(time += 0.1, phase);
    given.penalised = penalised;
    mind.think(given, {}, out);
    EXPECT_EQ(out.packet.empty(), !out.send);
    return out.send;
  };
  EXPECT_FALSE(sends(Phase::initial, false));
  EXPECT_TRUE(sends(Phase::ready, false));
  EXPECT_TRUE(sends(Phase::set, false));
  EXPECT_TRUE(sends(Phase::playing, false));
  EXPECT_FALSE(sends(Phase::playing, true));
  EXPECT_EQ(out.role, -1);
  EXPECT_EQ(out.command.walk.forward, 0.0);
  EXPECT_FALSE(sends(Phase::finished, false));
}

TEST(MindTest, WithoutAContextThereIsNoRoleAndNoPacket) {
  config::Team page = team();
  page.contexts[0].use = use("window", {{"to", "1"}});
  const auto plan = plan_of(page);
  Mind mind(*plan, 2, 1);
  Outcome out;
  mind.think(percepts(0.0), {}, out);
  EXPECT_GE(out.role, 0);
  EXPECT_TRUE(out.send);
  mind.think(percepts(1.5), {}, out);
  EXPECT_EQ(out.role, -1);
  EXPECT_FALSE(out.send);
  EXPECT_EQ(out.assignment, std::vector<int>(7, -1));
  EXPECT_EQ(out.context, -1);
  EXPECT_TRUE(out.kept.empty());
  EXPECT_FALSE(out.target);
}

TEST(MindTest, AnOutcomeTellsHowTheDecisionCameAbout) {
  config::Team page = team();
  page.contexts.insert(page.contexts.begin(), context("never", {{"from", "1000"}}));
  const auto plan = plan_of(page);
  Mind mind(*plan, 3, 1);
  Outcome out;
  Percepts given = percepts(0.0);
  given.placed = placed(-1.0, 0.5, 0.0);
  given.balls.push_back({{1.0, 0.0}, 0.05, 0.05});
  mind.think(given, {}, out);
  EXPECT_EQ(out.context, 1);
  EXPECT_EQ(out.kept, std::vector<int>{1}) << "alone it keeps what is required";
  EXPECT_EQ(out.role, 1);
  ASSERT_TRUE(out.target);
  ASSERT_NE(mind.decision().own_task, nullptr);
  EXPECT_EQ(out.target->x, mind.decision().own_task->after[0]);
  EXPECT_EQ(out.target->y, mind.decision().own_task->after[1]);
  out.clear();
  EXPECT_EQ(out.context, -1);
  EXPECT_TRUE(out.kept.empty());
  EXPECT_FALSE(out.target);
}

TEST(MindTest, TheBehaviourOfTheRoleActs) {
  config::Team page = team();
  page.behaviours.push_back({"tells", use("walks", {{"tells", "true"}, {"tells_x", "2.5"}})});
  page.role_lists[0].roles[1].behaviour = "tells";
  const auto plan = plan_of(page);
  Mind mind(*plan, 3, 1);
  Outcome out;
  Percepts given = percepts(0.0);
  given.placed = placed(-1.0, 0.0, 0.0);
  given.balls.push_back({{1.5, 0.0}, 0.05, 0.05});
  mind.think(given, {}, out);
  ASSERT_EQ(out.role, 1) << "alone it keeps what is required";
  EXPECT_GT(out.command.walk.forward, 0.2) << "the ball lies ahead";
  EXPECT_EQ(out.command.head_yaw, 0.5);
  EXPECT_NEAR(sent_by(out).target.x(), 2.5, 0.01) << "the packet tells what the behaviour says";
  EXPECT_NE(out.target->x, 2.5) << "the task's place is another thing";
}

TEST(MindTest, EveryBehaviourOfThePageIsLookedForOnce) {
  config::Team page = team();
  page.behaviours.push_back({"lazy", use("seeks")});
  page.role_lists[0].roles[2].behaviour = "seeks";
  const auto plan = plan_of(page);
  std::vector<std::string> names;
  for (const BehaviourPlan& each : plan->behaviours()) names.push_back(each.name);
  EXPECT_EQ(names, (std::vector<std::string>{"walks", "seeks", "lazy"}));
  EXPECT_EQ(plan->purposes(2), REGISTA_BEHAVIOUR_SEARCHES);
  EXPECT_EQ(plan->purposes(0), 0u);
  EXPECT_EQ(plan->behaviour_without_role(), 0u);
}

TEST(MindTest, TheSameInputsGiveTheSameBytes) {
  const auto plan = plan_of(team());
  Squad one(*plan, {1, 2, 3}), two(*plan, {1, 2, 3});
  const auto change = [](std::size_t i, Percepts& given) {
    if (given.time == 0.0) given.placed = placed(-2.0 + static_cast<double>(i), 0.3);
    given.odometry = {0.02, 0.001 * static_cast<double>(i), 0.01};
    given.balls.push_back({{1.0 + 0.01 * given.time, 0.2}, 0.05, 0.05});
  };
  for (int k = 0; k < 100; ++k) {
    one.decide(0.1 * k, change);
    two.decide(0.1 * k, change);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_EQ(one.outcome(i).packet, two.outcome(i).packet);
      EXPECT_EQ(one.outcome(i).command.walk.forward, two.outcome(i).command.walk.forward);
      EXPECT_EQ(one.outcome(i).command.head_yaw, two.outcome(i).command.head_yaw);
      EXPECT_EQ(one.outcome(i).assignment, two.outcome(i).assignment);
    }
  }
}

}  // namespace
}  // namespace regista::mind
