// SPDX-License-Identifier: MIT
#include "plugin/declared_reads.hpp"

#include <algorithm>
#include <cstring>
#include <iterator>
#include <limits>

namespace regista::plugin {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

template <class T>
regista_span copied(const regista_span& from, std::vector<T>& to) {
  to.resize(from.count);
  for (std::uint32_t i = 0; i < from.count; ++i) {
    std::memcpy(&to[i], static_cast<const char*>(from.data) + std::size_t{i} * from.stride, sizeof(T));
  }
  return {to.data(), from.count, sizeof(T)};
}

void leave_out(regista_span& part) { part = {nullptr, 0, part.stride}; }

}  // namespace

const regista_world* DeclaredReads::shown(const regista_world& whole, std::uint32_t opponents, World& copy) const {
  copy.raw = whole;
  copy.ball = *whole.ball;
  copy.raw.ball = &copy.ball;
  if (!reads(opponents)) leave_out(copy.raw.opponents);
  if (reads(REGISTA_READS_COVARIANCES)) return &copy.raw;
  copy.raw.robots = copied(whole.robots, copy.robots);
  for (regista_robot& each : copy.robots) std::ranges::fill(each.covariance, nan);
  copy.raw.opponents = copied(copy.raw.opponents, copy.opponents);
  for (regista_opponent& each : copy.opponents) std::ranges::fill(each.covariance, nan);
  std::ranges::fill(copy.ball.covariance, nan);
  return &copy.raw;
}

const regista_frame* DeclaredReads::of(const regista_frame& frame) {
  frame_ = frame;
  frame_.mine = shown(*frame.mine, REGISTA_READS_OPPONENTS_MINE, worlds_[0]);
  frame_.common = shown(*frame.common, REGISTA_READS_OPPONENTS_COMMON, worlds_[1]);
  if (!reads(REGISTA_READS_FACINGS)) {
    frame_.tasks = copied(frame.tasks, tasks_);
    for (regista_task& each : tasks_) each.before[2] = each.after[2] = nan;
  }
  if (!reads(REGISTA_READS_TIMES)) frame_.time_to_task = {};
  if (!reads(REGISTA_READS_WAYPOINTS)) leave_out(frame_.waypoints);
  if (!reads(REGISTA_READS_EDGES)) leave_out(frame_.edges);
  if (!reads(REGISTA_READS_PREVIOUS)) leave_out(frame_.previous);
  return &frame_;
}

}  // namespace regista::plugin
