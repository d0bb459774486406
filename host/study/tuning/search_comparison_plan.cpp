// SPDX-License-Identifier: MIT
#include "study/tuning/search_comparison_plan.hpp"

#include <algorithm>
#include <iterator>
#include <stdexcept>

#include "study/tuning/tuning_plan_fields.hpp"

namespace regista::study {
namespace {

constexpr int comparison_plan_version = 1;
constexpr int comparison_plan_version_of_before = 1;  // of a tuning that held a comparison

bool sound(const SearchComparisonPlan& plan) {
  return sound(plan.tuning) && !plan.algorithms.empty() && 1 <= plan.repeats && plan.repeats <= 1024 &&
         std::ranges::all_of(plan.algorithms, [&](Algorithm each) { return can_search(plan.tuning, each); });
}

}  // namespace

template <Like<SearchComparisonPlan> Plan, class Visit>
static void fields(Plan& plan, Visit& visit) {
  visit("algorithms", plan.algorithms, "--compare");
  visit("repeats", plan.repeats, "--repeats");
  visit("tuning", plan.tuning);
}

std::uint64_t most_search_matches(const SearchComparisonPlan& plan) {
  return plan.runs() * plan.tuning.search_pairs * plan.tuning.matches_of_pair();
}

std::uint64_t judging_matches(const SearchComparisonPlan& plan) {
  return (plan.runs() + 1) * plan.tuning.verification_pairs * plan.tuning.matches_of_pair();  // one more: the base team
}

std::uint64_t most_matches(const SearchComparisonPlan& plan) {
  return most_search_matches(plan) + judging_matches(plan);
}

std::string to_json(const SearchComparisonPlan& plan) {
  return plan_text(search_comparison_study, comparison_plan_version, plan);
}

SearchComparisonPlan search_comparison_plan_from_json(const std::string& text) {
  if (!holds_comparison_of_before(PlanJson::parse(text, nullptr, false))) {
    return plan_of<SearchComparisonPlan>(search_comparison_study, comparison_plan_version, text,
                                         [](const SearchComparisonPlan& plan) { return sound(plan); });
  }
  return read_plan(text, tuning_study, comparison_plan_version_of_before, [](const PlanJson& json) {
    SearchComparisonPlan plan;
    read(json, plan.tuning);
    read(json.at("compared"), plan.algorithms);
    read(json.at("repeats"), plan.repeats);
    if (!sound(plan)) throw std::out_of_range("a number that no comparison has");
    return plan;
  });
}

std::vector<std::string> differences(const SearchComparisonPlan& before, const SearchComparisonPlan& now) {
  std::vector<std::string> out = differences(before.tuning, now.tuning);
  std::ranges::move(field_differences(before, now), std::back_inserter(out));
  return out;
}

}  // namespace regista::study
