// SPDX-License-Identifier: MIT
// What a robot of a distributed auction knows: of every task the highest bid that it has heard of, and who made it.
// Tables are merged by the higher bid. Merging is idempotent, commutative and associative, so that lost, late, repeated
// and overtaken packets cost time and nothing else (Zavlanos, Spesivtsev and Pappas, CDC 2008).
//
// Our addition: a robot may give its task up. That is a bid of nobody at the same price, and it counts as the higher
// one. A price therefore never falls; whoever wants a task that was given up bids more than its last holder did.
#pragma once

#include <algorithm>
#include <bit>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "../negotiation/bits.hpp"

namespace auction {

inline constexpr std::int32_t nobody = 0;

// Prices count steps of utility. A task for which nobody has bid yet has the price 0.
struct Bid {
  std::uint32_t price = 0;
  std::int32_t bidder = nobody;  // shirt number
  friend bool operator==(Bid, Bid) = default;
};

// The higher price; of equal prices nobody's, then that of the lower number. A total order.
constexpr bool is_above(Bid bid, Bid other) {
  return bid.price != other.price ? bid.price > other.price : bid.bidder < other.bidder;
}

// True: the own bid was the lower one and is now the other.
constexpr bool merge(Bid& own, Bid heard) {
  if (!is_above(heard, own)) return false;
  own = heard;
  return true;
}

// How a table travels: epoch, number of tasks, then of each task its id, the bidder, the price and, where the auction
// has them, whether it is done. Tasks without a bid are left out. All robots of a team have the same format.
struct Format {
  unsigned count_bits = 0, task_bits = 0, bidder_bits = 0, price_bits = 0;
  bool has_done = false;
  std::uint32_t highest_price = 0;
  std::int32_t team_size = 0;
  std::size_t tasks = 0;      // ids are below
  std::size_t most_told = 0;  // tasks in one message

  static constexpr unsigned epoch_bits = 8;

  unsigned bits_each() const { return task_bits + bidder_bits + price_bits + (has_done ? 1u : 0u); }
  std::size_t bytes(std::size_t told) const { return (epoch_bits + count_bits + told * bits_each() + 7) / 8; }

  // most_bytes: of a message, at least 8.
  static Format fitting(std::int32_t team_size, std::size_t tasks, std::uint32_t highest_price, bool has_done,
                        std::size_t most_bytes) {
    const auto width = [](std::size_t most) { return std::max(1u, static_cast<unsigned>(std::bit_width(most))); };
    Format out;
    out.count_bits = width(tasks);
    out.task_bits = width(tasks == 0 ? 0 : tasks - 1);
    out.bidder_bits = width(static_cast<std::size_t>(team_size));
    out.price_bits = width(highest_price);
    out.has_done = has_done;
    out.highest_price = highest_price;
    out.team_size = team_size;
    out.tasks = tasks;
    const std::size_t room = 8 * most_bytes - epoch_bits - out.count_bits;
    out.most_told = std::min(tasks, room / out.bits_each());
    return out;
  }
};

struct Told {
  std::size_t task;
  Bid bid;
  bool done;
};

// told: at most format.most_told, ids ascending. Fills `bytes`, which has room.
inline void write_message(const Format& format, std::uint8_t epoch, std::span<const Told> told,
                          std::vector<std::uint8_t>& bytes) {
  assert(told.size() <= format.most_told);
  negotiation::BitWriter out(bytes);
  out.put(epoch, Format::epoch_bits);
  out.put(static_cast<std::uint32_t>(told.size()), format.count_bits);
  for (const Told& each : told) {
    out.put(static_cast<std::uint32_t>(each.task), format.task_bits);
    out.put(static_cast<std::uint32_t>(each.bid.bidder), format.bidder_bits);
    out.put(each.bid.price, format.price_bits);
    if (format.has_done) out.put(each.done ? 1u : 0u, 1);
  }
}

// Reads whatever was sent. False: it is no message of this format, and `told` may hold anything.
inline bool read_message(const Format& format, std::span<const std::uint8_t> bytes, std::uint8_t& epoch,
                         std::vector<Told>& told) {
  told.clear();
  negotiation::BitReader in(bytes);
  epoch = static_cast<std::uint8_t>(in.get(Format::epoch_bits));
  const std::size_t count = in.get(format.count_bits);
  if (count > format.most_told || format.bytes(count) != bytes.size()) return false;
  for (std::size_t k = 0; k < count; ++k) {
    Told each{};
    each.task = in.get(format.task_bits);
    each.bid.bidder = static_cast<std::int32_t>(in.get(format.bidder_bits));
    each.bid.price = in.get(format.price_bits);
    each.done = format.has_done && in.get(1) != 0;
    const bool in_order = told.empty() || told.back().task < each.task;
    if (!in_order || each.task >= format.tasks || each.bid.bidder > format.team_size) return false;
    if (each.bid.price == 0 || each.bid.price > format.highest_price) return false;
    told.push_back(each);
  }
  return in.complete();
}

}  // namespace auction
