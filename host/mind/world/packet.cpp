// SPDX-License-Identifier: MIT
#include "mind/world/packet.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace regista::mind {
namespace {

constexpr unsigned version = 1;

// Bits of the flags byte. count_mask: the three lowest bits contain the number of opponents.
constexpr unsigned flag_fallen = 1u << 3, flag_playing = 1u << 4, flag_ball = 1u << 5, count_mask = 7u,
                   reserved_flags = 3u << 6;
constexpr unsigned no_role = 255;

constexpr double millimetre = 1e-3, centimetre = 1e-2, decimetre = 0.1;
constexpr double angle_step = 2.0 * pi / 65536.0;

// Returns round(value / step), clipped to the range of `width` bits; in two's complement if `is_signed`.
std::uint32_t quantised(double value, double step, int width, bool is_signed) {
  const double top = std::ldexp(1.0, is_signed ? width - 1 : width) - 1.0;
  const double steps = std::nearbyint(value / step);
  const double clipped = std::clamp(steps, is_signed ? -top - 1.0 : 0.0, top);
  return static_cast<std::uint32_t>(static_cast<std::int64_t>(clipped)) & (width == 32 ? ~0u : (1u << width) - 1u);
}

double value_of(std::uint32_t raw, double step, int width, bool is_signed) {
  const bool negative = is_signed && (raw >> (width - 1)) != 0;
  return step * (static_cast<double>(raw) - (negative ? std::ldexp(1.0, width) : 0.0));
}

class Writer {
 public:
  explicit Writer(std::vector<std::uint8_t>& out) : out_(&out) {}
  void bits(std::uint32_t value, int bytes) {
    for (int i = 0; i < bytes; ++i) out_->push_back(static_cast<std::uint8_t>(value >> (8 * i)));
  }
  void number(double value, double step, int bytes, bool is_signed) {
    bits(quantised(value, step, 8 * bytes, is_signed), bytes);
  }
  // Writes an angle modulo 2^16 steps, so a full turn becomes 0.
  void heading(double value) {
    bits(static_cast<std::uint32_t>(static_cast<std::int64_t>(std::nearbyint(value / angle_step))) & 0xffffu, 2);
  }
  void role(int value) { bits(value < 0 ? no_role : static_cast<unsigned>(value), 1); }
  void context(int value) { bits(static_cast<unsigned>(std::max(value, 0)), 1); }

 private:
  std::vector<std::uint8_t>* out_;
};

class Reader {
 public:
  explicit Reader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
  bool failed() const { return failed_; }
  std::size_t left() const { return bytes_.size(); }
  std::span<const std::uint8_t> take(std::size_t count) {
    if (bytes_.size() < count) {
      failed_ = true;
      return {};
    }
    const auto taken = bytes_.first(count);
    bytes_ = bytes_.subspan(count);
    return taken;
  }
  std::uint32_t bits(std::size_t bytes) {
    const auto taken = take(bytes);
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < taken.size(); ++i) value |= static_cast<std::uint32_t>(taken[i]) << (8 * i);
    return value;
  }
  void number(double& value, double step, int bytes, bool is_signed) {
    value = value_of(bits(static_cast<std::size_t>(bytes)), step, 8 * bytes, is_signed);
  }
  void heading(double& value) {
    number(value, angle_step, 2, true);
    value = wrap(value);
  }
  void role(int& value) {
    const unsigned raw = bits(1);
    value = raw == no_role ? -1 : static_cast<int>(raw);
  }
  void context(int& value) { value = static_cast<int>(bits(1)); }

 private:
  std::span<const std::uint8_t> bytes_;
  bool failed_ = false;
};

// Reads or writes those fields of the core that follow version, sender and flags.
template <class Archive, class Told>
void core_fields(Archive& archive, Told& report) {
  archive.number(report.time_sent, 1e-3, 3, false);
  archive.number(report.pose.x, millimetre, 2, true);
  archive.number(report.pose.y, millimetre, 2, true);
  archive.heading(report.pose.heading);
  archive.number(report.position_deviation, centimetre, 1, false);
  archive.number(report.heading_deviation, 0.01, 1, false);
  archive.number(report.velocity.x(), centimetre, 1, true);
  archive.number(report.velocity.y(), centimetre, 1, true);
  archive.number(report.target.x(), millimetre, 2, true);
  archive.number(report.target.y(), millimetre, 2, true);
  archive.role(report.role);
  archive.number(report.role_since, 0.1, 2, false);
  archive.context(report.context);
  archive.number(report.time_until_up, 0.1, 1, false);
}

template <class Archive, class Told>
void ball_fields(Archive& archive, Told& ball) {
  archive.number(ball.position.x(), millimetre, 2, true);
  archive.number(ball.position.y(), millimetre, 2, true);
  archive.number(ball.velocity.x(), millimetre, 2, true);
  archive.number(ball.velocity.y(), millimetre, 2, true);
  archive.number(ball.age, 0.01, 2, false);
  archive.number(ball.deviation, centimetre, 1, false);
}

// Reads core, ball and opponents. Afterwards `read` is at the beginning of the first segment.
std::optional<Report> read_core(Reader& read, const PacketLimits& limits) {
  if (read.left() > limits.size) return std::nullopt;
  Report report;
  const unsigned head = read.bits(1);
  const unsigned flags = read.bits(1);
  report.sender = static_cast<int>(head >> 3);
  report.opponent_count = flags & count_mask;
  if ((head & 7u) != version || report.sender < 1 || report.sender > limits.team_size) return std::nullopt;
  if (report.opponent_count > Report::most_opponents || (flags & reserved_flags) != 0) return std::nullopt;
  report.fallen = (flags & flag_fallen) != 0;
  report.playing = (flags & flag_playing) != 0;
  core_fields(read, report);
  if (report.role >= limits.role_count || report.context >= std::max(limits.context_count, 1)) return std::nullopt;
  if ((flags & flag_ball) != 0) ball_fields(read, report.ball.emplace());
  for (std::size_t i = 0; i < report.opponent_count; ++i) {
    const std::uint32_t raw = read.bits(4);
    report.opponents[i] = {
        {value_of(raw & 0xfffu, centimetre, 12, true), value_of(raw >> 12 & 0xfffu, centimetre, 12, true)},
        value_of(raw >> 24 & 15u, decimetre, 4, false),
        value_of(raw >> 28, 0.5, 4, false)};
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
  core_fields(write, report);
  if (report.ball) ball_fields(write, *report.ball);
  for (std::size_t i = 0; i < report.opponent_count; ++i) {
    const ReportedOpponent& opponent = report.opponents[i];
    const std::uint32_t x = quantised(opponent.position.x(), centimetre, 12, true);
    const std::uint32_t y = quantised(opponent.position.y(), centimetre, 12, true);
    const std::uint32_t deviation = quantised(opponent.deviation, decimetre, 4, false);
    write.bits(x | y << 12 | deviation << 24 | quantised(opponent.age, 0.5, 4, false) << 28, 4);
  }
}

void append_segment(const Segment& segment, std::vector<std::uint8_t>& out) {
  assert(segment.place >= 0 && segment.place <= 255 && segment.bytes.size() <= 255);
  out.push_back(static_cast<std::uint8_t>(segment.place));
  out.push_back(static_cast<std::uint8_t>(segment.bytes.size()));
  out.insert(out.end(), segment.bytes.begin(), segment.bytes.end());
}

std::optional<Report> decode_core(std::span<const std::uint8_t> bytes, const PacketLimits& limits) {
  Reader read(bytes);
  return read_core(read, limits);
}

std::optional<Report> decode(std::span<const std::uint8_t> bytes, const PacketLimits& limits,
                             std::vector<Segment>& segments) {
  segments.clear();
  Reader read(bytes);
  const std::optional<Report> report = read_core(read, limits);
  if (!report) return std::nullopt;
  while (!read.failed() && read.left() > 0) {
    const int place = static_cast<int>(read.bits(1));
    segments.push_back({place, read.take(read.bits(1))});
  }
  if (!read.failed()) return report;
  segments.clear();
  return std::nullopt;
}

}  // namespace regista::mind
