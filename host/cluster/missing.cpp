// SPDX-License-Identifier: MIT
#include "cluster/missing.hpp"

#include <optional>
#include <set>
#include <utility>

#include "campaign/match_key.hpp"

namespace regista::cluster {
namespace {

// From the first one that is missing on; the study is told nothing of them.
void find_places(const study::Round& round, const campaign::Store& store, const std::vector<std::int64_t>& numbers,
                 std::uint64_t first, std::uint64_t most, Missing& out) {
  std::set<std::pair<std::int64_t, std::uint64_t>> seen;
  for (std::uint64_t index = first; index < round.matches && seen.size() < most; ++index) {
    const auto place = round.at(index);
    if (!place) continue;
    const campaign::MatchKey key{numbers[place->fixture], place->seed};
    if (store.find(static_cast<std::int64_t>(round.first_row + index) + 1, key, campaign::Metrics::left_out)) continue;
    if (!seen.emplace(key.fixture, key.seed).second) continue;
    if (!out.places.empty() && out.places.back().end == index)
      ++out.places.back().end;
    else
      out.places.push_back({index, index + 1});
    if (round.first_of_pairing && round.first_of_pairing(index)) out.twice.push_back(index);
  }
}

}  // namespace

Missing missing_of(study::Study& study, campaign::Store& store, std::uint64_t most) {
  struct NotPlayed {};
  Missing out;
  bool first_round = true;
  const study::PlayRound take = [&](const study::Round& round) {
    out.is_first = std::exchange(first_round, false);
    const std::vector<std::int64_t> numbers = store.add(round.fixtures);
    for (std::uint64_t index = 0; index < round.matches; ++index) {
      std::optional<campaign::Decided> decided;
      if (const auto place = round.at(index)) {
        decided = store.find(static_cast<std::int64_t>(round.first_row + index) + 1,
                             {numbers[place->fixture], place->seed}, study.metrics());
        if (!decided) {
          out.first_row = round.first_row;
          out.round = round.matches;
          out.may_end_early = round.may_end_early;
          find_places(round, store, numbers, index, most, out);
          if (!study.limits().play_twice) out.twice.clear();
          throw NotPlayed();
        }
      }
      out.seen += decided ? 1 : 0;
      if (!round.take(index, decided ? &*decided : nullptr)) return;
    }
  };
  try {
    study.run(take);
  } catch (const NotPlayed&) {
    // out says what.
  }
  return out;
}

}  // namespace regista::cluster
