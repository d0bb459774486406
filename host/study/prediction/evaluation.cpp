// SPDX-License-Identifier: MIT
#include "study/prediction/evaluation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numeric>
#include <utility>

#include "match/chance.hpp"
#include "statistics/moments.hpp"
#include "study/prediction/forecast.hpp"

namespace regista::study {
namespace {

constexpr int least_samples = 3;
constexpr double least_change = 0.4;          // m/s
constexpr double sliding_deceleration = 3.6;  // m/s^2

// Errors in increasing order, each with the number of its block. A drawn sample then needs no sorting.
using Ordered = std::vector<std::pair<double, std::size_t>>;

Ordered ordered(std::span<const PairedError> errors, double PairedError::*error) {
  Ordered out;
  for (const PairedError& each : errors) out.emplace_back(each.*error, each.block);
  std::ranges::stable_sort(out, {}, &Ordered::value_type::first);
  return out;
}

// A quantile of a drawn sample: the least error e such that at least `share` of the sample is not larger than e. times:
// how often each block was drawn. total: the number of errors in the sample.
double quantile(const Ordered& errors, double share, const std::vector<std::uint32_t>& times, std::size_t total) {
  const double wanted = share * static_cast<double>(total);
  std::size_t seen = 0;
  for (const auto& [error, block] : errors) {
    seen += times[block];
    if (static_cast<double>(seen) >= wanted) return error;
  }
  return errors.back().first;
}

// The samples of one object, by time.
struct Path {
  std::vector<Sample> samples;
  std::vector<std::size_t> index;  // indices of the samples in the stretch
  std::vector<Sample> observed;
  std::vector<std::size_t> touched;  // indices of samples at which a robot may have touched the ball

  const Sample* nearest(double time, double tolerance) const {
    const auto after = std::ranges::lower_bound(samples, time, {}, &Sample::time);
    const Sample* best = nullptr;
    if (after != samples.begin()) best = &*(after - 1);
    if (after != samples.end() && (best == nullptr || after->time - time < time - best->time)) best = &*after;
    return best != nullptr && std::abs(best->time - time) <= tolerance ? best : nullptr;
  }

  bool rolls_freely(const Sample& from, const Sample& to) const {
    const auto place = [&](const Sample& sample) {
      return static_cast<std::size_t>(std::ranges::lower_bound(samples, sample.time, {}, &Sample::time) -
                                      samples.begin());
    };
    const auto next = std::ranges::lower_bound(touched, place(from));
    return next == touched.end() || *next > place(to);
  }

  // The observations in the `window` seconds that end at `time`.
  std::span<const Sample> recent(double time, double window) const {
    const auto first = std::ranges::lower_bound(observed, time - window, {}, &Sample::time);
    return {first, std::ranges::upper_bound(first, observed.end(), time, {}, &Sample::time)};
  }
};

// This time (s) is long enough to measure a velocity, and at most the time in which a ball crosses a robot.
constexpr double touch_window = 0.1;

std::map<int, Path> paths_of(const Stretch& stretch, const std::vector<bool>& shown) {
  std::map<int, Path> paths;
  for (std::size_t i = 0; i < stretch.samples.size(); ++i) {
    Path& path = paths[stretch.samples[i].object];
    path.samples.push_back(stretch.samples[i]);
    path.index.push_back(i);
    if (shown[i]) path.observed.push_back(stretch.samples[i]);
  }
  if (const auto ball = paths.find(ball_object); ball != paths.end()) {
    const std::vector<bool> free = untouched(ball->second.samples, touch_window);
    for (std::size_t i = 0; i < free.size(); ++i) {
      if (!free[i]) ball->second.touched.push_back(i);
    }
  }
  return paths;
}

struct Start {
  std::size_t index;  // index of the sample in the stretch
  Sample truth;
  Sample last;  // last observed sample
  Eigen::Vector2d velocity;
  const Path* path;
};

std::vector<Start> starts_of(const Stretch& stretch, const std::map<int, Path>& paths,
                             const config::PredictorStudy& study) {
  std::vector<Start> out;
  const auto every = static_cast<std::size_t>(study.questions.every);
  for (const auto& [object, path] : paths) {
    for (std::size_t i = every - 1; i < path.samples.size(); i += every) {
      const Sample& sample = path.samples[i];
      if (!stretch.runs_at(sample.time)) continue;
      const std::span<const Sample> recent = path.recent(sample.time, study.baselines.window);
      const std::optional<Eigen::Vector2d> velocity = fitted_velocity(recent, study.baselines.least);
      if (velocity) out.push_back({path.index[i], sample, recent.back(), *velocity, &path});
    }
  }
  std::ranges::sort(out, {}, &Start::index);  // no two starts have the same index
  return out;
}

// The length of a block of play; errors in one block may share a kick.
constexpr double block_length = 10.0;  // s

double quantile(std::vector<double>& values, double share) {
  if (values.empty()) return 0.0;
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1) + 0.5);
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

Errors errors_of(std::vector<double>& values) { return {quantile(values, 0.5), quantile(values, 0.9)}; }

// The numbers of all starts at one horizon: errors in m, and squared errors relative to the covariance (nees).
struct Tally {
  std::size_t truths = 0;
  std::vector<double> predictor, hold, constant, decayed, nees, untouched_nees;
  std::vector<PairedError> to_decayed;
};

double nees(const Estimate& estimate, const Eigen::Vector2d& truth, double noise) {
  const Eigen::Vector2d error = truth - estimate.position;
  const double xx = estimate.covariance(0, 0) + noise * noise, yy = estimate.covariance(1, 1) + noise * noise;
  const double xy = estimate.covariance(0, 1);
  return (yy * error.x() * error.x() - 2.0 * xy * error.x() * error.y() + xx * error.y() * error.y()) /
         (xx * yy - xy * xy);
}

Consistency consistency_of(std::vector<double>& nees) {
  if (nees.empty()) return {};
  const double count = static_cast<double>(nees.size());
  const auto within = [&](double share) {
    const double limit = -2.0 * std::log1p(-share);  // quantile of chi-square with 2 degrees of freedom
    return static_cast<double>(std::ranges::count_if(nees, [&](double each) { return each <= limit; })) / count;
  };
  const double sum = std::accumulate(nees.begin(), nees.end(), 0.0);
  return {within(0.5), within(0.9), within(0.95), sum / count, quantile(nees, 0.5)};
}

class Scores {
 public:
  explicit Scores(const config::PredictorStudy& study) : study_(study) {}

  void baselines(const Start& start) {
    for (std::size_t h = 0; h < horizon_count; ++h) {
      const Sample* truth = truth_of(start, h);
      if (truth == nullptr) continue;
      const Eigen::Vector2d moved(truth->x - start.last.x, truth->y - start.last.y);
      Tally& tally = tallies[h];
      ++tally.truths;
      tally.hold.push_back(moved.norm());
      tally.constant.push_back((moved - start.velocity * (truth->time - start.last.time)).norm());
      tally.decayed.push_back(decayed_error(start, *truth));
    }
  }

  // Asks the predictor about starts at the same time, in the stretch with this number.
  void predictor(int number, std::span<const Start> starts, Forecaster& forecaster) {
    forecaster.listen(starts.front().index);
    const auto block =
        blocks_.emplace(std::pair(number, std::floor(starts.front().truth.time / block_length)), blocks_.size());
    std::vector<Question> questions;
    for (const Start& start : starts) {
      const std::optional<int> label = forecaster.label_of(start.truth);
      for (std::size_t h = 0; label && h < horizon_count; ++h) {
        if (const Sample* truth = truth_of(start, h)) questions.push_back({truth, h, *label, &start});
      }
    }
    std::ranges::stable_sort(questions, {}, [](const Question& each) { return each.truth->time; });
    for (const Question& each : questions) {
      forecaster.look(each.truth->time - starts.front().truth.time);
      const std::optional<Estimate> estimate = forecaster.estimate(each.label);
      if (!estimate) continue;
      const Eigen::Vector2d place(each.truth->x, each.truth->y);
      Tally& tally = tallies[each.horizon];
      const double error = (place - estimate->position).norm();
      tally.predictor.push_back(error);
      tally.to_decayed.push_back({block.first->second, error, decayed_error(*each.start, *each.truth)});
      const double squared = nees(*estimate, place, study_.camera.noise);
      tally.nees.push_back(squared);
      if (each.truth->object == ball_object && each.start->path->rolls_freely(each.start->last, *each.truth)) {
        tally.untouched_nees.push_back(squared);
      }
    }
  }

  std::array<Tally, horizon_count> tallies;

 private:
  double decayed_error(const Start& start, const Sample& truth) const {
    const Eigen::Vector2d moved(truth.x - start.last.x, truth.y - start.last.y);
    return (moved - decayed(start.velocity, truth.time - start.last.time, study_.baselines)).norm();
  }

  const Sample* truth_of(const Start& start, std::size_t h) const {
    return start.path->nearest(start.truth.time + study_.questions.horizons[h], study_.questions.tolerance);
  }

  struct Question {
    const Sample* truth;
    std::size_t horizon;
    int label;
    const Start* start;
  };
  const config::PredictorStudy& study_;
  std::map<std::pair<int, double>, std::size_t> blocks_;  // key: stretch and time; value: number of the block
};

}  // namespace

std::optional<Eigen::Vector2d> fitted_velocity(std::span<const Sample> samples, int least) {
  if (samples.size() < static_cast<std::size_t>(std::max(least, 2))) return std::nullopt;
  const double count = static_cast<double>(samples.size());
  const double origin = samples.back().time;  // times are large, so sums of differences are more exact
  double time = 0.0;
  Eigen::Vector2d place = Eigen::Vector2d::Zero();
  for (const Sample& each : samples) {
    time += (each.time - origin) / count;
    place += Eigen::Vector2d(each.x, each.y) / count;
  }
  double spread = 0.0;
  Eigen::Vector2d moment = Eigen::Vector2d::Zero();
  for (const Sample& each : samples) {
    const double t = each.time - origin - time;
    spread += t * t;
    moment += t * (Eigen::Vector2d(each.x, each.y) - place);
  }
  if (spread <= 0.0) return std::nullopt;
  return moment / spread;
}

Eigen::Vector2d rolled(const Eigen::Vector2d& velocity, double ahead, double deceleration) {
  const double speed = std::sqrt(velocity.squaredNorm());
  if (speed <= 0.0) return Eigen::Vector2d::Zero();
  const double rolls = std::min(ahead, speed / deceleration);
  return velocity / speed * (speed * rolls - 0.5 * deceleration * rolls * rolls);
}

Eigen::Vector2d slackened(const Eigen::Vector2d& velocity, double ahead, double time_constant) {
  return velocity * (-time_constant * std::expm1(-ahead / time_constant));
}

Eigen::Vector2d decayed(const Eigen::Vector2d& velocity, double ahead,
                        const config::PredictorStudy::Baselines& baselines) {
  return baselines.deceleration ? rolled(velocity, ahead, *baselines.deceleration)
                                : slackened(velocity, ahead, *baselines.time_constant);
}

std::vector<bool> untouched(std::span<const Sample> samples, double window) {
  std::vector<bool> out(samples.size(), false);
  std::size_t first = 0, end = 0;
  for (std::size_t i = 0; i < samples.size(); ++i) {
    while (samples[i].time - samples[first].time > window) ++first;
    while (end < samples.size() && samples[end].time - samples[i].time <= window) ++end;
    const std::optional<Eigen::Vector2d> before = fitted_velocity(samples.subspan(first, i + 1 - first), least_samples);
    const std::optional<Eigen::Vector2d> after = fitted_velocity(samples.subspan(i, end - i), least_samples);
    if (!before || !after) continue;
    // Each velocity is the velocity in the middle of its window, so the two velocities are `window` seconds apart.
    const double speed = before->norm();
    const double slowed = speed > 0.0 ? std::min(1.0, sliding_deceleration * window / speed) : 0.0;
    // The fraction of the old velocity that is nearest to the new velocity, among the fractions that braking allows.
    const double kept = speed > 0.0 ? std::clamp(before->dot(*after) / (speed * speed), 1.0 - slowed, 1.0) : 0.0;
    out[i] = (*after - kept * *before).norm() < least_change;
  }
  return out;
}

ErrorRatios error_ratios(std::span<const PairedError> errors) {
  constexpr std::size_t draws = 1000;
  constexpr std::array shares{0.5, 0.9};
  std::size_t blocks = 0;
  for (const PairedError& each : errors) blocks = std::max(blocks, each.block + 1);
  std::vector<std::size_t> sizes(blocks, 0);
  for (const PairedError& each : errors) ++sizes[each.block];
  std::vector<std::size_t> present;  // blocks with errors
  for (std::size_t block = 0; block < blocks; ++block) {
    if (sizes[block] > 0) present.push_back(block);
  }

  const Ordered predictor = ordered(errors, &PairedError::predictor),
                baseline = ordered(errors, &PairedError::baseline);
  const auto ratio = [&](double share, const std::vector<std::uint32_t>& times, std::size_t total) {
    return quantile(predictor, share, times, total) / quantile(baseline, share, times, total);
  };
  std::array<std::vector<double>, shares.size()> drawn;
  std::vector<std::uint32_t> times(blocks);
  for (std::size_t draw = 0; draw < draws; ++draw) {
    std::ranges::fill(times, 0U);
    std::size_t total = 0;
    for (std::size_t i = 0; i < present.size(); ++i) {
      match::RandomWords words(0, {static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(draw), 0, 0});
      const double uniform = words.next() * 0x1p-32;
      const std::size_t block = present[static_cast<std::size_t>(uniform * static_cast<double>(present.size()))];
      ++times[block];
      total += sizes[block];
    }
    for (std::size_t i = 0; i < shares.size(); ++i) drawn[i].push_back(ratio(shares[i], times, total));
  }
  std::ranges::fill(times, 1U);
  const auto found = [&](std::size_t i) -> ErrorRatio {
    return {ratio(shares[i], times, errors.size()), statistics::quantile(drawn[i], 0.025),
            statistics::quantile(drawn[i], 0.975)};
  };
  return {found(0), found(1)};
}

Evaluation evaluate(const config::PredictorStudy& study, const GameRecording& recording,
                    const plugin::Catalogue* catalogue, const EvaluationProgress& progress) {
  std::optional<Forecaster> forecaster;
  if (catalogue != nullptr) forecaster.emplace(study, *catalogue);
  Evaluation out;
  Scores scores(study);
  for (std::size_t s = 0; s < recording.stretches.size(); ++s) {
    const Stretch& stretch = recording.stretches[s];
    const std::vector<bool> seen = shown(stretch, study.observations);
    const std::map<int, Path> paths = paths_of(stretch, seen);
    const std::vector<Start> starts = starts_of(stretch, paths, study);
    out.detections += seen.size();
    out.observations += static_cast<std::size_t>(std::ranges::count(seen, true));
    out.starts += starts.size();
    for (const Start& start : starts) scores.baselines(start);
    if (forecaster) {
      forecaster->begin(stretch, seen);
      for (std::size_t i = 0; i < starts.size();) {
        std::size_t end = i + 1;
        while (end < starts.size() && starts[end].truth.time == starts[i].truth.time) ++end;
        scores.predictor(stretch.number, std::span(starts).subspan(i, end - i), *forecaster);
        i = end;
        if (progress) progress(s, recording.stretches.size());
      }
    }
    if (progress) progress(s + 1, recording.stretches.size());
  }
  if (out.starts == 0) {
    throw config::Error({recording.file},
                        fmt::format("there is no start: nowhere does the game run with {} observations of an object "
                                    "in {} s (baselines.least, baselines.window)",
                                    study.baselines.least, study.baselines.window));
  }
  for (std::size_t h = 0; h < horizon_count; ++h) {
    Tally& tally = scores.tallies[h];
    out.horizons[h] = {.horizon = study.questions.horizons[h],
                       .truths = tally.truths,
                       .answers = tally.predictor.size(),
                       .predictor = errors_of(tally.predictor),
                       .hold = errors_of(tally.hold),
                       .constant = errors_of(tally.constant),
                       .decayed = errors_of(tally.decayed),
                       .to_decayed = tally.to_decayed.empty() ? ErrorRatios{} : error_ratios(tally.to_decayed),
                       .consistency = consistency_of(tally.nees),
                       .untouched = tally.untouched_nees.size(),
                       .untouched_within_95 = consistency_of(tally.untouched_nees).within_95};
  }
  return out;
}

}  // namespace regista::study
