// SPDX-License-Identifier: MIT
#include "mind/world/packet.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace regista::mind {
namespace {

constexpr unsigned version = 1;

// Bits of the flags byte; the three lowest count opponents.
constexpr unsigned flag_fallen = 1u << 3, flag_playing = 1u << 4, flag_ball = 1u << 5, count_mask = 7u,
                   reserved_flags = 3u << 6;
constexpr unsigned no_role = 255;

class Writer {
 public:
  explicit Writer(std::vector<std::uint8_t>& out) : out_(&out) {}
  void bits(std::uint32_t value, int bytes) {
    for (int i = 0; i < bytes; ++i) out_->push_back(static_cast<std::uint8_t>(value >> (8 * i)));
  }
  // round(value / step), clipped to what fits; two's complement when `is_signed`.
  void number(double value, double step, int bytes, bool is_signed) {
    bits(quantised(value, step, 8 * bytes, is_signed), bytes);
  }
  static std::uint32_t quantised(double value, double step, int width, bool is_signed) {
    const double top = std::ldexp(1.0, is_signed ? width - 1 : width) - 1.0;
    const double steps = std::nearbyint(value / step);
    const double clipped = std::clamp(steps, is_signed ? -top - 1.0 : 0.0, top);
    return static_cast<std::uint32_t>(static_cast<std::int64_t>(clipped)) & (width == 32 ? ~0u : (1u << width) - 1u);
  }

 private:
  std::vector<std::uint8_t>* out_;
};

class Reader {
 public:
  explicit Reader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
  bool failed() const { return failed_; }
  std::size_t left() const { return bytes_.size(); }
  std::uint32_t bits(std::size_t bytes) {
    if (bytes_.size() < bytes) {
      failed_ = true;
      return 0;
    }
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < bytes; ++i) value |= static_cast<std::uint32_t>(bytes_[i]) << (8 * i);
    bytes_ = bytes_.subspan(bytes);
    return value;
  }
  double number(double step, int bytes, bool is_signed) {
    return value_of(bits(static_cast<std::size_t>(bytes)), step, 8 * bytes, is_signed);
  }
  static double value_of(std::uint32_t raw, double step, int width, bool is_signed) {
    const bool negative = is_signed && (raw >> (width - 1)) != 0;
    return step * (static_cast<double>(raw) - (negative ? std::ldexp(1.0, width) : 0.0));
  }
  std::span<const std::uint8_t> take(std::size_t count) {
    if (bytes_.size() < count) {
      failed_ = true;
      return {};
    }
    const auto taken = bytes_.first(count);
    bytes_ = bytes_.subspan(count);
    return taken;
  }

 private:
  std::span<const std::uint8_t> bytes_;
  bool failed_ = false;
};

constexpr double millimetre = 1e-3, centimetre = 1e-2, decimetre = 0.1;
constexpr double angle_step = 2.0 * pi / 65536.0;

// Core, ball and opponents; `read` then stands at the first segment.
std::optional<Report> read_core(Reader& read, const PacketLimits& limits) {
  Report report;
  const unsigned head = read.bits(1);
  const unsigned flags = read.bits(1);
  report.sender = static_cast<int>(head >> 3);
  report.opponent_count = flags & count_mask;
  if ((head & 7u) != version || report.sender < 1 || report.sender > limits.team_size) return std::nullopt;
  if (report.opponent_count > Report::most_opponents || (flags & reserved_flags) != 0) return std::nullopt;
  report.fallen = (flags & flag_fallen) != 0;
  report.playing = (flags & flag_playing) != 0;
  report.time_sent = read.number(1e-3, 3, false);
  report.pose.x = read.number(millimetre, 2, true);
  report.pose.y = read.number(millimetre, 2, true);
  report.pose.heading = wrap(read.number(angle_step, 2, true));
  report.position_deviation = read.number(centimetre, 1, false);
  report.heading_deviation = read.number(0.01, 1, false);
  report.velocity.x() = read.number(centimetre, 1, true);
  report.velocity.y() = read.number(centimetre, 1, true);
  report.target.x() = read.number(millimetre, 2, true);
  report.target.y() = read.number(millimetre, 2, true);
  const unsigned role = read.bits(1);
  report.role = role == no_role ? -1 : static_cast<int>(role);
  report.role_since = read.number(0.1, 2, false);
  report.context = static_cast<int>(read.bits(1));
  report.time_until_up = read.number(0.1, 1, false);
  if (report.role >= limits.role_count || report.context >= std::max(limits.context_count, 1)) return std::nullopt;
  if ((flags & flag_ball) != 0) {
    ReportedBall& ball = report.ball.emplace();
    ball.position.x() = read.number(millimetre, 2, true);
    ball.position.y() = read.number(millimetre, 2, true);
    ball.velocity.x() = read.number(millimetre, 2, true);
    ball.velocity.y() = read.number(millimetre, 2, true);
    ball.age = read.number(0.01, 2, false);
    ball.deviation = read.number(centimetre, 1, false);
  }
  for (std::size_t i = 0; i < report.opponent_count; ++i) {
    const std::uint32_t raw = read.bits(4);
    ReportedOpponent& opponent = report.opponents[i];
    opponent.position.x() = Reader::value_of(raw & 0xfffu, centimetre, 12, true);
    opponent.position.y() = Reader::value_of(raw >> 12 & 0xfffu, centimetre, 12, true);
    opponent.deviation = Reader::value_of(raw >> 24 & 15u, decimetre, 4, false);
    opponent.age = Reader::value_of(raw >> 28, 0.5, 4, false);
  }
  return read.failed() ? std::nullopt : std::optional(report);
}

}  // namespace

void encode(const Report& report, std::vector<std::uint8_t>& out) {
  assert(report.sender >= 1 && report.sender <= 31);
  out.clear();
  Writer write(out);
  write.bits(version | static_cast<unsigned>(report.sender) << 3, 1);
  const unsigned flags = static_cast<unsigned>(report.opponent_count) | (report.fallen ? flag_fallen : 0) |
                         (report.playing ? flag_playing : 0) | (report.ball ? flag_ball : 0);
  write.bits(flags, 1);
  write.number(report.time_sent, 1e-3, 3, false);
  write.number(report.pose.x, millimetre, 2, true);
  write.number(report.pose.y, millimetre, 2, true);
  // A full turn wraps to 0 by itself: the angle is taken modulo 2^16 steps.
  write.bits(
      static_cast<std::uint32_t>(static_cast<std::int64_t>(std::nearbyint(report.pose.heading / angle_step))) & 0xffffu,
      2);
  write.number(report.position_deviation, centimetre, 1, false);
  write.number(report.heading_deviation, 0.01, 1, false);
  write.number(report.velocity.x(), centimetre, 1, true);
  write.number(report.velocity.y(), centimetre, 1, true);
  write.number(report.target.x(), millimetre, 2, true);
  write.number(report.target.y(), millimetre, 2, true);
  write.bits(report.role < 0 ? no_role : static_cast<unsigned>(report.role), 1);
  write.number(report.role_since, 0.1, 2, false);
  write.bits(static_cast<unsigned>(std::max(report.context, 0)), 1);
  write.number(report.time_until_up, 0.1, 1, false);
  if (report.ball) {
    write.number(report.ball->position.x(), millimetre, 2, true);
    write.number(report.ball->position.y(), millimetre, 2, true);
    write.number(report.ball->velocity.x(), millimetre, 2, true);
    write.number(report.ball->velocity.y(), millimetre, 2, true);
    write.number(report.ball->age, 0.01, 2, false);
    write.number(report.ball->deviation, centimetre, 1, false);
  }
  for (std::size_t i = 0; i < report.opponent_count; ++i) {
    const ReportedOpponent& opponent = report.opponents[i];
    const std::uint32_t x = Writer::quantised(opponent.position.x(), centimetre, 12, true);
    const std::uint32_t y = Writer::quantised(opponent.position.y(), centimetre, 12, true);
    const std::uint32_t deviation = Writer::quantised(opponent.deviation, decimetre, 4, false);
    const std::uint32_t age = Writer::quantised(opponent.age, 0.5, 4, false);
    write.bits(x | y << 12 | deviation << 24 | age << 28, 4);
  }
}

void append_segment(const Segment& segment, std::vector<std::uint8_t>& out) {
  assert(segment.place >= 0 && segment.place <= 255 && segment.bytes.size() <= 255);
  out.push_back(static_cast<std::uint8_t>(segment.place));
  out.push_back(static_cast<std::uint8_t>(segment.bytes.size()));
  out.insert(out.end(), segment.bytes.begin(), segment.bytes.end());
}

std::optional<Report> decode_core(std::span<const std::uint8_t> bytes, const PacketLimits& limits) {
  if (bytes.size() > limits.size) return std::nullopt;
  Reader read(bytes);
  return read_core(read, limits);
}

std::optional<Report> decode(std::span<const std::uint8_t> bytes, const PacketLimits& limits,
                             std::vector<Segment>& segments) {
  segments.clear();
  if (bytes.size() > limits.size) return std::nullopt;
  Reader read(bytes);
  const std::optional<Report> report = read_core(read, limits);
  if (!report) return std::nullopt;
  while (!read.failed() && read.left() > 0) {
    Segment segment;
    segment.place = static_cast<int>(read.bits(1));
    segment.bytes = read.take(read.bits(1));
    segments.push_back(segment);
  }
  if (read.failed()) {
    segments.clear();
    return std::nullopt;
  }
  return report;
}

}  // namespace regista::mind
