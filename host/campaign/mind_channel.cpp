// SPDX-License-Identifier: MIT
#include "campaign/mind_channel.hpp"

#include <linux/futex.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cassert>
#include <cerrno>
#include <cstring>
#include <ctime>

namespace regista::campaign {
namespace {

// Not private: the word lies in memory that two processes share.
void sleep_while(std::atomic<std::uint32_t>& word, std::uint32_t value, const timespec* at_most) {
  syscall(SYS_futex, &word, FUTEX_WAIT, value, at_most, nullptr, 0);
}

void wake(std::atomic<std::uint32_t>& word) { syscall(SYS_futex, &word, FUTEX_WAKE, 1, nullptr, nullptr, 0); }

}  // namespace

void MindChannel::hand_over(std::uint32_t turn, std::uint32_t kind, std::span<const std::uint8_t> bytes) {
  assert(bytes.size() <= most_bytes);
  shared_->kind = kind;
  shared_->size = static_cast<std::uint32_t>(bytes.size());
  if (!bytes.empty()) std::memcpy(shared_->bytes, bytes.data(), bytes.size());
  shared_->turn.store(turn, std::memory_order_release);
  wake(shared_->turn);
}

void MindChannel::ask(Question question, int robot, std::span<const std::uint8_t> bytes) {
  shared_->robot = robot;
  hand_over(minds_turn, static_cast<std::uint32_t>(question), bytes);
}

void MindChannel::wait_for_reply(double seconds) {
  if (replied()) return;
  const auto whole = static_cast<std::time_t>(seconds);
  const timespec at_most{whole, static_cast<long>((seconds - static_cast<double>(whole)) * 1e9)};
  sleep_while(shared_->turn, minds_turn, &at_most);
}

void MindChannel::wait_for_question() {
  while (shared_->turn.load(std::memory_order_acquire) != minds_turn) sleep_while(shared_->turn, match_turn, nullptr);
}

void MindChannel::answer(Reply kind, std::span<const std::uint8_t> bytes) {
  hand_over(match_turn, static_cast<std::uint32_t>(kind), bytes);
}

// The size may be anything: the other process may have lost its mind.
std::span<const std::uint8_t> MindChannel::bytes() const {
  return std::span(shared_->bytes).first(std::min<std::size_t>(shared_->size, most_bytes));
}

}  // namespace regista::campaign
