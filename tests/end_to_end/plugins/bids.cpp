// SPDX-License-Identifier: MIT
// An assigner that negotiates: every robot bids its utility for the task that it wants most, and reckons with the last
// bids of its teammates in place of what it computes for them. On the way everything that can become of an offer does:
// a bid replaces the one before it, one in seven is withdrawn, one in five expires before the next one comes, and one
// in ten is longer than any packet.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include <regista/assigner.hpp>
#include <regista/mailbox.hpp>

namespace {

struct Bids {
  static constexpr auto id = "bids", version = "1.0.0", summary = "Robots bid for tasks";

  struct Bid {
    std::uint8_t round = 0, task = 0, utility = 0;  // id of the task; utility in hundredths
  };

  regista::Mailbox mailbox;
  std::vector<Bid> heard;  // by number (n - 1); round 0: none
  std::vector<char> taken;
  int own = 0;
  std::uint64_t pending = 0;
  std::uint8_t round = 0;
  double next = 0.0;

  void setup(const regista::Environment& environment, regista::Mailbox way_out) {
    own = environment->own_number;
    mailbox = way_out;
    heard.resize(environment->team_size);
    taken.reserve(environment.roles().size());
  }
  void reset(std::uint64_t) {
    std::fill(heard.begin(), heard.end(), Bid{});
    pending = 0;
    round = 0;
    next = 0.0;
  }

  void assign(const regista::Frame& frame, regista::UtilityMatrix utilities, regista::Assignment out) {
    taken.assign(utilities.columns(), 0);
    const auto active = frame.world().active();
    for (std::size_t step = 0; step < utilities.rows(); ++step) {
      double best = -1.0;
      std::size_t row = 0, column = 0;
      for (std::size_t i = 0; i < utilities.rows(); ++i) {
        for (std::size_t j = 0; j < utilities.columns(); ++j) {
          if (taken[j] != 0 || out[i] != regista::Assignment::no_task) continue;
          const double value = worth(frame, utilities, active[i], i, j);
          if (!(value > best)) continue;
          best = value;
          row = i;
          column = j;
        }
      }
      if (best < 0.0) break;
      out[row] = static_cast<std::int32_t>(column);
      taken[column] = 1;
      if (active[row] == own) bid(frame, frame.tasks()[column].id, best);
    }
  }

  void receive(const regista::Message& message) {
    const auto bytes = message.bytes();
    if (bytes.size() != 3 || message.sender() > static_cast<int>(heard.size())) return;
    heard[static_cast<std::size_t>(message.sender() - 1)] = {bytes[0], bytes[1], bytes[2]};
  }
  void transmitted(std::uint64_t handle) { forget(handle); }
  void dropped(std::uint64_t handle) { forget(handle); }

  std::string describe(std::span<const std::uint8_t> bytes) const {
    if (bytes.size() != 3) return "no bid: \"" + std::to_string(bytes.size()) + " bytes\"";
    return "bid " + std::to_string(bytes[0]) + ": 0." + (bytes[2] < 10 ? "0" : "") + std::to_string(bytes[2]) +
           " for task " + std::to_string(bytes[1]);
  }

 private:
  // What a teammate bids for this task, or less than all bids where it bids for another one.
  double worth(const regista::Frame& frame, const regista::UtilityMatrix& utilities, int number, std::size_t row,
               std::size_t column) const {
    const double computed = utilities(row, column);
    if (computed == regista::UtilityMatrix::forbidden) return -1.0;
    const Bid& bid = heard[static_cast<std::size_t>(number - 1)];
    if (number == own || bid.round == 0 || frame.tasks()[column].id != bid.task) return computed;
    return 0.01 * bid.utility;
  }

  void bid(const regista::Frame& frame, std::int32_t task, double utility) {
    if (frame.time() < next) {
      if (round % 7 == 0) mailbox.withdraw(pending);
      return;
    }
    next = frame.time() + 0.35;
    round = static_cast<std::uint8_t>(round == 255 ? 1 : round + 1);
    if (round % 10 == 0) {
      const std::array<std::uint8_t, 100> much{};
      mailbox.offer(much, 0.5, frame.time() + 1.0);
      return;
    }
    const std::array<std::uint8_t, 3> bytes{
        round, static_cast<std::uint8_t>(task),
        static_cast<std::uint8_t>(std::clamp(std::lround(100.0 * utility), 0l, 99l))};
    const double expiry = frame.time() + (round % 5 == 0 ? 0.2 : 2.0);
    pending = mailbox.offer(bytes, 0.5, expiry, pending);
  }

  void forget(std::uint64_t handle) {
    if (handle == pending) pending = 0;
  }
};

}  // namespace

REGISTA_PLUGIN(Bids, regista::assigner)
