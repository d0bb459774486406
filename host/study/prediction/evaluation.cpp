// SPDX-License-Identifier: MIT
#include "study/prediction/evaluation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "study/prediction/baseline.hpp"
#include "study/prediction/forecast.hpp"
#include "study/prediction/observations.hpp"
#include "study/prediction/touches.hpp"

namespace regista::study {
namespace {

// The samples of one object, by time.
struct Path {
  std::vector<Sample> samples;
  std::vector<std::size_t> index;  // in the stretch
  std::vector<Sample> observed;
  std::vector<std::size_t> touched;  // in `samples`: where somebody touched it, or nobody knows; of a ball

  const Sample* nearest(double time, double tolerance) const {
    const auto after = std::lower_bound(samples.begin(), samples.end(), time,
                                        [](const Sample& sample, double t) { return sample.time < t; });
    const Sample* best = nullptr;
    if (after != samples.begin()) best = &*(after - 1);
    if (after != samples.end() && (best == nullptr || after->time - time < time - best->time)) best = &*after;
    return best != nullptr && std::abs(best->time - time) <= tolerance ? best : nullptr;
  }

  bool rolls_freely(const Sample& from, const Sample& to) const {
    const auto place = [&](const Sample& sample) {
      return static_cast<std::size_t>(std::lower_bound(samples.begin(), samples.end(), sample.time,
                                                       [](const Sample& each, double t) { return each.time < t; }) -
                                      samples.begin());
    };
    const auto next = std::ranges::lower_bound(touched, place(from));
    return next == touched.end() || *next > place(to);
  }

  // What was observed in the `window` seconds that end at `time`.
  std::span<const Sample> recent(double time, double window) const {
    const auto earlier = [](const Sample& sample, double t) { return sample.time < t; };
    const auto first = std::lower_bound(observed.begin(), observed.end(), time - window, earlier);
    const auto last =
        std::upper_bound(first, observed.end(), time, [](double t, const Sample& sample) { return t < sample.time; });
    return {first, last};
  }
};

// s: time enough for a velocity to show, not more than a ball needs to cross a robot.
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
  std::size_t index;  // in the stretch
  Sample truth;
  Sample last;  // observed
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
  std::sort(out.begin(), out.end(), [](const Start& a, const Start& b) { return a.index < b.index; });
  return out;
}

// Errors of one block may share a kick.
constexpr double block_length = 10.0;  // s

double quantile(std::vector<double>& values, double share) {
  if (values.empty()) return 0.0;
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1) + 0.5);
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

Errors errors_of(std::vector<double>& values) { return {quantile(values, 0.5), quantile(values, 0.9)}; }

// What is gathered for one horizon.
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
    return static_cast<double>(std::count_if(nees.begin(), nees.end(), [&](double each) { return each <= limit; })) /
           count;
  };
  double sum = 0.0;
  for (const double each : nees) sum += each;
  return {within(0.5), within(0.9), within(0.95), sum / count, quantile(nees, 0.5)};
}

class Scores {
 public:
  explicit Scores(const config::PredictorStudy& study) : study_(study) {}

  void baselines(const Start& start) {
    for (std::size_t h = 0; h < horizon_count; ++h) {
      const Sample* truth = truth_of(start, h);
      if (truth == nullptr) continue;
      const double ahead = truth->time - start.last.time;
      const Eigen::Vector2d moved = Eigen::Vector2d(truth->x - start.last.x, truth->y - start.last.y);
      Tally& tally = tallies[h];
      ++tally.truths;
      tally.hold.push_back(moved.norm());
      tally.constant.push_back((moved - undiminished(start.velocity, ahead)).norm());
      tally.decayed.push_back(decayed_error(start, *truth));
    }
  }

  // Starts of one time, in the stretch `number`.
  void predictor(int number, std::span<const Start> starts, Forecaster& forecaster) {
    forecaster.listen(starts.front().index);
    labels_.clear();
    for (const Start& start : starts) labels_.push_back(forecaster.label_of(start.truth));
    questions_.clear();
    const auto block =
        blocks_.emplace(std::pair(number, std::floor(starts.front().truth.time / block_length)), blocks_.size());
    for (std::size_t i = 0; i < starts.size(); ++i) {
      for (std::size_t h = 0; h < horizon_count; ++h) {
        const Sample* truth = truth_of(starts[i], h);
        if (truth != nullptr && labels_[i]) questions_.push_back({truth, h, *labels_[i], &starts[i]});
      }
    }
    std::stable_sort(questions_.begin(), questions_.end(),
                     [](const Question& a, const Question& b) { return a.truth->time < b.truth->time; });
    for (const Question& each : questions_) {
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
  std::vector<std::optional<int>> labels_;
  std::vector<Question> questions_;
  std::map<std::pair<int, double>, std::size_t> blocks_;  // by stretch and time: numbers from 0
};

}  // namespace

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
    out.observations += static_cast<std::size_t>(std::count(seen.begin(), seen.end(), true));
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
    AtHorizon& at = out.horizons[h];
    at.horizon = study.questions.horizons[h];
    at.truths = tally.truths;
    at.answers = tally.predictor.size();
    at.predictor = errors_of(tally.predictor);
    at.hold = errors_of(tally.hold);
    at.constant = errors_of(tally.constant);
    at.decayed = errors_of(tally.decayed);
    if (at.answers > 0) at.to_decayed = error_ratios(tally.to_decayed);
    at.consistency = consistency_of(tally.nees);
    at.untouched = tally.untouched_nees.size();
    at.untouched_within_95 = consistency_of(tally.untouched_nees).within_95;
  }
  return out;
}

}  // namespace regista::study
