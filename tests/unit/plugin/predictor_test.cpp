// SPDX-License-Identifier: MIT
#include "plugin/predictor.hpp"

#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <limits>
#include <numbers>
#include <vector>

#include "puppet.hpp"

namespace regista::plugin::test {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

regista_track track(std::int32_t label, double weight = 1.0) {
  regista_track out{};
  out.label = label;
  out.weight = weight;
  for (const std::size_t i : {0u, 2u}) out.covariance[i] = 0.01;
  for (const std::size_t i : {4u, 6u}) out.motion[i] = 0.01;
  return out;
}

// Of a robot of the own team.
regista_track robot(std::int32_t number) {
  regista_track out = track(number);
  out.pose = {0.5, 0.1, 0.01, 0.02, {0.0, 0.0}};
  return out;
}

class PredictorTest : public PuppetTest {
 protected:
  // What ends tracks() when the plugin hands back these.
  std::string run(std::uint32_t subject, std::vector<regista_track> tracks) {
    written = std::move(tracks);
    Puppet::predictor.tracks = [](void*, regista_room* out, regista_error*) {
      EXPECT_EQ(out->count, 0u);
      EXPECT_EQ(out->stride, sizeof(regista_track));
      out->count = static_cast<std::uint32_t>(written.size());
      std::copy_n(written.begin(), std::min<std::size_t>(out->capacity, written.size()),
                  static_cast<regista_track*>(out->data));
      return Puppet::ok;
    };
    return message_of([&] {
      Predictor predictor(Puppet::instance(subject));
      const std::span<const regista_track> out = predictor.tracks();
      ASSERT_EQ(out.size(), written.size());
      for (std::size_t i = 0; i < out.size(); ++i) EXPECT_EQ(out[i].label, written[i].label);
    });
  }

  // The same for one track of the ball, spoiled by `spoil`.
  std::string run_spoiled(const std::function<void(regista_track&)>& spoil) {
    regista_track spoiled = track(4);
    spoil(spoiled);
    return run(REGISTA_SUBJECT_BALL, {spoiled});
  }

  // And for one of a teammate.
  std::string run_spoiled_robot(const std::function<void(regista_track&)>& spoil) {
    regista_track spoiled = robot(4);
    spoil(spoiled);
    return run(REGISTA_SUBJECT_TEAMMATES, {spoiled});
  }

  static inline std::vector<regista_track> written;
};

TEST_F(PredictorTest, RefusesValuesThatCannotBe) {
  const auto said = [](const std::string& what) { return Puppet::failure("tracks: " + what); };
  constexpr double pi = std::numbers::pi;
  EXPECT_EQ(run_spoiled([](regista_track&) {}), "");
  EXPECT_EQ(run_spoiled([](regista_track& t) { t.y = nan; }), said("y of label 4 is nan"));
  EXPECT_EQ(run_spoiled([](regista_track& t) { t.vx = std::numeric_limits<double>::infinity(); }),
            said("vx of label 4 is inf"));
  EXPECT_EQ(run_spoiled_robot([](regista_track& t) { t.pose.turn_rate = nan; }), said("turn rate of label 4 is nan"));
  EXPECT_EQ(run_spoiled_robot([](regista_track& t) { t.pose.heading = pi; }), "");
  EXPECT_EQ(run_spoiled_robot([](regista_track& t) { t.pose.heading = -pi; }), "");
  EXPECT_EQ(run_spoiled_robot([](regista_track& t) { t.pose.heading = 4.0; }), said("heading of label 4 is 4"));
  EXPECT_EQ(run_spoiled_robot([](regista_track& t) { t.pose.heading_variance = -0.5; }),
            said("heading variance of label 4 is -0.5"));
  EXPECT_EQ(run_spoiled_robot([](regista_track& t) { t.pose.velocity_variance = -0.5; }),
            said("velocity variance of label 4 is -0.5"));
  EXPECT_EQ(run_spoiled_robot([](regista_track& t) { t.y = nan; }), said("y of label 4 is nan"));
  EXPECT_EQ(run_spoiled([](regista_track& t) { t.weight = 0.0; }), said("weight of label 4 is 0"));
  EXPECT_EQ(run_spoiled([](regista_track& t) { t.weight = 1.5; }), said("weight of label 4 is 1.5"));
  EXPECT_EQ(run_spoiled([](regista_track& t) { t.age = -1.0; }), said("age of label 4 is -1"));
  EXPECT_EQ(run_spoiled_robot([](regista_track& t) { t.pose.target[1] = nan; }), "");
  EXPECT_EQ(run_spoiled_robot([](regista_track& t) {
              t.flags = REGISTA_TRACK_HAS_TARGET;
              t.pose.target[1] = nan;
            }),
            said("y of the target of label 4 is nan"));
}

TEST_F(PredictorTest, RefusesMatricesThatAreNoCovariances) {
  const auto said = [](const std::string& what) { return Puppet::failure("tracks: covariance of label 4 " + what); };
  EXPECT_EQ(run_spoiled([](regista_track& t) { t.motion[1] = nan; }), said("is not finite"));
  EXPECT_EQ(run_spoiled([](regista_track& t) { t.covariance[1] = 0.011; }), said("is not positive semi-definite"));
  EXPECT_EQ(run_spoiled([](regista_track& t) { t.motion[2] = 0.011; }), said("is not positive semi-definite"));
  EXPECT_EQ(run_spoiled_robot([](regista_track& t) { t.covariance[2] = nan; }), said("is not finite"));
  EXPECT_EQ(run_spoiled_robot([](regista_track& t) { t.covariance[1] = 0.011; }),
            said("is not positive semi-definite"));
  EXPECT_EQ(run_spoiled_robot([](regista_track& t) { t.motion[6] = nan; }), "") << "robots have no such entry";
}

TEST_F(PredictorTest, WantsSelfToBeOneTrackWithTheOwnNumber) {
  EXPECT_EQ(run(REGISTA_SUBJECT_SELF, {robot(3)}), "");
  EXPECT_EQ(run(REGISTA_SUBJECT_SELF, {robot(2)}),
            Puppet::failure("tracks: self is one track with label 3; there are 1, the first with label 2"));
  EXPECT_EQ(run(REGISTA_SUBJECT_SELF, {}), Puppet::failure("tracks: self is one track with label 3; there are 0"));
  EXPECT_EQ(run(REGISTA_SUBJECT_SELF, {robot(3), robot(4)}),
            Puppet::failure("tracks: self is one track with label 3; there are 2, the first with label 3"));
}

TEST_F(PredictorTest, WantsTheBestHypothesisOfTheBallFirst) {
  EXPECT_EQ(run(REGISTA_SUBJECT_BALL, {}), "");
  EXPECT_EQ(run(REGISTA_SUBJECT_BALL, {track(0, 0.6), track(1, 0.1), track(2, 0.3)}), "");
  EXPECT_EQ(run(REGISTA_SUBJECT_BALL, {track(0, 0.3), track(1, 0.1), track(2, 0.6)}),
            Puppet::failure("tracks: hypothesis 2 has weight 0.6, the first only 0.3"));
}

TEST_F(PredictorTest, WantsTeammatesByAscendingNumber) {
  EXPECT_EQ(run(REGISTA_SUBJECT_TEAMMATES, {robot(1), robot(2), robot(5)}), "");
  EXPECT_EQ(run(REGISTA_SUBJECT_TEAMMATES, {robot(2), robot(1)}), Puppet::failure("tracks: label 1 comes after 2"));
  EXPECT_EQ(run(REGISTA_SUBJECT_TEAMMATES, {robot(2), robot(2)}), Puppet::failure("tracks: label 2 comes after 2"));
  EXPECT_EQ(run(REGISTA_SUBJECT_TEAMMATES, {robot(6)}), Puppet::failure("tracks: robot 6 of 5 does not exist"));
  EXPECT_EQ(run(REGISTA_SUBJECT_TEAMMATES, {robot(0)}), Puppet::failure("tracks: robot 0 of 5 does not exist"));
}

TEST_F(PredictorTest, WantsALabelPerOpponent) {
  EXPECT_EQ(run(REGISTA_SUBJECT_OPPONENTS, {track(9), track(2), track(70)}), "");
  EXPECT_EQ(run(REGISTA_SUBJECT_OPPONENTS, {track(9), track(2), track(9)}),
            Puppet::failure("tracks: label 9 stands in tracks 0 and 2"));
}

TEST_F(PredictorTest, RefusesMoreTracksThanThereIsRoomFor) {
  EXPECT_EQ(run(REGISTA_SUBJECT_BALL, std::vector<regista_track>(65, track(0))),
            Puppet::failure("tracks: wrote 65 tracks into room for 64"));
}

TEST_F(PredictorTest, WantsToModelItsSubject) {
  Puppet::predictor.subjects = REGISTA_SUBJECT_BALL | REGISTA_SUBJECT_OPPONENTS;
  EXPECT_EQ(message_of([] { Predictor(Puppet::instance(REGISTA_SUBJECT_TEAMMATES)); }),
            Puppet::failure("create: models ball, opponents, not teammates"));
}

TEST_F(PredictorTest, PassesWhatItIsGiven) {
  static double sum;
  sum = 0.0;
  Puppet::predictor.predict = [](void*, double dt, const regista_motion* motion, const regista_frame* last,
                                 regista_error*) {
    sum += dt + (motion != nullptr ? motion->x : 0.0) + (last != nullptr ? 1000.0 : 0.0);
    return Puppet::ok;
  };
  Puppet::predictor.correct = [](void*, regista_span measurements, const regista_visible_area* area, regista_error*) {
    EXPECT_EQ(measurements.stride, sizeof(regista_measurement));
    sum += measurements.count * area->range_ball;
    return Puppet::ok;
  };
  Puppet::predictor.absorb = [](void*, regista_span tracks, double age, regista_error*) {
    EXPECT_EQ(tracks.stride, sizeof(regista_track));
    sum += tracks.count * age;
    return Puppet::ok;
  };
  Predictor predictor(Puppet::instance(REGISTA_SUBJECT_BALL));
  const regista_motion motion{0.25, 0.0, 0.0};
  const Scene scene;
  predictor.predict(0.5, &motion, nullptr);
  EXPECT_EQ(sum, 0.75);
  predictor.predict(0.5, nullptr, &scene.frame);
  EXPECT_EQ(sum, 1001.25);
  predictor.correct(std::array<regista_measurement, 2>{}, {0, 0, 0, 0, 4.0, 0});
  EXPECT_EQ(sum, 1009.25);
  predictor.absorb(std::array<regista_track, 3>{}, 0.25);
  EXPECT_EQ(sum, 1010.0);
}

TEST_F(PredictorTest, ReportsSharedObjectsByTheirFile) {
  Predictor returns_nan(instance_of(open("returns_nan"), REGISTA_SUBJECT_BALL));
  EXPECT_EQ(message_of([&] { returns_nan.tracks(); }), failure("returns_nan", "tracks: vx of label 0 is nan"));
  Predictor throws(instance_of(open("throws"), REGISTA_SUBJECT_BALL));
  EXPECT_EQ(message_of([&] { throws.predict(0.1, nullptr, nullptr); }), failure("throws", "predict: fell in predict"));
  EXPECT_EQ(message_of([&] { throws.correct({}, {}); }), failure("throws", "correct: fell in correct"));
  EXPECT_EQ(message_of([&] { throws.absorb({}, 0.0); }), failure("throws", "absorb: fell in absorb"));
  EXPECT_EQ(message_of([&] { throws.tracks(); }), failure("throws", "tracks: fell in tracks"));
}

}  // namespace
}  // namespace regista::plugin::test
