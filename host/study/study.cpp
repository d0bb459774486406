// SPDX-License-Identifier: MIT
#include "study/study.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "texts/json.hpp"
#include "texts/message.hpp"

namespace regista::study {
namespace {

// Thrown when the study asks for a match that the store does not hold.
struct NotPlayed {};

std::vector<std::int64_t> numbers_of(const Round& round, const campaign::Store& store) {
  return store.numbers(texts::names_of(round.fixtures, &campaign::Store::Fixture::key));
}

}  // namespace

std::string study_of(const std::string& plan) {
  const auto json = nlohmann::ordered_json::parse(plan, nullptr, false);
  if (!json.is_object() || !json.contains("study") || !json["study"].is_string()) return {};
  return json["study"].get<std::string>();
}

std::string Study::so_far(std::uint64_t matches) const {
  if (open_end().empty()) return std::to_string(matches) + " of " + std::to_string(most_matches()) + " matches";
  return texts::plural(matches, "match", "matches") + " (" + std::string(open_end()) + " ends the study)";
}

PlayRound observed(PlayRound play, AfterMatch after) {
  if (!after) return play;
  return [play = std::move(play), after = std::move(after)](const Round& round) {
    Round watched = round;
    watched.take = [&round, &after](std::uint64_t index, const campaign::MatchResult* decided) {
      const bool more = round.take(index, decided);
      after(round, index, decided);
      return more;
    };
    play(watched);
  };
}

PlayRound where_planned(PlayRound play, const campaign::Store& store, std::uint64_t& end) {
  return [play = std::move(play), &store, &end](const Round& round) {
    const std::vector<std::int64_t> numbers = numbers_of(round, store);
    const auto from = static_cast<std::int64_t>(round.first_row);
    // A match that the study no longer wants is not damage: it may have been played before it became unwanted.
    const auto planned = [&](std::int64_t row, const campaign::MatchKey& key) {
      const auto place = round.at(static_cast<std::uint64_t>(row - 1 - from));
      return !place || campaign::MatchKey{numbers[place->fixture], place->seed} == key;
    };
    store.require_planned(from + 1, from + static_cast<std::int64_t>(round.matches), planned);
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
    std::optional<campaign::MatchResult> decided;
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
  } catch (const NotPlayed&) {   // the store holds no more matches
  } catch (const StudyError&) {  // the study also ended here when it was played first
  }
  require_no_row_beyond(store, end);
}

}  // namespace regista::study
