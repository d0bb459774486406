// SPDX-License-Identifier: MIT
// A consensus auction that is sound, and the same with one mistake each, as authors make them.
//
// The sound one is the single-item case of Choi, Brunet and How, "Consensus-Based Decentralized Auctions for Robust
// Task Allocation" (IEEE T-RO 2009), over a broadcast radio: nobody relays, so a robot keeps nothing but the last claim
// of each teammate. A claim (task, bid) goes along with every packet. A robot takes the task that it bids most for
// among those that no active teammate claims with a higher bid; equal bids go to the lower number. What a robot bids
// does not depend on others, so the highest bid of all stands at once, then the highest of the rest, and so on.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include <regista/assigner.hpp>
#include <regista/budget.hpp>
#include <regista/mailbox.hpp>
#include <regista/told.hpp>

namespace {

enum class Mistake {
  none,
  names_columns,     // says which column it claims: another task for who does not know all of them
  counts_columns,    // packs task and bid with the number of tasks that it knows: others unpack something else
  falls_silent,      // has won against a claim of another: says it no more
  speaks_once,       // says each claim once: who did not hear it never will
  keeps_the_absent,  // who was heard once counts for ever, also when it has left
  never_begins,      // waits until all have spoken, and none is the first
  judges_alone       // computes what the others bid instead of hearing it
};

template <Mistake mistake>
struct Auction {
  static constexpr const char* id = mistake == Mistake::none               ? "consensus_auction"
                                    : mistake == Mistake::names_columns    ? "names_columns"
                                    : mistake == Mistake::counts_columns   ? "counts_columns"
                                    : mistake == Mistake::falls_silent     ? "falls_silent"
                                    : mistake == Mistake::speaks_once      ? "speaks_once"
                                    : mistake == Mistake::keeps_the_absent ? "keeps_the_absent"
                                    : mistake == Mistake::never_begins     ? "never_begins"
                                                                           : "judges_alone";
  static constexpr const char *version = "1.0.0", *summary = "Each robot takes the best task that nobody bids more for";
  static constexpr bool negotiates = true;

  static constexpr int nothing = 255;
  static constexpr double lasts = 60.0;  // s: a claim of which nothing was heard for so long is void
  struct Claim {
    int task = nothing;  // as it was told
    int bid = 0;
    double heard = -1e9, sent = -1e9;
  };

  regista::Mailbox mailbox;
  std::vector<Claim> claims;  // by number - 1
  int own = 0;
  std::uint64_t pending = 0;
  std::array<std::uint8_t, 3> said{};
  bool settled = false;  // has won against another claim
  Claim mine;

  void setup(const regista::Environment& environment, regista::Mailbox way_out) {
    own = environment->own_number;
    mailbox = way_out;
    claims.resize(environment->team_size);
  }
  void reset(std::uint64_t) {
    std::ranges::fill(claims, Claim{});
    pending = 0;
    said = {};
    settled = false;
    mine = {};
  }

  void assign(const regista::Frame& frame, regista::UtilityMatrix utilities, regista::Assignment out) {
    const auto active = frame.world().active();
    const std::size_t row = row_of(active, own);
    if (row == active.size()) {
      mine = {};
      return say(frame, 0);  // a robot that does not play claims nothing
    }
    if (mistake == Mistake::never_begins && std::ranges::count(claims, nothing, &Claim::task) > 1) {
      return say(frame, 0);  // it has heard of too few
    }
    int best = -1, best_bid = -1;
    for (std::size_t column = 0; column < utilities.columns(); ++column) {
      if (utilities(row, column) == regista::UtilityMatrix::forbidden) continue;
      const int bid = bid_of(utilities(row, column));
      if (bid > best_bid && !beaten(frame, utilities, column, bid)) {
        best = static_cast<int>(column);
        best_bid = bid;
      }
    }
    const Claim before = mine;
    mine = {};
    if (best >= 0) {
      out[row] = best;
      const bool by_column = mistake == Mistake::names_columns || mistake == Mistake::counts_columns;
      mine.task = by_column ? best : frame.tasks()[static_cast<std::size_t>(best)].id;
      mine.bid = best_bid;
    }
    if (mine.task != before.task) settled = false;
    say(frame, utilities.columns());
    show_what_others_say(frame, utilities, row, out);
  }

  void receive(const regista::Message& message) {
    const auto bytes = message.bytes();
    if (bytes.size() != 3 || message.sender() < 1 || message.sender() > static_cast<int>(claims.size())) return;
    Claim& claim = claims[static_cast<std::size_t>(message.sender() - 1)];
    if (message.time_sent() < claim.sent) return;  // overtaken by a newer one
    claim = {bytes[0], bytes[1] + 256 * bytes[2], message.time_heard(), message.time_sent()};
    if (claim.task == mine.task && higher(mine.bid, own, claim.bid, message.sender())) settled = true;
  }
  void transmitted(std::uint64_t handle) {
    if (handle == pending) pending = 0;
  }
  void dropped(std::uint64_t handle) { transmitted(handle); }

 private:
  static std::size_t row_of(const regista::Span<std::int32_t>& active, int number) {
    std::size_t row = 0;
    while (row < active.size() && active[row] != number) ++row;
    return row;
  }
  static int bid_of(double utility) { return static_cast<int>(std::lround(65535.0 * std::clamp(utility, 0.0, 1.0))); }
  static bool higher(int bid, int number, int other_bid, int other_number) {
    return bid > other_bid || (bid == other_bid && number < other_number);
  }

  bool beaten(const regista::Frame& frame, const regista::UtilityMatrix& utilities, std::size_t column, int bid) const {
    const auto active = frame.world().active();
    for (int number = 1; number <= static_cast<int>(claims.size()); ++number) {
      if (number == own) continue;
      const auto row = row_of(active, number);
      const bool plays = row < active.size();
      if constexpr (mistake == Mistake::judges_alone) {
        if (plays && higher(bid_of(utilities(row, column)), number, bid, own) && is_best(utilities, row, column)) {
          return true;
        }
        continue;
      }
      const Claim& claim = claims[static_cast<std::size_t>(number - 1)];
      if (mistake == Mistake::keeps_the_absent) {
        if (claim.task == nothing) continue;
      } else if (!plays || frame.time() - claim.heard > lasts) {
        continue;
      }
      if (task_told(claim, utilities.columns()) != name_of(frame, column)) continue;
      if (higher(bid_told(claim, utilities.columns()), number, bid, own)) return true;
    }
    return false;
  }
  static bool is_best(const regista::UtilityMatrix& utilities, std::size_t row, std::size_t column) {
    for (std::size_t j = 0; j < utilities.columns(); ++j) {
      if (utilities(row, j) > utilities(row, column)) return false;
    }
    return true;
  }

  static int name_of(const regista::Frame& frame, std::size_t column) {
    const bool by_column = mistake == Mistake::names_columns || mistake == Mistake::counts_columns;
    return by_column ? static_cast<int>(column) : frame.tasks()[column].id;
  }
  static int task_told(const Claim& claim, std::size_t columns) {
    if (mistake != Mistake::counts_columns || claim.task == nothing) return claim.task;
    return claim.bid % static_cast<int>(columns + 1);
  }
  static int bid_told(const Claim& claim, std::size_t columns) {
    if (mistake != Mistake::counts_columns) return claim.bid;
    const int c = static_cast<int>(columns + 1);
    return claim.bid / c * c;
  }

  void say(const regista::Frame& frame, std::size_t columns) {
    int task = mine.task, bid = mine.bid;
    if (mistake == Mistake::counts_columns && task != nothing) {
      const int c = static_cast<int>(columns + 1);
      mine.bid = bid = std::min(bid, 65535 - c) / c * c + task;
      task = 0;
    }
    const std::array<std::uint8_t, 3> bytes{static_cast<std::uint8_t>(task), static_cast<std::uint8_t>(bid % 256),
                                            static_cast<std::uint8_t>(bid / 256)};
    if (mistake == Mistake::falls_silent && settled) {
      if (pending != 0) mailbox.withdraw(pending);
      return;
    }
    if (mistake == Mistake::judges_alone) return;
    if (bytes == said && (pending != 0 || mistake == Mistake::speaks_once)) return;
    said = bytes;
    pending = mailbox.offer(bytes, 0.5, frame.time() + 5.0, pending);
  }

  // Teammates do what they claim; of who has claimed nothing it does not know.
  void show_what_others_say(const regista::Frame& frame, const regista::UtilityMatrix& utilities, std::size_t own_row,
                            const regista::Assignment& out) const {
    const auto active = frame.world().active();
    for (std::size_t row = 0; row < active.size(); ++row) {
      if (row == own_row) continue;
      out[row] = regista::Assignment::unknown_task;
      const Claim& claim = claims[static_cast<std::size_t>(active[row] - 1)];
      if (claim.task == nothing) continue;
      for (std::size_t column = 0; column < utilities.columns(); ++column) {
        const bool allowed = utilities(row, column) != regista::UtilityMatrix::forbidden;
        if (allowed && name_of(frame, column) == task_told(claim, utilities.columns())) {
          out[row] = static_cast<std::int32_t>(column);
        }
      }
    }
  }
};

// Counts on the extensions: claims nothing without packets left, and a claim of who has not told for long is void.
struct Asking : Auction<Mistake::none> {
  static constexpr const char* id = "asks_what_was_told";
  regista::BudgetNow budget;
  regista::Told told;
  void setup(const regista::Environment& environment, const regista::Host& host) {
    Auction::setup(environment, host.mailbox());
    budget = regista::BudgetNow(host);
    told = regista::Told(host);
  }
  void assign(const regista::Frame& frame, regista::UtilityMatrix utilities, regista::Assignment out) {
    if (budget.read()->packets_left <= 0) return;
    for (std::size_t index = 0; index < claims.size(); ++index) {
      const auto packet = told.packet(static_cast<int>(index) + 1);
      if (!packet) claims[index] = {};  // nothing can have been claimed
    }
    Auction::assign(frame, utilities, out);
  }
};

// Negotiates, and does not say so.
struct Unsaid : Auction<Mistake::names_columns> {
  static constexpr const char* id = "does_not_say_it_negotiates";
  static constexpr bool negotiates = false;
};

// Says that it negotiates, and has nothing to hear with: each robot takes what is best for it alone.
struct WithoutMailbox {
  static constexpr auto id = "negotiates_without_mailbox", version = "1.0.0",
                        summary = "Each robot takes its best task";
  static constexpr bool negotiates = true;

  int own = 0;
  void setup(const regista::Environment& environment) { own = environment->own_number; }
  void assign(const regista::Frame& frame, regista::UtilityMatrix utilities, regista::Assignment out) {
    const auto active = frame.world().active();
    for (std::size_t row = 0; row < utilities.rows(); ++row) {
      if (active[row] != own) {
        out[row] = regista::Assignment::unknown_task;
        continue;
      }
      double best = regista::UtilityMatrix::forbidden;
      for (std::size_t column = 0; column < utilities.columns(); ++column) {
        if (utilities(row, column) <= best) continue;
        best = utilities(row, column);
        out[row] = static_cast<std::int32_t>(column);
      }
    }
  }
};

template <Mistake mistake>
using As = regista::Plugin<Auction<mistake>, regista::assigner>;

}  // namespace

REGISTA_PLUGINS(As<Mistake::none>, As<Mistake::names_columns>, As<Mistake::counts_columns>, As<Mistake::falls_silent>,
                As<Mistake::speaks_once>, As<Mistake::keeps_the_absent>, As<Mistake::never_begins>,
                As<Mistake::judges_alone>, regista::Plugin<Asking, regista::assigner>,
                regista::Plugin<Unsaid, regista::assigner>, regista::Plugin<WithoutMailbox, regista::assigner>)
