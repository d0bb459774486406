// SPDX-License-Identifier: MIT
#include "cli/stored_tuning.hpp"

#include <algorithm>
#include <charconv>
#include <string>
#include <vector>

#include "config/scalar.hpp"
#include "study/measure.hpp"

namespace regista::cli {
namespace {

// Their names in the file.
constexpr auto end_of_search = "search ended after";
constexpr auto time_of_search = "time of search";

// The file holds no more.
struct NotPlayed {};

}  // namespace

campaign::Metrics metrics_wanted(const study::TuningPlan& plan) {
  const auto of_score = [](const study::ObjectiveTerm& each) {
    return std::ranges::find(study::measures_of_score, each.measure) != study::measures_of_score.end();
  };
  const bool of_scores = std::ranges::all_of(plan.objective.terms, of_score);
  return of_scores && !plan.short_games() ? campaign::Metrics::left_out : campaign::Metrics::wanted;  // for packets
}

std::optional<std::uint64_t> stored_end_of_search(const campaign::Store& store) {
  const std::string text = store.meta(end_of_search);
  std::uint64_t out = 0;
  if (text.empty()) return std::nullopt;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), out);
  if (error != std::errc() || rest != text.data() + text.size()) {
    throw campaign::StoreError("the end of the search in the results is damaged");
  }
  return out;
}

void store_end_of_search(campaign::Store& store, std::uint64_t evaluations) {
  store.set_meta(end_of_search, std::to_string(evaluations));
}

SearchTime stored_time_of_search(const campaign::Store& store) {
  const std::string text = store.meta(time_of_search);
  SearchTime out;
  const char* const end = text.data() + text.size();
  const auto [rest, error] = std::from_chars(text.data(), end, out.evaluations);
  if (error == std::errc() && rest != end) std::from_chars(rest + 1, end, out.seconds);
  return out;
}

void store_time_of_search(campaign::Store& store, const SearchTime& time) {
  store.set_meta(time_of_search, std::to_string(time.evaluations) + ' ' + config::real_text(time.seconds));
}

void stored_tuning(const campaign::Store& store, const study::TuningPlan& plan, study::TuningRecord& record,
                   const std::function<void(std::uint64_t row, const campaign::Decided& decided)>& each) {
  study::TuningHooks hooks;
  const std::optional<std::uint64_t> ended = stored_end_of_search(store);
  hooks.out_of_time = [ended](std::uint64_t evaluations) { return ended && evaluations >= *ended; };
  const campaign::Metrics metrics = metrics_wanted(plan);
  hooks.play = [&](const study::MatchList& list, const study::TakeMatch& take) {
    std::vector<std::string> keys;
    for (const campaign::Store::Fixture& fixture : list.fixtures) keys.push_back(fixture.key);
    const std::vector<std::int64_t> numbers = store.numbers(keys);
    for (std::uint64_t i = 0; i < list.matches.size(); ++i) {
      const study::MatchList::Match& match = list.matches[i];
      const std::uint64_t row = list.first_row + i;
      const auto decided =
          store.find(static_cast<std::int64_t>(row) + 1, {numbers[match.fixture], match.seed}, metrics);
      if (!decided) throw NotPlayed();
      if (each) each(row, *decided);
      if (!take(i, *decided)) return;
    }
  };
  try {
    study::tune(plan, hooks, record);
  } catch (const NotPlayed&) {
    // The record holds what there is.
  } catch (const study::TuningError&) {
    // As when it was played: nothing more came of it.
  }
}

}  // namespace regista::cli
