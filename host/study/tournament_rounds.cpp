// SPDX-License-Identifier: MIT
#include "study/tournament_rounds.hpp"

#include <algorithm>
#include <bit>
#include <numeric>

namespace regista::study {
namespace {

TeamPair by_seed(std::size_t a, std::size_t b) { return {std::min(a, b), std::max(a, b)}; }

// Pairs teams that have not met, with backtracking. The number of attempts is limited, because few teams after many
// rounds may have no such pairing at all.
class Monrad {
 public:
  Monrad(std::span<const std::size_t> order, const std::vector<std::vector<char>>& met)
      : order_(order.begin(), order.end()), met_(met), paired_(order.size(), 0) {}

  std::optional<std::vector<TeamPair>> pairs() { return complete() ? std::optional(std::move(out_)) : std::nullopt; }

 private:
  bool complete() {
    const auto first = static_cast<std::size_t>(std::ranges::find(paired_, 0) - paired_.begin());
    if (first == order_.size()) return true;
    paired_[first] = 1;
    for (std::size_t next = first + 1; next < order_.size(); ++next) {
      if (paired_[next] != 0 || met_[order_[first]][order_[next]] != 0) continue;
      if (--attempts_ < 0) break;
      paired_[next] = 1;
      out_.push_back(by_seed(order_[first], order_[next]));
      if (complete()) return true;
      out_.pop_back();
      paired_[next] = 0;
    }
    paired_[first] = 0;
    return false;
  }

  std::vector<std::size_t> order_;
  const std::vector<std::vector<char>>& met_;
  std::vector<char> paired_;
  std::vector<TeamPair> out_;
  int attempts_ = 100'000;
};

}  // namespace

DrawnRound swiss_round(const SwissStanding& standing) {
  std::vector<std::size_t> order(standing.points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::erase_if(order, [&](std::size_t team) { return standing.plays[team] == 0; });
  std::ranges::stable_sort(order, std::greater(), [&](std::size_t team) { return standing.points[team]; });
  DrawnRound out;
  if (order.size() % 2 == 1) {
    const auto last = std::ranges::find_if(order.rbegin(), order.rend(),
                                           [&](std::size_t team) { return standing.had_bye[team] == 0; });
    out.bye = last == order.rend() ? order.back() : *last;
    std::erase(order, *out.bye);
  }
  if (auto pairs = Monrad(order, standing.met).pairs()) {
    out.meetings = std::move(*pairs);
    return out;
  }
  for (std::size_t i = 0; i + 1 < order.size(); i += 2) out.meetings.push_back(by_seed(order[i], order[i + 1]));
  return out;
}

std::size_t knock_out_rounds(std::size_t teams) { return static_cast<std::size_t>(std::bit_width(teams - 1)); }

std::vector<TeamPair> knock_out_round(std::size_t teams, std::size_t round,
                                      const std::function<std::size_t(const TeamPair&)>& winner) {
  // The seeds of a bracket of twice the size are these seeds, each beside the seed with which it sums up to the size.
  std::vector<std::optional<std::size_t>> bracket{0};
  while (bracket.size() < std::bit_ceil(teams)) {
    const std::size_t size = 2 * bracket.size();
    std::vector<std::optional<std::size_t>> larger;
    for (const auto& seed : bracket) larger.insert(larger.end(), {seed, size - 1 - *seed});
    bracket = std::move(larger);
  }
  for (auto& place : bracket) {
    if (*place >= teams) place.reset();
  }
  const auto meeting = [&](std::size_t i) -> std::optional<TeamPair> {
    if (!bracket[i] || !bracket[i + 1]) return std::nullopt;
    return by_seed(*bracket[i], *bracket[i + 1]);
  };
  for (std::size_t earlier = 0; earlier < round; ++earlier) {
    std::vector<std::optional<std::size_t>> next;
    for (std::size_t i = 0; i + 1 < bracket.size(); i += 2) {
      const auto pair = meeting(i);
      next.push_back(pair ? winner(*pair) : bracket[i] ? bracket[i] : bracket[i + 1]);
    }
    bracket = std::move(next);
  }
  std::vector<TeamPair> out;
  for (std::size_t i = 0; i + 1 < bracket.size(); i += 2) {
    if (const auto pair = meeting(i)) out.push_back(*pair);
  }
  return out;
}

}  // namespace regista::study
