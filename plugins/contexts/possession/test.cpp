// SPDX-License-Identifier: MIT
// The four answers by hand, the memory against a clock, and noise that must not make it flicker.
#include <gtest/gtest.h>

#include <map>
#include <random>

#include <regista/testkit/contract.hpp>
#include <regista/testkit/frame_builder.hpp>
#include <regista/testkit/instance.hpp>

#include "algorithm.hpp"

namespace {

using possession::Memory;
using possession::Nearest;
using possession::nobody;
using possession::Rule;
using possession::State;

TEST(Possession, TheFirstSightCountsAtOnce) {
  for (const auto& [us, them, expected] : {std::tuple(0.5, 0.51, State::us),
                                           {0.51, 0.5, State::them},
                                           {0.51, 0.51, State::none},
                                           {0.5, 0.5, State::fight},
                                           {nobody, nobody, State::none},
                                           {0.0, nobody, State::us},
                                           {nobody, 0.0, State::them},
                                           {0.0, 0.0, State::fight}}) {
    EXPECT_EQ(Memory().update({}, 7.0, Nearest{us, them}), expected) << us << ' ' << them;
  }
}

TEST(Possession, ASideStaysUpToTheMargin) {
  const Rule rule{0.5, 0.2, 0.0};
  Memory memory;
  EXPECT_EQ(memory.update(rule, 0.0, Nearest{0.6, nobody}), State::none);
  EXPECT_EQ(memory.update(rule, 0.1, Nearest{0.5, nobody}), State::us);
  EXPECT_EQ(memory.update(rule, 0.2, Nearest{0.69, 0.6}), State::us);
  EXPECT_EQ(memory.update(rule, 0.3, Nearest{0.69, 0.4}), State::fight);
  EXPECT_EQ(memory.update(rule, 0.4, Nearest{0.71, 0.69}), State::them);
  EXPECT_EQ(memory.update(rule, 0.5, Nearest{0.69, 0.71}), State::none);
}

TEST(Possession, AChangeMustLast) {
  const Rule rule{0.5, 0.2, 0.3};
  Memory memory;
  ASSERT_EQ(memory.update(rule, 0.0, Nearest{0.2, nobody}), State::us);
  EXPECT_EQ(memory.update(rule, 0.1, Nearest{3.0, nobody}), State::us);
  EXPECT_EQ(memory.update(rule, 0.2, Nearest{3.0, nobody}), State::us);
  EXPECT_EQ(memory.update(rule, 0.3, Nearest{0.2, nobody}), State::us);  // back in time
  for (int tick = 4; tick < 7; ++tick) EXPECT_EQ(memory.update(rule, 0.1 * tick, Nearest{3.0, nobody}), State::us);
  EXPECT_EQ(memory.update(rule, 0.7, Nearest{3.0, nobody}), State::none);
}

TEST(Possession, AnUnknownBallHasNoAnswerAndNoMemory) {
  const Rule rule{0.5, 0.2, 5.0};
  Memory memory;
  ASSERT_EQ(memory.update(rule, 0.0, Nearest{0.2, nobody}), State::us);
  EXPECT_EQ(memory.update(rule, 0.1, std::nullopt), std::nullopt);
  EXPECT_EQ(memory.update(rule, 0.2, Nearest{0.6, 0.4}), State::them);
}

// What they have, we lack: exchanging the sides exchanges the answers, at every step of a random walk.
TEST(Possession, IsMirroredByTheOpponent) {
  const std::map<State, State> other{
      {State::us, State::them}, {State::them, State::us}, {State::none, State::none}, {State::fight, State::fight}};
  std::mt19937 random(6);
  std::uniform_real_distribution<double> distance(0.0, 1.2);
  Memory ours, theirs;
  for (int tick = 0; tick < 5000; ++tick) {
    const double us = distance(random), them = distance(random);
    const auto seen = ours.update({}, 0.1 * tick, Nearest{us, them});
    ASSERT_EQ(theirs.update({}, 0.1 * tick, Nearest{them, us}), other.at(*seen));
  }
}

TEST(Possession, NoiseDoesNotMakeItFlicker) {
  const auto changes = [](const Rule& rule) {
    std::mt19937 random(7);
    std::normal_distribution<double> noise(0.5, 0.06);  // a robot on the edge
    Memory memory;
    std::optional<State> before = State::none;
    int count = 0;
    for (int tick = 0; tick < 6000; ++tick) {
      const auto now = memory.update(rule, 0.1 * tick, Nearest{std::abs(noise(random)), nobody});
      count += now != before ? 1 : 0;
      before = now;
    }
    return count;
  };
  EXPECT_GT(changes({0.5, 0.0, 0.0}), 2500);
  EXPECT_LT(changes({0.5, 0.2, 0.0}), 20);  // 6000 x P(z > 3.33) = 2.6 departures, each with its return
  EXPECT_LE(changes({}), 1);
}

// --- The plugin ------------------------------------------------------------------------------------------------

using namespace regista::testkit;

// Which of the four contexts hold.
std::string answers(const FrameBuilder& frame) {
  const Loaded plugin(REGISTA_PLUGIN_FILE, "possession");
  std::string out;
  for (const char* who : {"us", "them", "none", "fight"}) {
    Instance context(plugin, EnvironmentBuilder{}, Values(plugin).set("who", who));
    if (context.holds(frame.build().before_tasks()) != 1) continue;
    if (!out.empty()) out += " ";
    out += who;
  }
  return out;
}

TEST(PossessionPlugin, ExactlyOneOfTheFourWhenTheBallIsKnown) {
  const FrameBuilder ball = FrameBuilder{}.ball(1, 1);
  EXPECT_EQ(answers(FrameBuilder(ball).robot(3).at(1.3, 1.3)), "us");
  EXPECT_EQ(answers(FrameBuilder(ball).robot(3).at(1.3, 1.5)), "none");
  EXPECT_EQ(answers(FrameBuilder(ball).robot(3).at(3, 1).opponent(1, 0.6)), "them");
  EXPECT_EQ(answers(FrameBuilder(ball).robot(3).at(1, 1).opponent(1, 0.6)), "fight");
  EXPECT_EQ(answers(FrameBuilder(ball)), "none");
  EXPECT_EQ(answers(FrameBuilder(ball).robot(3).at(1, 1).no_ball()), "");
}

TEST(PossessionPlugin, WhoDoesNotCount) {
  const FrameBuilder ball = FrameBuilder{}.ball(1, 1);
  EXPECT_EQ(answers(FrameBuilder(ball).robot(3).at(1, 1).penalised()), "none");
  EXPECT_EQ(answers(FrameBuilder(ball).robot(3).at(1, 1).inactive()), "none");
  EXPECT_EQ(answers(FrameBuilder(ball).robot(3).at(1, 1).fallen(3.0)), "none");
  EXPECT_EQ(answers(FrameBuilder(ball).opponent(1, 1).weight(0.4)), "none");
  EXPECT_EQ(answers(FrameBuilder(ball).opponent(1, 1).weight(0.5)), "them");
}

TEST(PossessionPlugin, TheChosenWorld) {
  const FrameBuilder frame =
      FrameBuilder{}.robot(3).at(1, 1).ball(1, 1).common([](WorldBuilder& world) { world.opponent(1.1, 1); });
  EXPECT_EQ(answers(frame), "us");
  EXPECT_EQ(answers(FrameBuilder(frame).knowledge(REGISTA_COMMON)), "fight");
}

REGISTA_CONTEXT_CONTRACT(REGISTA_PLUGIN_FILE, "possession");

}  // namespace
