// SPDX-License-Identifier: MIT
#include "study/study.hpp"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

#include "study/plan_names.hpp"
#include "texts/json.hpp"

namespace regista::study {
namespace {

// The file holds no more.
struct NotPlayed {};

}  // namespace

std::string study_of(const std::string& plan) {
  const auto json = nlohmann::ordered_json::parse(plan, nullptr, false);
  if (!json.is_object() || !json.contains("study") || !json["study"].is_string()) return {};
  return json["study"].get<std::string>();
}

PlayRound observed(PlayRound play, AfterMatch after) {
  if (!after) return play;
  return [play = std::move(play), after = std::move(after)](const Round& round) {
    Round watched = round;
    watched.take = [&round, &after](std::uint64_t index, const campaign::Decided* decided) {
      const bool more = round.take(index, decided);
      after(round, index, decided);
      return more;
    };
    play(watched);
  };
}

namespace {

std::vector<std::int64_t> numbers_of(const Round& round, const campaign::Store& store) {
  std::vector<std::string> keys;
  for (const campaign::Store::Fixture& each : round.fixtures) keys.push_back(each.key);
  return store.numbers(keys);
}

void require_planned(const campaign::Store& store, const Round& round) {
  const std::vector<std::int64_t> numbers = numbers_of(round, store);
  const auto key_at = [&](std::uint64_t index) -> std::optional<campaign::MatchKey> {
    const auto place = round.at(index);
    if (!place) return std::nullopt;
    return campaign::MatchKey{numbers[place->fixture], place->seed};
  };
  // At a place that is not wanted any more one may have been played ahead.
  const auto planned = [&](std::int64_t row, const campaign::MatchKey& key) {
    const auto here = key_at(static_cast<std::uint64_t>(row) - 1 - round.first_row);
    return !here || *here == key;
  };
  const auto from = static_cast<std::int64_t>(round.first_row);
  store.require_planned(from + 1, from + static_cast<std::int64_t>(round.matches), planned);
}

}  // namespace

PlayRound where_planned(PlayRound play, const campaign::Store& store, std::uint64_t& end) {
  return [play = std::move(play), &store, &end](const Round& round) {
    require_planned(store, round);
    end = std::max(end, round.first_row + round.matches);
    play(round);
  };
}

void require_no_row_beyond(const campaign::Store& store, std::uint64_t end) {
  constexpr auto lowest = std::numeric_limits<std::int64_t>::min(), highest = std::numeric_limits<std::int64_t>::max();
  const auto never = [](std::int64_t, const campaign::MatchKey&) { return false; };
  store.require_planned(lowest, 0, never);
  store.require_planned(static_cast<std::int64_t>(end) + 1, highest, never);
}

bool answer_from(const campaign::Store& store, const Round& round, campaign::Metrics metrics) {
  const std::vector<std::int64_t> numbers = numbers_of(round, store);
  for (std::uint64_t index = 0; index < round.matches; ++index) {
    std::optional<campaign::Decided> decided;
    if (const auto place = round.at(index)) {
      decided = store.find(static_cast<std::int64_t>(round.first_row + index) + 1,
                           {numbers[place->fixture], place->seed}, metrics);
      if (!decided) return false;
    }
    if (!round.take(index, decided ? &*decided : nullptr)) return true;
  }
  return true;
}

void read_back(Study& study, const campaign::Store& store, campaign::Metrics metrics, const AfterMatch& after) {
  const PlayRound read = [&](const Round& round) {
    if (!answer_from(store, round, metrics)) throw NotPlayed();
  };
  std::uint64_t end = 0;
  try {
    study.run(where_planned(observed(read, after), store, end));
  } catch (const NotPlayed&) {
    // It holds what there is.
  } catch (const StudyError&) {
    // As when it was played: nothing more came of it.
  }
  require_no_row_beyond(store, end);
}

}  // namespace regista::study
