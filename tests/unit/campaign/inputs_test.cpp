// SPDX-License-Identifier: MIT
#include "campaign/match_setup.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace regista::campaign {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

const std::vector<Input> a{{"team a", "1"}, {"plugin p (x.so)", "p 2"}}, b{{"team b", "3"}};

std::vector<Input> common(const match::Setup& setup) { return common_inputs(setup, "program", "mathematics"); }

TEST(FixtureKey, HangsOnContentsAndOnTheOrder) {
  const std::string key = fixture_key(a, b, {});
  EXPECT_EQ(key.size(), 32u);
  EXPECT_EQ(fixture_key(a, b, {}), key);
  EXPECT_NE(fixture_key(b, a, {}), key);
  auto other = a;
  other[1].hash = "p 4";
  EXPECT_NE(fixture_key(other, b, {}), key);
  other = a;
  other[1].name = "plugin p (moved.so)";
  EXPECT_EQ(fixture_key(other, b, {}), key);
}

TEST(FixtureKey, InputsDoNotMoveFromOneTeamToTheOther) {
  const std::vector<Input> one{{"", "1"}}, two{{"", "1"}, {"", "2"}}, second{{"", "2"}};
  EXPECT_NE(fixture_key(one, second, {}), fixture_key(two, {}, {}));
}

TEST(CommonInputs, KnowEveryValueOfTheProfiles) {
  const match::Setup setup;
  EXPECT_EQ(common(setup), common(setup));
  const auto changed = [&](auto change) {
    match::Setup other;
    change(other);
    return differences(common(setup), common(other));
  };
  EXPECT_THAT(changed([](match::Setup& s) { s.rules.durations.ready += 1.0; }),
              ElementsAre("rules spl2023 has changed"));
  EXPECT_THAT(changed([](match::Setup& s) { s.robots[0].decision_period = 0.2; }),
              ElementsAre("robot nao has changed"));
  EXPECT_THAT(changed([](match::Setup& s) { s.disturbances[0].radio.loss = 0.1; }),
              ElementsAre("home disturbance none has changed"));
  EXPECT_THAT(changed([](match::Setup& s) { s.disturbances[1].incidents.emplace_back().at = {5.0}; }),
              ElementsAre("away disturbance none has changed"));
  EXPECT_THAT(changed([](match::Setup& s) { s.limit = 10.0; }), ElementsAre("limit has changed"));
  EXPECT_THAT(changed([](match::Setup& s) { s.seed = 2; }), IsEmpty());
}

TEST(CommonInputs, KnowTheOpening) {
  match::Setup from_kick_off, from_scene;
  from_scene.opening.emplace();
  from_scene.opening->name = "scene";
  from_scene.opening->home.resize(7);
  EXPECT_THAT(differences(common(from_kick_off), common(from_scene)), ElementsAre("opening scene is new"));
  const auto changed = [&](auto change) {
    match::Setup other = from_scene;
    change(*other.opening);
    return differences(common(from_scene), common(other));
  };
  EXPECT_THAT(changed([](config::Opening& o) { o.home[6].at[1] = 0.1; }), ElementsAre("opening scene has changed"));
  EXPECT_THAT(changed([](config::Opening& o) { o.home[6].heading = 0.0; }), ElementsAre("opening scene has changed"));
  EXPECT_THAT(changed([](config::Opening& o) { o.ball.velocity[0] = 1.0; }), ElementsAre("opening scene has changed"));
  EXPECT_THAT(changed([](config::Opening& o) { o.length = 20.0; }), ElementsAre("opening scene has changed"));
  EXPECT_THAT(changed([](config::Opening& o) { o.summary = "for people"; }), IsEmpty());
}

TEST(Differences, NameWhatHasChanged) {
  const std::vector<Input> before{{"x", "1"}, {"y", "2"}}, now{{"x", "3"}, {"z", "4"}};
  EXPECT_THAT(differences(before, now), ElementsAre("x has changed", "y is no longer used", "z is new"));
  const std::vector<Input> elsewhere{{"./x", "1"}, {"y", "2"}};
  EXPECT_THAT(differences(before, elsewhere), IsEmpty());
  EXPECT_THAT(differences(before, before), IsEmpty());
}

TEST(ProgramHash, IsThatOfThisTest) {
  EXPECT_EQ(program_hash().size(), 32u);
  EXPECT_EQ(program_hash(), program_hash());
}

TEST(MathematicsFingerprint, IsTheSameEachTime) { EXPECT_EQ(mathematics_fingerprint(), mathematics_fingerprint()); }

}  // namespace
}  // namespace regista::campaign
