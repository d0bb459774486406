// SPDX-License-Identifier: MIT
#include "study/tuning/pair_batch.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "plugin/shared_object.hpp"

namespace regista::study {
namespace {

// Adds the settings of the tuned team, which plays on `side`, and the hash of its document to a job.
campaign::Job with_values(campaign::Job job, std::size_t side, const std::vector<std::string>& settings,
                          const std::string& document_hash) {
  const std::string own = side == 0 ? "home." : "away.";
  for (const std::string& each : settings) job.overrides.push_back(own + each);
  std::vector<campaign::Input>& inputs = side == 0 ? job.home_inputs : job.away_inputs;
  inputs.front().hash = document_hash;  // the document is the first of campaign::team_inputs
  return job;
}

// The factor that turns the difference of two teams' values into one team's advantage over an equal opponent. If the
// values have a fixed sum, the difference contains the advantage twice, so the factor is 1/2.
double share_of_difference(const std::string& measure) {
  return measure == "goal_difference" || measure == "points" ? 0.5 : 1.0;
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
  std::vector<std::size_t> used, places;  // used: scenes by first use; places[pair]: index into `used`
  for (std::uint64_t pair = 0; pair < pairs.count; ++pair) {
    // The seed draws the scenes of a verification, because it may stop at any pair.
    const std::size_t scene = pairs.stage == TuningStage::verification
                                  ? drawn_opening(pairs.seed(pair), scenes)
                                  : static_cast<std::size_t>((pairs.first + pair) % scenes);
    const auto found = std::ranges::find(used, scene);
    places.push_back(static_cast<std::size_t>(found - used.begin()));
    if (found == used.end()) used.push_back(scene);
  }
  for (const ParameterValues& values : candidates) {
    const std::string hash = plugin::content_hash(document.with(values));
    const std::vector<std::string> settings = settings_of(plan_, values);
    for (const TuningOpponent& opponent : opponents_) {
      for (const std::size_t side : {0u, 1u}) {
        for (const std::size_t scene : used) {
          campaign::Job job = with_values(opponent.jobs[side], side, settings, hash);
          if (!plan_.openings.empty()) start_from(plan_.openings[scene], job);
          round_.fixtures.push_back(fixture_of(std::move(job)));
        }
      }
    }
  }
  const std::size_t fixtures = 2 * opponents_.size() * candidates.size();
  for (std::uint64_t pair = 0; pair < pairs.count; ++pair) {
    for (std::size_t each = 0; each < fixtures; ++each) {
      places_.push_back({each * used.size() + places[static_cast<std::size_t>(pair)], pairs.seed(pair)});
    }
  }
  round_.matches = places_.size();
  round_.at = [this](std::uint64_t index) { return std::optional(places_[index]); };
  round_.job = [this](std::uint64_t index) {
    campaign::Job out = round_.fixtures[places_[index].fixture].job;
    out.seed = places_[index].seed;
    return out;
  };
  // Candidates differ only in numbers, so the engine plays only the first match of the tuning twice.
  round_.first_of_pairing = [this](std::uint64_t index) { return round_.first_row + index == 0; };
}

bool PairBatch::take(const campaign::MatchResult& decided, ForfeitList& forfeits, MatchRemarks& remarks) {
  assert(next_ < places_.size());
  const std::size_t side = next_ % 2, opponent = next_ / 2 % opponents_.size(),
                    candidate = next_ / 2 / opponents_.size() % scores_.size();
  remarks.take(round_.first_row + next_, decided);
  if (decided.set_aside()) broken_ = true;
  if (!decided.metrics.empty()) {
    if (const auto packets = short_games_.of(decided.metrics)) packets_[candidate].add((*packets)[side]);
  }
  if (decided.failure) {
    const bool own = static_cast<std::size_t>(decided.failure->side) == side;
    const std::size_t other = head_to_head_ ? plan_.opponents.size() : opponent;
    forfeits.add(own ? 0 : other + 1, *decided.failure, round_.first_row + next_);
    if (own) failed_[candidate] = true;
  }
  ++next_;
  if (side == 0) {
    home_ = decided;
    return false;
  }
  const TuningOpponent& against = opponents_[opponent];
  if (home_.set_aside() || decided.set_aside())
    sum_ = no_value;  // NaN stays NaN in later sums
  else
    sum_ += against.weight * (score(decided, false) - (head_to_head_ ? score(decided, true) : 0.0));
  if (opponent + 1 < opponents_.size()) return false;
  // Rounding may make the sum of the weights differ from 1.
  scores_[candidate].push_back(bounds_ ? std::clamp(sum_, bounds_->low, bounds_->high) : sum_);
  unplayed_[candidate].push_back(broken_);
  if (broken_) ++unplayed_pairs_;
  sum_ = 0.0;
  broken_ = false;
  if (candidate + 1 < scores_.size()) return false;
  ++pairs_done_;
  return true;
}

double PairBatch::score(const campaign::MatchResult& away, bool of_opponent) const {
  const int at_home = of_opponent ? 1 : 0;  // this team's side in the first match
  // A team that forfeits has lost; its other numbers are unknown. A forfeit of the opponent gives the team no score.
  const auto forfeited_by = [](const campaign::MatchResult& match, int side) {
    return match.failure && match.failure->side == side;
  };
  if (forfeited_by(home_, 1 - at_home) || forfeited_by(away, at_home)) return no_value;
  const bool forfeited = home_.failure || away.failure;
  std::optional<MatchMeasures> first, second;
  double sum = 0.0;
  for (const ObjectiveTerm& term : plan_.objective.terms) {
    const auto a = measure_of_score(term.measure, home_, at_home),
               b = measure_of_score(term.measure, away, 1 - at_home);
    double value = no_value;
    if (a) {
      const double limit = term.measure == "goal_difference" ? plan_.most_goals : HUGE_VAL;
      value = pair_in_unit(term.measure, std::clamp(*a, -limit, limit) + std::clamp(*b, -limit, limit), 0.0);
    } else if (!forfeited) {
      if (!first) first.emplace(home_, at_home);
      if (!second) second.emplace(away, 1 - at_home);
      value = pair_in_unit(
          term.measure, first->value(term.measure).value_or(no_value) + second->value(term.measure).value_or(no_value),
          first->playing_seconds() + second->playing_seconds());
    }
    sum += term.weight * value * (head_to_head_ ? share_of_difference(term.measure) : 1.0);
  }
  return score_of(plan_.objective, sum);
}

void play_batch(const MatchSource& source, PairBatch& batch, const std::function<bool()>& after_pair) {
  MatchTally& tally = source.tally;
  Round& round = batch.round();
  round.first_row = tally.matches;
  tally.matches += round.matches;
  round.take = [&](std::uint64_t, const campaign::MatchResult* decided) {  // all matches are wanted
    ++tally.taken;
    const std::uint64_t unplayed = batch.unplayed_pairs();
    const bool pair = batch.take(*decided, tally.forfeits, tally.remarks);
    tally.unplayed_pairs += batch.unplayed_pairs() - unplayed;
    return !pair || !after_pair || after_pair();
  };
  source.play(round);
}

PlayedScore played_score(const TuningPlan& plan, const PairBatch& batch, std::size_t candidate, double worst) {
  PlayedScore out{mean_of(batch.scores(candidate), plan.confidence()), batch.failed(candidate), 0.0};
  if (out.failed) {
    const std::optional<ScoreBounds> bounds = score_bounds(plan);
    out.counted = bounds ? bounds->low : worst;
  } else if (out.score.pairs == 0) {
    // If opponents forfeited or the metric is missing, nothing speaks for the values: the score is the worst so far.
    out.counted = std::isfinite(worst) ? worst : 0.0;
  } else {
    out.counted = out.score.mean;
  }
  return out;
}

double worst_of(const PairBatch& batch, std::size_t candidates, double worst) {
  for (std::size_t i = 0; i < candidates; ++i) {
    for (const double each : batch.scores(i)) {
      if (!std::isnan(each)) worst = std::min(worst, each);
    }
  }
  return worst;
}

}  // namespace regista::study
