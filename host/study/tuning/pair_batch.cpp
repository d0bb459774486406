// SPDX-License-Identifier: MIT
#include "study/tuning/pair_batch.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>
#include <string>

#include "campaign/inputs.hpp"
#include "match/side.hpp"
#include "plugin/content_hash.hpp"
#include "study/measure.hpp"

namespace regista::study {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

// A match as it is played with these values: the tuned team stands on `side`.
campaign::Job with_values(campaign::Job job, std::size_t side, const std::vector<std::string>& settings,
                          const std::string& document_hash) {
  const std::string own(match::name(side == 0 ? match::Side::home : match::Side::away));
  for (const std::string& each : settings) job.overrides.push_back(own + '.' + each);
  std::vector<campaign::Input>& inputs = side == 0 ? job.home_inputs : job.away_inputs;
  inputs.front().hash = document_hash;  // campaign::team_inputs begins with the document
  return job;
}

}  // namespace

PairBatch::PairBatch(const TuningPlan& plan, const TunedDocument& document,
                     const std::vector<ParameterValues>& candidates, const PairRange& pairs, bool head_to_head)
    : plan_(plan),
      opponents_(head_to_head ? std::span(&plan.base, 1) : std::span(plan.opponents)),
      head_to_head_(head_to_head),
      bounds_(head_to_head ? std::nullopt : score_bounds(plan)),
      scores_(candidates.size()),
      unplayed_(candidates.size()),
      packets_(candidates.size()),
      failed_(candidates.size(), false) {
  const std::size_t scenes = std::max<std::size_t>(plan.openings.size(), 1);
  std::vector<std::size_t> used, places;  // scenes, in the order of their first use; by pair: place among them
  for (std::uint64_t pair = 0; pair < pairs.count; ++pair) {
    // A verification may stop at any pair.
    const std::size_t scene = pairs.stage == TuningStage::verification
                                  ? drawn_opening(pairs.seed(pair), scenes)
                                  : static_cast<std::size_t>((pairs.first + pair) % scenes);
    const auto found = std::ranges::find(used, scene);
    places.push_back(static_cast<std::size_t>(found - used.begin()));
    if (found == used.end()) used.push_back(scene);
  }
  add_fixtures(document, candidates, used);
  const std::size_t fixtures = 2 * opponents_.size() * candidates.size();
  for (std::uint64_t pair = 0; pair < pairs.count; ++pair) {
    for (std::size_t each = 0; each < fixtures; ++each) {
      list_.matches.push_back({each * used.size() + places[static_cast<std::size_t>(pair)], pairs.seed(pair)});
    }
  }
}

void PairBatch::add_fixtures(const TunedDocument& document, const std::vector<ParameterValues>& candidates,
                             const std::vector<std::size_t>& scenes) {
  for (const ParameterValues& values : candidates) {
    const std::string hash = plugin::content_hash(document.with(values));
    const std::vector<std::string> settings = settings_of(plan_, values);
    for (const TuningOpponent& opponent : opponents_) {
      for (const std::size_t side : {0u, 1u}) {
        const campaign::Job job = with_values(opponent.jobs[side], side, settings, hash);
        for (const std::size_t scene : scenes) {
          campaign::Store::Fixture& fixture = list_.fixtures.emplace_back();
          fixture.job = job;
          if (!plan_.openings.empty()) start_from(plan_.openings[scene], fixture.job);
          fixture.key =
              campaign::fixture_key(fixture.job.home_inputs, fixture.job.away_inputs, fixture.job.common_inputs);
        }
      }
    }
  }
}

bool PairBatch::take(const campaign::Decided& decided, ForfeitList& forfeits, MatchRemarks& remarks) {
  assert(next_ < list_.matches.size());
  const std::size_t side = next_ % 2, opponent = next_ / 2 % opponents_.size(),
                    candidate = next_ / 2 / opponents_.size() % scores_.size();
  remarks.take(list_.first_row + next_, decided);
  if (decided.set_aside()) broken_ = true;
  if (!decided.metrics.empty()) {
    if (const auto packets = short_games_.of(decided.metrics)) packets_[candidate].add((*packets)[side]);
  }
  if (decided.failure) {
    const bool own = static_cast<std::size_t>(decided.failure->side) == side;
    const std::size_t other = head_to_head_ ? plan_.opponents.size() : opponent;
    forfeits.add(own ? 0 : other + 1, *decided.failure, list_.first_row + next_);
    if (own) failed_[candidate] = true;
  }
  ++next_;
  if (side == 0) {
    home_ = decided;
    return false;
  }
  const TuningOpponent& against = opponents_[opponent];
  if (home_.set_aside() || decided.set_aside())
    sum_ = nothing;  // and stays so
  else
    sum_ += against.weight * (score(decided, false) - (head_to_head_ ? score(decided, true) : 0.0));
  if (opponent + 1 < opponents_.size()) return false;
  // Weights sum up to 1 only nearly.
  scores_[candidate].push_back(bounds_ ? std::clamp(sum_, bounds_->low, bounds_->high) : sum_);
  unplayed_[candidate].push_back(broken_);
  if (broken_) ++unplayed_pairs_;
  sum_ = 0.0;
  broken_ = false;
  if (candidate + 1 < scores_.size()) return false;
  ++pairs_done_;
  return true;
}

// Of measures whose sum over both teams is the same in every match, half the difference between the teams is what one
// of them has more than an equal one would.
static double share_of_difference(const std::string& measure) {
  return measure == "goal_difference" || measure == "points" ? 0.5 : 1.0;
}

double PairBatch::score(const campaign::Decided& away, bool of_opponent) const {
  const int at_home = of_opponent ? 1 : 0;  // this team's side in the first of the two matches
  // Whoever forfeits has lost, and what else it would have done is not known; that its opponent forfeits is no merit.
  const auto forfeited_by = [](const campaign::Decided& match, int side) {
    return match.failure && match.failure->side == side;
  };
  if (forfeited_by(home_, 1 - at_home) || forfeited_by(away, at_home)) return nothing;
  const bool forfeited = home_.failure || away.failure;
  std::optional<MatchMeasures> first, second;
  double sum = 0.0;
  for (const ObjectiveTerm& term : plan_.objective.terms) {
    const auto a = measure_of_score(term.measure, home_, at_home),
               b = measure_of_score(term.measure, away, 1 - at_home);
    double value = nothing;
    if (a) {
      const double limit = term.measure == "goal_difference" ? plan_.most_goals : HUGE_VAL;
      value = pair_in_unit(term.measure, std::clamp(*a, -limit, limit) + std::clamp(*b, -limit, limit), 0.0);
    } else if (!forfeited) {
      if (!first) first.emplace(home_, at_home);
      if (!second) second.emplace(away, 1 - at_home);
      value = pair_in_unit(term.measure,
                           first->value(term.measure).value_or(nothing) + second->value(term.measure).value_or(nothing),
                           first->playing_seconds() + second->playing_seconds());
    }
    sum += term.weight * value * (head_to_head_ ? share_of_difference(term.measure) : 1.0);
  }
  return score_of(plan_.objective, sum);
}

}  // namespace regista::study
