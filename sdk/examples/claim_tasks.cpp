// SPDX-License-Identifier: MIT
// A negotiation that agrees over a bad radio: each robot claims the task that it wants most among those that nobody
// claims with a higher bid. It is the single-item case of Choi, Brunet and How, "Consensus-Based Decentralized Auctions
// for Robust Task Allocation" (IEEE T-RO 2009), for robots that all hear each other.
//
// A bid does not depend on what others say, so the highest bid of all stands at once, then the highest of the rest, and
// so on. What makes it robust: tasks are named by their id, a claim goes along with every packet, claims that were
// overtaken do not count, and those of who has left or fallen silent end.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <regista/assigner.hpp>
#include <regista/mailbox.hpp>

namespace {

struct Claim {
  static constexpr int nothing = 255;
  int task = nothing;  // id
  int bid = 0;         // utility in 65535ths
  double sent = -1e9;
};

struct ClaimTasks {
  static constexpr auto id = "claim_tasks", version = "1.0.0",
                        summary = "Each robot claims the best task that nobody claims with a higher bid";
  static constexpr unsigned reads = REGISTA_READS_NOTHING;
  static constexpr bool negotiates = true;

  double lasts = 60.0;
  static constexpr std::tuple parameters{
      regista::real("lasts", &ClaimTasks::lasts, {1.0, 120.0}, "s", "A claim counts for this long after it was sent")};

  regista::Mailbox mailbox;
  int own = 0;
  std::vector<Claim> claims;  // robot n: element n - 1
  Claim mine;
  std::array<std::uint8_t, 3> said{};
  std::uint64_t pending = 0;  // handle of what waits for a packet

  void setup(const regista::Environment& environment, regista::Mailbox way_out) {
    own = environment->own_number;
    mailbox = way_out;
    claims.resize(environment->team_size);
  }
  void reset(std::uint64_t) {
    std::ranges::fill(claims, Claim{});
    mine = {};
    pending = 0;
  }

  void assign(const regista::Frame& frame, regista::UtilityMatrix utilities, regista::Assignment out) {
    const auto active = frame.world().active();
    mine = {};
    for (std::size_t row = 0; row < active.size(); ++row) {
      if (active[row] == own) {
        out[row] = choose(frame, utilities, row);
      } else {
        out[row] = column_of(frame, utilities, row, claims[static_cast<std::size_t>(active[row] - 1)].task);
      }
    }
    say(frame.time());
  }

  void receive(const regista::Message& message) {
    const auto bytes = message.bytes();
    if (bytes.size() != said.size() || message.sender() > static_cast<int>(claims.size())) return;
    Claim& claim = claims[static_cast<std::size_t>(message.sender() - 1)];
    if (message.time_sent() < claim.sent) return;  // overtaken by a newer one
    claim = {bytes[0], bytes[1] + 256 * bytes[2], message.time_sent()};
  }
  void transmitted(std::uint64_t) { pending = 0; }  // the next decision says it again
  void dropped(std::uint64_t handle) {
    if (handle == pending) pending = 0;
  }
  std::string describe(std::span<const std::uint8_t> bytes) const {
    if (bytes.size() != said.size()) return "no claim";
    if (bytes[0] == Claim::nothing) return "claims nothing";
    return "claims task " + std::to_string(bytes[0]) + " with " + std::to_string(bytes[1] + 256 * bytes[2]);
  }

 private:
  std::int32_t choose(const regista::Frame& frame, const regista::UtilityMatrix& utilities, std::size_t row) {
    std::int32_t best = regista::Assignment::no_task;
    for (std::size_t column = 0; column < utilities.columns(); ++column) {
      if (utilities(row, column) == regista::UtilityMatrix::forbidden) continue;
      const Claim claim{frame.tasks()[column].id,
                        static_cast<int>(std::lround(65535.0 * std::clamp(utilities(row, column), 0.0, 1.0)))};
      const bool better = best == regista::Assignment::no_task || claim.bid > mine.bid;
      if (!better || is_outbid(frame, claim)) continue;
      best = static_cast<std::int32_t>(column);
      mine = claim;
    }
    return best;
  }

  // By a teammate that plays; of equal bids that of the lower number stands.
  bool is_outbid(const regista::Frame& frame, const Claim& claim) const {
    for (const std::int32_t number : frame.world().active()) {
      const Claim& other = claims[static_cast<std::size_t>(number - 1)];
      if (number == own || other.task != claim.task || frame.time() - other.sent > lasts) continue;
      if (other.bid > claim.bid || (other.bid == claim.bid && number < own)) return true;
    }
    return false;
  }

  // A teammate may claim what this robot does not know, or holds to be forbidden.
  static std::int32_t column_of(const regista::Frame& frame, const regista::UtilityMatrix& utilities, std::size_t row,
                                int task) {
    for (std::size_t column = 0; column < utilities.columns(); ++column) {
      const bool allowed = utilities(row, column) != regista::UtilityMatrix::forbidden;
      if (allowed && frame.tasks()[column].id == task) return static_cast<std::int32_t>(column);
    }
    return regista::Assignment::unknown_task;
  }

  void say(double now) {
    const std::array<std::uint8_t, 3> bytes{static_cast<std::uint8_t>(mine.task),
                                            static_cast<std::uint8_t>(mine.bid % 256),
                                            static_cast<std::uint8_t>(mine.bid / 256)};
    if (pending != 0 && bytes == said) return;
    said = bytes;
    pending = mailbox.offer(bytes, 0.0, now + lasts, pending);
  }
};

}  // namespace

REGISTA_PLUGIN(ClaimTasks, regista::assigner)
