// SPDX-License-Identifier: MIT
#include "study/study.hpp"

#include <string>
#include <utility>

#include "config/json.hpp"
#include "study/plan_names.hpp"

namespace regista::study {
namespace {

// The file holds no more.
struct NotPlayed {};

}  // namespace

std::string study_of(const std::string& plan) {
  const auto json = nlohmann::ordered_json::parse(plan, nullptr, false);
  if (!json.is_object() || !json.contains("study") || !json["study"].is_string()) return {};
  return holds_comparison_of_before(json) ? search_comparison_study : json["study"].get<std::string>();
}

bool holds_comparison_of_before(const nlohmann::ordered_json& plan) {
  if (!plan.is_object() || !plan.contains("study") || plan["study"] != tuning_study) return false;
  return plan.contains("compared") && plan["compared"] != nlohmann::ordered_json::array();
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

bool answer_from(const campaign::Store& store, const Round& round, campaign::Metrics metrics) {
  std::vector<std::string> keys;
  for (const campaign::Store::Fixture& each : round.fixtures) keys.push_back(each.key);
  const std::vector<std::int64_t> numbers = store.numbers(keys);
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
  try {
    study.run(observed(read, after));
  } catch (const NotPlayed&) {
    // It holds what there is.
  } catch (const StudyError&) {
    // As when it was played: nothing more came of it.
  }
}

}  // namespace regista::study
