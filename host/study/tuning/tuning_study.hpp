// SPDX-License-Identifier: MIT
// A tuning is a study, and each of its batches of matches is a round. Its stages are: search (pair_search.hpp),
// selection of the best points on other seeds, verification against the base team on held-out seeds, and slices around
// the tuned point. All stages depend only on the plan and the results: neither the number of workers nor reading the
// matches from a file instead of playing them changes anything.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "statistics/anytime_valid_tests.hpp"
#include "statistics/moments.hpp"
#include "study/measure.hpp"
#include "study/paired_estimates.hpp"
#include "study/study.hpp"
#include "study/tuning/pair_batch.hpp"
#include "study/tuning/pair_search.hpp"
#include "study/tuning/tuning_plan.hpp"

namespace regista::study {

// --- The verification tests whether candidates are better than the base team, pair by pair on held-out seeds. The test
// is a sequential test of a difference of 0, valid after every pair. Holm's method adjusts the p-values for the number
// of candidates. If differences have bounds, the test can bet on their mean, for any distribution. Otherwise, the test
// assumes symmetric differences, which gives a finding sooner (statistics/anytime_valid_tests.hpp).

// Whether a candidate beats the base team. undecided: no decision yet. prevented: unplayed pairs prevent a decision.
enum class VerifiedAs { undecided, better, worse, prevented };

// The scores of one candidate and of the base team.
class ScoreDifference {
 public:
  // deviation: the expected standard deviation of a difference. alpha: the level of the test. several: number of
  // simultaneous intervals. widest: the largest possible difference; nullopt: the test does not bet, but assumes
  // symmetry. bound: the largest possible difference, also for a test by symmetry; nullopt: there is no bound.
  ScoreDifference(double deviation, double alpha, std::size_t several, std::optional<double> widest,
                  std::optional<double> bound);

  void add(double candidate, double base);
  // Adds a pair that could not be played. The main test does not count it. Two further tests count all such pairs as
  // the largest possible difference: one test for the base team, one test for the candidate. Without a bound, such a
  // pair could have shown any difference, so no finding is possible any more.
  void add_unplayed();

  const statistics::Moments& candidate() const { return candidate_; }
  const statistics::Moments& base() const { return base_; }
  const statistics::Moments& difference() const { return counted_.seen; }
  statistics::Estimate estimate() const;     // mean difference; its interval is valid at all times
  double p() const { return counted_.p(); }  // p-value of "no difference": two-sided, not adjusted
  bool candidate_more() const { return counted_.candidate_more(); }  // the evidence is stronger for the candidate
  std::uint64_t unplayed_pairs() const { return unplayed_; }
  // The largest p-value of the three tests (see add_unplayed()); 1 if the tests do not all find the same side.
  double p_either_way() const;

 private:
  struct OnMean {
    statistics::BettingTest test;
    statistics::BettingGrid sequence;
  };
  struct Evidence {
    std::variant<statistics::SymmetricTest, OnMean> test;
    statistics::Moments seen;  // differences

    void add(double difference);
    double p() const;
    bool candidate_more() const;
  };
  statistics::Moments candidate_, base_;
  Evidence counted_;
  std::optional<double> bound_;
  std::optional<std::array<Evidence, 2>> either_way_;  // unplayed pairs: [0] for the base team, [1] for the candidate
  std::uint64_t unplayed_ = 0;
};

// The verification of all candidates. The test is two-sided. The probability of one or more false findings is at most 1
// - confidence. The intervals hold for all candidates together.
class Verification {
 public:
  // deviation: the expected standard deviation of a candidate's score over pairs, above 0. The caller takes it from
  // earlier stages. widest, bound: see ScoreDifference.
  Verification(std::size_t candidates, double confidence, double deviation, std::optional<double> widest = {},
               std::optional<double> bound = {});

  // Adds the scores of a pair. A match without a score gives NaN, and the candidate's pair is then left out. If
  // candidates play the base team (head to head), the scores are differences already, and `base` is 0. unplayed: by
  // candidate, whether its pair or the base team's pair could not be played; empty: all pairs were played.
  void add(double base, std::span<const double> candidates, const std::vector<bool>& unplayed = {});

  std::uint64_t pairs() const { return pairs_; }
  const std::vector<ScoreDifference>& of() const { return of_; }  // by candidate
  std::vector<double> adjusted() const;                           // by candidate: p_either_way(), adjusted by Holm
  std::uint64_t unplayed_pairs() const { return unplayed_; }      // pairs that a candidate or base team did not play
  std::vector<VerifiedAs> findings() const;
  // Returns whether the test has decided on every candidate, or unplayed pairs prevent a decision for good.
  bool decided() const;

 private:
  double alpha_;
  std::vector<ScoreDifference> of_;
  std::optional<double> bound_;
  std::uint64_t pairs_ = 0, unplayed_ = 0;
};

// --- The stage "selection" plays new matches with the points that a search recommends, the finalists. All finalists
// play the same new pairs. The best finalists go into the verification.

struct Finalist {
  ParameterValues values;
  // The score over all pairs of the search; nullopt if the search did not play these values (for example a mean).
  std::optional<PlayedScore> seen;
  PlayedScore selected;
};

// Plays the selection and returns its finalists: all different, best first. Throws what the source's `play` throws.
std::vector<Finalist> select_finalists(const MatchSource& source, const SearchFindings& found);

// Indices of the finalists that the verification plays: the best finalists that are better than the base team.
std::vector<std::size_t> candidates_among(const TuningPlan& plan, const std::vector<Finalist>& finalists);

// The expected standard deviation of a score over pairs: the selection's deviation; if 0, the search's; if also 0, 1.
double deviation_of(const std::vector<Finalist>& finalists, const SearchScores& scores);

// The first seed of the verification of the chosen values. The seed is a hash of the plan's seed, objective, opponents
// and these values. So no choice is judged on seeds that favoured an earlier choice. Below 2^31.
std::uint64_t drawn_seed(const TuningPlan& plan, const TunedDocument& document,
                         const std::vector<ParameterValues>& chosen);

// --- A slice shows how the score changes if one parameter of the tuned point changes. All points play the same pairs.

struct SlicePoint {
  double value = 0.0;       // value of the parameter
  MeanEstimate score;       // score at this value; larger is better
  MeanEstimate difference;  // score minus the tuned point's score, pair by pair
};

struct Slice {
  std::size_t parameter = 0;  // index into the plan's parameters
  std::vector<SlicePoint> points;
  // The standard deviation of the true score over the points, in the unit of the objective. The estimate uses the
  // variation of the means beyond chance; 0 if the means vary no more than by chance.
  double importance = 0.0;
  // p-value of "the parameter does nothing": two-way analysis of variance (points, pairs); nullopt for too few pairs.
  std::optional<double> p;
};

// The values of a slice besides the tuned value: no value twice, spread over the range, at most slice_points().
std::vector<double> slice_values(const TuningPlan& plan, const ParameterValues& tuned, std::size_t parameter);

// Makes a slice. scores: by point, in the order of `values`, then by pair. tuned: the tuned point's scores, by pair.
Slice slice_of(std::size_t parameter, double tuned_value, std::span<const double> values,
               std::span<const std::vector<double>> scores, const std::vector<double>& tuned, double confidence);

// For each free parameter, plays the tuned point with other values of that parameter. The slice of the largest
// importance is first. Returns no slices if the plan's slice_points() is 0. Throws what the source's `play` throws.
std::vector<Slice> slices_around(const MatchSource& source, const ParameterValues& tuned);

// The findings of a tuning so far, stage after stage.
struct TuningRecord {
  explicit TuningRecord(const TuningPlan& plan) : verification(0, plan.confidence(), 1.0), tally(plan) {}

  std::optional<TuningStage> stage = TuningStage::search;  // current stage; nullopt: the tuning is complete
  std::vector<SearchStep> trace;
  std::string ended;                            // why the search ended
  std::vector<Finalist> finalists;              // best first; empty until the selection is complete
  Verification verification;                    // scores of `candidates`
  std::vector<std::size_t> candidates;          // indices of the finalists that are verified
  std::vector<bool> candidate_failed;           // whether a candidate forfeited a match of the verification
  std::vector<PacketsSpent> candidate_packets;  // packets of each candidate in the verification
  std::vector<Slice> slices;                    // largest importance first
  MatchTally tally;

  // The verification's finding about a candidate. A candidate that forfeited a match of this stage is never better.
  VerifiedAs finding(std::size_t candidate) const;
  // The index of the finalist that the tuning keeps: the first candidate that was found better, else the first
  // candidate. nullopt without candidates: before the selection ends, or if no finalist is better than the base team.
  std::optional<std::size_t> tuned() const;
  bool verified() const { return better().has_value(); }

 private:
  std::optional<std::size_t> better() const;  // the first candidate that was found better
};

// Verifies record.candidates. The candidates and the base team play pair by pair on held-out seeds, until the test is
// decided or the pairs are used up. deviation: the expected standard deviation of a candidate's score over pairs, above
// 0. Updates the record after every pair. Throws what the source's `play` throws.
void verify_candidates(const MatchSource& source, double deviation, TuningRecord& record);

// Runs all stages and fills the record. out_of_time: ends the search; may be empty. Throws TuningError if the base team
// forfeits or has no number for the objective, and what `play` throws.
void tune(const TuningPlan& plan, const PlayRound& play, const OutOfTime& out_of_time, TuningRecord& record);

class TuningStudy final : public Study {
 public:
  // out_of_time: ends the search; may be empty. The plan must outlive this object.
  TuningStudy(const TuningPlan& plan, OutOfTime out_of_time)
      : plan_(plan), out_of_time_(std::move(out_of_time)), record_(plan) {}

  const char* what() const override { return "tuning"; }
  std::string unplayable() const override { return record_.tally.unplayable(); }
  std::uint64_t most_matches() const override { return study::most_matches(plan_); }
  std::uint64_t counted() const override { return record_.tally.taken; }
  campaign::Metrics metrics() const override { return wanted_metrics(plan_); }
  campaign::Limits limits() const override { return plan_.limits(); }
  const std::string& folder() const override { return plan_.folder; }
  std::string plan() const override { return to_json(plan_); }
  std::vector<std::string> differences(const std::string& before) const override {
    return study::differences(tuning_plan_from_json(before), plan_);
  }
  void run(const PlayRound& play) override { tune(plan_, play, out_of_time_, record_); }

  const TuningRecord& record() const { return record_; }

 private:
  const TuningPlan& plan_;
  OutOfTime out_of_time_;
  TuningRecord record_;
};

}  // namespace regista::study
