// SPDX-License-Identifier: MIT
// What crosses between a match and minds in another process arrives bit for bit. The members are named by structured
// bindings: one that is added to a struct and not to this test does not compile, one that is not sent is found.
#include "mind/serialization.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cstring>
#include <random>
#include <stdexcept>
#include <tuple>
#include <type_traits>

namespace regista::mind {
namespace {

template <class T, class Plain>
concept Is = std::is_same_v<std::remove_const_t<T>, Plain>;

auto members(Is<Pose> auto& all) {
  auto& [x, y, heading] = all;
  return std::tie(x, y, heading);
}
auto members(Is<PlacedPose> auto& all) {
  auto& [pose, position, heading] = all;
  return std::tie(pose, position, heading);
}
auto members(Is<BallSighting> auto& all) {
  auto& [position, along, across] = all;
  return std::tie(position, along, across);
}
auto members(Is<RobotSighting> auto& all) {
  auto& [position, along, across, own_team] = all;
  return std::tie(position, along, across, own_team);
}
auto members(Is<LandmarkSighting> auto& all) {
  auto& [kind, position, along, across] = all;
  return std::tie(kind, position, along, across);
}
auto members(Is<View> auto& all) {
  auto& [heading, half_angle, ball_range, robot_range] = all;
  return std::tie(heading, half_angle, ball_range, robot_range);
}
auto members(Is<GameTold> auto& all) {
  auto& [phase, set_play, own_kick, half, own, other, time, half_left, match_left, packets, own_out, other_out] = all;
  return std::tie(phase, set_play, own_kick, half, own, other, time, half_left, match_left, packets, own_out,
                  other_out);
}
auto members(Is<Percepts> auto& all) {
  auto& [time, odometry, placed, camera, view, balls, robots, landmarks, contact, whistle, fallen, until_up, kicking,
         penalised, game] = all;
  return std::tie(time, odometry, placed, camera, view, balls, robots, landmarks, contact, whistle, fallen, until_up,
                  kicking, penalised, game);
}
auto members(Is<Walk> auto& all) {
  auto& [forward, sideways, turn] = all;
  return std::tie(forward, sideways, turn);
}
auto members(Is<KickRequest> auto& all) {
  auto& [kind, direction, distance, receiver] = all;
  return std::tie(kind, direction, distance, receiver);
}
auto members(Is<Command> auto& all) {
  auto& [walk, kick, head_yaw] = all;
  return std::tie(walk, kick, head_yaw);
}
auto members(Is<Target> auto& all) {
  auto& [x, y] = all;
  return std::tie(x, y);
}
auto members(Is<SegmentCounts> auto& all) {
  auto& [offered, refused, sent, dropped, heard, bytes] = all;
  return std::tie(offered, refused, sent, dropped, heard, bytes);
}
auto members(Is<MetricReport> auto& all) {
  auto& [metric, place, count, sum, least, greatest, last] = all;
  return std::tie(metric, place, count, sum, least, greatest, last);
}
auto members(Is<Outcome> auto& all) {
  auto& [command, send, reason, packet, role, assignment, context, kept, target, announced, segments, metrics] = all;
  return std::tie(command, send, reason, packet, role, assignment, context, kept, target, announced, segments, metrics);
}

// Any bits: infinities, signed noughts, what is not a number.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  template <class T>
  void fill(T& value) {
    if constexpr (std::is_same_v<T, bool>) {
      value = (engine_() & 1) != 0;
    } else if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T>) {
      const std::uint64_t bits = engine_();
      std::memcpy(&value, &bits, sizeof value);
    } else {
      std::apply([this](auto&... each) { (this->fill(each), ...); }, members(value));
    }
  }
  void fill(Eigen::Vector2d& value) {
    fill(value.x());
    fill(value.y());
  }
  template <class T>
  void fill(std::vector<T>& list) {
    list.resize(engine_() % 5);
    for (T& each : list) fill(each);
  }
  template <class T>
  void fill(std::optional<T>& value) {
    value.reset();
    if ((engine_() & 1) != 0) fill(value.emplace());
  }

 private:
  std::mt19937_64 engine_;
};

template <class T>
bool same(const T& a, const T& b);

bool same(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return same<double>(a.x(), b.x()) && same<double>(a.y(), b.y());
}
template <class T>
bool same(const std::vector<T>& a, const std::vector<T>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (!same(a[i], b[i])) return false;
  }
  return true;
}
template <class T>
bool same(const std::optional<T>& a, const std::optional<T>& b) {
  return a.has_value() == b.has_value() && (!a || same(*a, *b));
}
template <class T>
bool same(const T& a, const T& b) {
  if constexpr (std::is_same_v<T, double>) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
  } else if constexpr (std::is_arithmetic_v<T> || std::is_enum_v<T>) {
    return a == b;
  } else {
    return std::apply(
        [&b](const auto&... ours) {
          return std::apply([&](const auto&... theirs) { return (same(ours, theirs) && ...); }, members(b));
        },
        members(a));
  }
}

template <class T>
void survives(std::uint64_t seed) {
  Random random(seed);
  T sent, received;
  random.fill(sent);
  random.fill(received);  // what stood there before is of no importance
  texts::BytesOut out;
  out(sent);
  texts::BytesIn in(out.bytes());
  in(received);
  EXPECT_TRUE(in.empty());
  EXPECT_TRUE(same(sent, received)) << "seed " << seed;
  // Cut short anywhere, they are no answer.
  for (std::size_t length = 0; length < out.bytes().size(); length += 1 + out.bytes().size() / 40) {
    texts::BytesIn cut(out.bytes().first(length));
    EXPECT_THROW(cut(received), std::out_of_range) << length;
  }
}

TEST(Wire, PerceptsArriveBitForBit) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) survives<Percepts>(seed);
}

TEST(Wire, OutcomesArriveBitForBit) {
  for (std::uint64_t seed = 1; seed <= 300; ++seed) survives<Outcome>(seed);
}

TEST(Wire, PacketsArriveInTheirOrder) {
  const std::vector<std::uint8_t> first{1, 2, 3}, second, third(128, 255);
  const std::vector<HeardPacket> sent{{0.25, first}, {-0.0, second}, {1e300, third}};
  texts::BytesOut out;
  write_heard(out, sent);
  std::vector<HeardPacket> received(7);
  texts::BytesIn in(out.bytes());
  read_heard(in, received);
  EXPECT_TRUE(in.empty());
  ASSERT_EQ(received.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_TRUE(same(received[i].time_heard, sent[i].time_heard)) << i;
    EXPECT_TRUE(std::ranges::equal(received[i].bytes, sent[i].bytes)) << i;
  }
  texts::BytesIn cut(out.bytes().first(out.bytes().size() - 1));
  EXPECT_THROW(read_heard(cut, received), std::out_of_range);
}

}  // namespace
}  // namespace regista::mind
