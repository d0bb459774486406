// SPDX-License-Identifier: MIT
#include "plugin/call_inputs.hpp"

#include <xxhash.h>

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

void Inputs::add(const char* whole, const char* part, const void* data, std::size_t bytes) {
  if (data == nullptr || bytes == 0) return;
  if (parts_.empty()) parts_.reserve(32);
  parts_.push_back({whole, part, data, bytes, XXH3_64bits(data, bytes)});
}

void Inputs::add(const char* whole, const char* part, const regista_span& elements) {
  add(whole, part, elements.data, std::size_t{elements.count} * elements.stride);
}

void Inputs::add(const char* whole, const char* part, const regista_matrix& m) {
  if (m.rows == 0) return;
  add(whole, part, m.values, (std::size_t{m.rows - 1} * m.stride + m.columns) * sizeof(double));
}

void Inputs::add(const char* name, const char* text) {
  if (text != nullptr) add(name, "", text, std::strlen(text) + 1);
}

void Inputs::add_world(const char* whole, const char* const (&parts)[4], const regista_world* world) {
  if (world == nullptr) return;
  add(whole, parts[0], world, sizeof *world);
  add(whole, parts[0], world->game, sizeof *world->game);
  add(whole, parts[0], world->ball, sizeof *world->ball);
  add(whole, parts[1], world->robots);
  add(whole, parts[2], world->opponents);
  add(whole, parts[3], world->active);
}

void Inputs::add(const char* name, const regista_frame* frame) {
  if (frame == nullptr) return;
  add(name, "", frame, sizeof *frame);
  add_world(name, {".mine", ".mine.robots", ".mine.opponents", ".mine.active"}, frame->mine);
  add_world(name, {".common", ".common.robots", ".common.opponents", ".common.active"}, frame->common);
  add(name, ".tasks", frame->tasks);
  add(name, ".waypoints", frame->waypoints);
  add(name, ".edges", frame->edges);
  add(name, ".previous", frame->previous);
  add(name, ".time_to_task", frame->time_to_task);
}

void Inputs::add(const char* name, const regista_matrix* matrix) {
  if (matrix == nullptr) return;
  add(name, "", matrix, sizeof *matrix);
  add(name, ".values", *matrix);
}

void Inputs::add(const char* name, const regista_message* message) {
  if (message == nullptr) return;
  add(name, "", message, sizeof *message);
  add(name, ".bytes", message->bytes, message->count);
}

void Inputs::add(const char* name, const regista_body* body) {
  if (body == nullptr) return;
  add(name, "", body, sizeof *body);
  add(name, ".robots_near", body->robots_near);
}

void Inputs::add(const char* name, const regista_environment* environment) {
  if (environment == nullptr) return;
  add(name, "", environment, sizeof *environment);
  add(name, ".landmarks", environment->landmarks);
  add(name, ".roles", environment->roles);
  add(name, ".kicks", environment->kicks);
  add(name, ".events", environment->events);
  const regista_span& roles = environment->roles;
  for (std::uint32_t i = 0; i < roles.count; ++i) {
    regista_role role;
    std::memcpy(&role, static_cast<const char*>(roles.data) + std::size_t{i} * roles.stride, sizeof role);
    if (role.name != nullptr) add(name, ".roles.name", role.name, std::strlen(role.name) + 1);
    if (role.list != nullptr) add(name, ".roles.list", role.list, std::strlen(role.list) + 1);
  }
}

std::string Inputs::changed() const {
  for (const Part& each : parts_) {
    if (XXH3_64bits(each.data, each.bytes) != each.fingerprint) return std::string(each.whole) + each.part;
  }
  return {};
}

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

std::uint64_t AnswerDigest::value() const {
  const std::span<const std::uint8_t> bytes = bytes_.bytes();
  return XXH3_64bits(bytes.data(), bytes.size());
}

}  // namespace regista::plugin
