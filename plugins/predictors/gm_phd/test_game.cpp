// SPDX-License-Identifier: MIT
// A simulated game whose truth is known: seven opponents wander, one robot walks among them, turns its head and sees
// what is in view, not always, not exactly and sometimes what is not there. Scored by OSPA over all opponents, also
// those out of view, beside the plugin `gaussian_mixture`. The game knows nothing of the models of either.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <random>
#include <regista/testkit/instance.hpp>
#include <regista/testkit/ospa.hpp>
#include <vector>

namespace {

using namespace regista::testkit;

constexpr double step = 0.1, half_length = 4.5, half_width = 3.0;

class Game {
 public:
  Game(std::uint64_t seed, double detection) : random_(seed), detection_(detection) {
    for (int i = 0; i < 7; ++i) robots_.push_back({somewhere(), somewhere(), 0.0, 0.0});
    eye_ = {{-1.0, 0.0}, somewhere(), 0.0, 0.0};
  }

  void advance() {
    time_ += step;
    for (Walker& robot : robots_) walk(robot);
    const PlanePoint before = eye_.at;
    walk(eye_);
    const double dx = eye_.at.x - before.x, dy = eye_.at.y - before.y;
    if (dx != 0.0 || dy != 0.0) {
      const double turn = std::remainder(std::atan2(dy, dx) - body_, two_pi);
      body_ += std::clamp(turn, -0.15, 0.15);
    }
    // The head goes from left to right and back at 2 rad/s.
    const double swing = std::remainder(2.0 * time_, two_pi);
    area_ = {eye_.at.x, eye_.at.y, body_ + std::abs(swing) - two_pi / 4.0, 0.477, 5.0, 4.0};
    look();
  }

  const std::vector<regista_measurement>& seen() const { return seen_; }
  const regista_visible_area& area() const { return area_; }
  std::vector<PlanePoint> truth() const {
    std::vector<PlanePoint> out;
    for (const Walker& robot : robots_) out.push_back(robot.at);
    return out;
  }

 private:
  static constexpr double two_pi = 6.283185307179586;
  struct Walker {
    PlanePoint at, goal;
    double speed, pause;  // m/s, s
  };

  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  PlanePoint somewhere() {
    const double x = uniform(-half_length, half_length);
    return {x, uniform(-half_width, half_width)};
  }

  // To random places at random speeds, with rests between them.
  void walk(Walker& robot) {
    if (robot.pause > 0.0) {
      robot.pause -= step;
      return;
    }
    const double dx = robot.goal.x - robot.at.x, dy = robot.goal.y - robot.at.y, way = std::hypot(dx, dy);
    if (way < robot.speed * step || robot.speed == 0.0) {
      robot.goal = {std::clamp(robot.at.x + uniform(-2.0, 2.0), -half_length, half_length),
                    std::clamp(robot.at.y + uniform(-2.0, 2.0), -half_width, half_width)};
      robot.speed = uniform(0.05, 0.25);
      robot.pause = uniform(0.0, 8.0);
      return;
    }
    robot.at.x += robot.speed * step * dx / way;
    robot.at.y += robot.speed * step * dy / way;
  }

  void look() {
    seen_.clear();
    for (const Walker& robot : robots_) {
      const double dx = robot.at.x - area_.x, dy = robot.at.y - area_.y;
      const double bearing = std::remainder(std::atan2(dy, dx) - area_.heading, two_pi);
      if (std::hypot(dx, dy) > area_.range_robot || std::abs(bearing) > area_.half_angle) continue;
      if (uniform(0.0, 1.0) < detection_) sight(robot.at);
    }
    if (uniform(0.0, 1.0) < 0.005) {
      const double away = area_.range_robot * std::sqrt(uniform(0.01, 1.0));
      const double angle = area_.heading + uniform(-area_.half_angle, area_.half_angle);
      sight({area_.x + away * std::cos(angle), area_.y + away * std::sin(angle)});
    }
  }

  void sight(const PlanePoint& place) {
    const double dx = place.x - area_.x, dy = place.y - area_.y, distance = std::max(0.3, std::hypot(dx, dy));
    const double cosine = dx / distance, sine = dy / distance;
    const double along = 0.05 * distance, across = 0.02 * distance;
    const double a = along * normal_(random_);
    const double b = across * normal_(random_);
    regista_measurement m{};
    m.kind = REGISTA_MEASURED_ROBOT;
    m.position[0] = place.x + a * cosine - b * sine;
    m.position[1] = place.y + a * sine + b * cosine;
    m.covariance[0] = along * along * cosine * cosine + across * across * sine * sine;
    m.covariance[1] = (along * along - across * across) * sine * cosine;
    m.covariance[2] = along * along * sine * sine + across * across * cosine * cosine;
    seen_.push_back(m);
  }

  std::mt19937_64 random_;
  std::normal_distribution<double> normal_;
  double detection_, time_ = 0.0, body_ = 0.0;
  std::vector<Walker> robots_;
  Walker eye_{};
  regista_visible_area area_{};
  std::vector<regista_measurement> seen_;
};

struct Score {
  double ospa = 0.0, told = 0.0;  // m with a cut-off of 1 m; mean number of tracks
};

// The mean over five minutes, without the first half minute.
Score play(Instance& predictor, std::uint64_t seed, double detection) {
  Game game(seed, detection);
  Score score;
  int scored = 0;
  for (int i = 0; i < 3000; ++i) {
    game.advance();
    predictor.predict(step);
    predictor.correct(game.seen(), game.area());
    if (i < 300) continue;
    std::vector<PlanePoint> told;
    for (const regista_track& track : predictor.tracks()) told.push_back({track.x, track.y});
    if (told.size() > 20) told.resize(20);
    score.ospa += ospa(told, game.truth(), 1.0);
    score.told += static_cast<double>(told.size());
    ++scored;
  }
  score.ospa /= scored;
  score.told /= scored;
  return score;
}

class MissedDetections : public testing::TestWithParam<double> {};

// All know the true probability of detection. The mixture plays as it is and with a shorter memory, which must not
// decide. It keeps robots that walk out of sight; the expected number of the PHD falls.
TEST_P(MissedDetections, CostTheGaussianMixtureLess) {
  constexpr int seeds = 8;
  const double detection = GetParam();
  const Loaded phd(REGISTA_PLUGIN_FILE, "gm_phd"), mixture(GAUSSIAN_MIXTURE_FILE, "gaussian_mixture");
  const auto as_shipped = [](const Loaded& plugin) { return Values(plugin); };
  const auto told = [&](const Loaded& plugin) { return Values(plugin).set("detection_probability", detection); };
  std::vector<double> single;
  const auto mean = [&](const Loaded& plugin, const Values& values) {
    Score sum;
    single.clear();
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
      Instance instance(plugin, EnvironmentBuilder{}.subject(REGISTA_SUBJECT_OPPONENTS), values);
      const Score score = play(instance, seed, detection);
      single.push_back(score.ospa);
      sum.ospa += score.ospa / seeds;
      sum.told += score.told / seeds;
    }
    return sum;
  };
  const Score of_phd = mean(phd, told(phd));
  const std::vector<double> each_of_phd = single;
  const Score of_mixture = mean(mixture, told(mixture));
  int better = 0;
  for (std::size_t i = 0; i < seeds; ++i) better += single[i] < each_of_phd[i] ? 1 : 0;
  const Score of_short = mean(mixture, told(mixture).set("forget_after", 30.0));
  const Score phd_plain = mean(phd, as_shipped(phd)), mixture_plain = mean(mixture, as_shipped(mixture));
  std::printf(
      "detection %.2f, mean OSPA (number of tracks): gm_phd %.3f m (%.1f), gaussian_mixture %.3f m (%.1f), with "
      "a shorter memory %.3f m (%.1f); by default parameters %.3f m (%.1f) and %.3f m (%.1f)\n",
      detection, of_phd.ospa, of_phd.told, of_mixture.ospa, of_mixture.told, of_short.ospa, of_short.told,
      phd_plain.ospa, phd_plain.told, mixture_plain.ospa, mixture_plain.told);
  EXPECT_LT(of_mixture.ospa, of_phd.ospa);
  EXPECT_LT(of_short.ospa, of_phd.ospa);
  EXPECT_LT(mixture_plain.ospa, phd_plain.ospa);
  EXPECT_GE(better, seeds - 1) << "game by game";
}

INSTANTIATE_TEST_SUITE_P(OfTheTruth, MissedDetections, testing::Values(0.6, 0.75, 0.9, 0.98),
                         [](const auto& chosen) { return std::to_string(static_cast<int>(100 * chosen.param)); });

}  // namespace
