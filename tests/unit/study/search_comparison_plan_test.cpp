// SPDX-License-Identifier: MIT
#include "study/tuning/search_comparison_plan.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <random>
#include <stdexcept>

#include "config/json.hpp"
#include "config/sanitized.hpp"
#include "study/plan_names.hpp"
#include "tuning_fixture.hpp"

namespace regista::study {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using Json = nlohmann::ordered_json;

SearchComparisonPlan every_value() {
  SearchComparisonPlan out{tuning_of(3, 2), {Algorithm::sbplx, Algorithm::sep_cma_es}, 9};
  out.tuning.search_pairs = 77;
  out.tuning.pairs = 3;
  out.tuning.population = 11;
  out.tuning.folder = "/tmp";
  out.tuning.file = "t.yaml";
  return out;
}

// As the program wrote it before a comparison was a study of its own.
std::string as_before(const SearchComparisonPlan& plan) {
  Json out = Json::parse(to_json(plan.tuning));
  out["compared"] = Json::array();
  for (const Algorithm each : plan.algorithms) out["compared"].push_back(name(each));
  out["repeats"] = plan.repeats;
  return out.dump();
}

TEST(SearchComparisonPlan, IsReadAsItWasWritten) {
  const SearchComparisonPlan plan = every_value();
  const SearchComparisonPlan read = search_comparison_plan_from_json(to_json(plan));
  EXPECT_EQ(to_json(read), to_json(plan));
  EXPECT_EQ(read.algorithms, plan.algorithms);
  EXPECT_EQ(read.repeats, 9u);
  EXPECT_THAT(differences(plan, read), IsEmpty());
  EXPECT_EQ(study_of(to_json(plan)), "search_comparison");
}

TEST(SearchComparisonPlan, OneThatWasWrittenAsATuningIsReadAsAComparisonAndNeverAsATuning) {
  const SearchComparisonPlan plan = every_value();
  EXPECT_EQ(study_of(as_before(plan)), "search_comparison");
  EXPECT_EQ(to_json(search_comparison_plan_from_json(as_before(plan))), to_json(plan));
  EXPECT_THROW(tuning_plan_from_json(as_before(plan)), std::invalid_argument);
  Json damaged = Json::parse(as_before(plan));
  for (const Json& each : {Json("spsa"), Json(nullptr), Json{"spas"}, Json{1}}) {
    damaged["compared"] = each;
    EXPECT_THROW(tuning_plan_from_json(damaged.dump()), std::invalid_argument) << each;
    EXPECT_THROW(search_comparison_plan_from_json(damaged.dump()), std::invalid_argument) << each;
  }
}

// A tuning that the program wrote before has an empty list.
TEST(SearchComparisonPlan, ATuningIsNone) {
  const TuningPlan tuning = tuning_of(2, 1);
  Json before = Json::parse(to_json(tuning));
  before["compared"] = Json::array();
  before["repeats"] = 1;
  for (const std::string& each : {to_json(tuning), before.dump()}) {
    EXPECT_EQ(study_of(each), "tuning");
    EXPECT_EQ(to_json(tuning_plan_from_json(each)), to_json(tuning));
    try {
      search_comparison_plan_from_json(each);
      FAIL();
    } catch (const std::invalid_argument& error) {
      EXPECT_STREQ(error.what(), "these are results of another study");
    }
  }
}

// The document's own algorithm is not run: whether the budget is enough for it does not matter.
TEST(SearchComparisonPlan, TheBudgetIsEnoughForEachAlgorithm) {
  SearchComparisonPlan plan{tuning_of(3, 1, Algorithm::isres), {Algorithm::random_search}, 1};
  plan.tuning.search_pairs = 4;
  EXPECT_THROW(tuning_plan_from_json(to_json(plan.tuning)), std::invalid_argument);
  EXPECT_NO_THROW(search_comparison_plan_from_json(to_json(plan)));
  plan.algorithms.push_back(Algorithm::isres);
  EXPECT_THROW(search_comparison_plan_from_json(to_json(plan)), std::invalid_argument);
}

TEST(SearchComparisonPlan, WhatNoComparisonHasIsRefused) {
  const auto refused = [](const char* what, const std::function<void(SearchComparisonPlan&)>& change) {
    SearchComparisonPlan plan = every_value();
    change(plan);
    EXPECT_THROW(search_comparison_plan_from_json(to_json(plan)), std::invalid_argument) << what;
  };
  refused("no algorithm", [](SearchComparisonPlan& p) { p.algorithms.clear(); });
  refused("no repeats", [](SearchComparisonPlan& p) { p.repeats = 0; });
  refused("many repeats", [](SearchComparisonPlan& p) { p.repeats = 1025; });
  refused("no tuning", [](SearchComparisonPlan& p) { p.tuning.opponents.clear(); });
}

TEST(SearchComparisonPlan, EveryTruncationIsRefusedAndAnyByteMayBeDamaged) {
  std::mt19937 random(1);
  for (const std::string& whole : {to_json(every_value()), as_before(every_value())}) {
    for (std::size_t length = 0; length < whole.size(); length += sanitized ? 9 : 1) {
      EXPECT_THROW(search_comparison_plan_from_json(whole.substr(0, length)), std::invalid_argument) << length;
    }
    for (int round = 0; round < (sanitized ? 300 : 3000); ++round) {
      std::string text = whole;
      const std::size_t at = std::uniform_int_distribution<std::size_t>(0, text.size() - 1)(random);
      static constexpr std::string_view bytes = "0123456789-+eE.\"{}[],:tfn \x00\xff";
      text[at] = bytes[std::uniform_int_distribution<std::size_t>(0, bytes.size() - 1)(random)];
      try {
        const SearchComparisonPlan plan = search_comparison_plan_from_json(text);
        EXPECT_GT(most_matches(plan), 0u);
      } catch (const std::invalid_argument&) {
      }
    }
  }
}

TEST(SearchComparisonPlan, WhatHasChangedIsNamed) {
  const SearchComparisonPlan before = every_value();
  SearchComparisonPlan now = every_value();
  now.algorithms.pop_back();
  EXPECT_THAT(differences(before, now), ElementsAre("--compare: was sbplx, sep_cma_es, now sbplx"));
  now = every_value();
  now.repeats = 8;
  EXPECT_THAT(differences(before, now), ElementsAre("--repeats: was 9, now 8"));
  now = every_value();
  now.tuning.seed = 1;
  EXPECT_THAT(differences(before, now), ElementsAre("the seed: was 7, now 1"));
}

TEST(SearchComparisonPlan, Budget) {
  const SearchComparisonPlan plan = every_value();  // 18 runs, two opponents
  EXPECT_EQ(plan.runs(), 18u);
  EXPECT_EQ(most_search_matches(plan), 18u * 77 * 4);
  EXPECT_EQ(judging_matches(plan), 19u * 30 * 4);
  EXPECT_EQ(most_matches(plan), most_search_matches(plan) + judging_matches(plan));
}

}  // namespace
}  // namespace regista::study
