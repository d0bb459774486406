// SPDX-License-Identifier: MIT
#include "study/objective_test.hpp"

namespace regista::study {
namespace {

Found found(statistics::BettingTest::Finding finding) {
  switch (finding) {
    case statistics::BettingTest::Finding::none:
      break;
    case statistics::BettingTest::Finding::above:
      return Found::first_more;
    case statistics::BettingTest::Finding::below:
      return Found::second_more;
  }
  return Found::open;
}

}  // namespace

PairResult all_for_second(double most_goals) { return {statistics::PairOutcome::two_losses, -most_goals, -1}; }

PairResult all_for_first(double most_goals) { return {statistics::PairOutcome::two_wins, most_goals, 1}; }

void add(ObjectiveTest& test, const PairResult& pair) {
  if (auto* const scores = std::get_if<ScoreSequence>(&test)) {
    scores->add(pair.outcome);
  } else if (auto* const goals = std::get_if<statistics::BettingGrid>(&test)) {
    goals->add(pair.goals);
  } else if (pair.sign) {
    std::get<statistics::BettingTest>(test).add(*pair.sign);
  }
}

Found found_by(const ScoreSequence& test) {
  switch (test.verdict()) {
    case statistics::Verdict::inconclusive:
      break;
    case statistics::Verdict::accept_h0:
      return Found::h0;
    case statistics::Verdict::accept_h1:
      return Found::h1;
  }
  return Found::open;
}

Found found_by(const statistics::BettingGrid& goals) { return found(goals.finding(0.0)); }

Found found_by(const statistics::BettingTest& signs) { return found(signs.finding()); }

Found found_by(const ObjectiveTest& test) {
  return std::visit([](const auto& each) { return found_by(each); }, test);
}

}  // namespace regista::study
