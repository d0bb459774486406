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

namespace regista::study {
namespace {

// The samples of one object, by time.
struct Path {
  std::vector<Sample> samples;
  std::vector<std::size_t> index;  // in the stretch
  std::vector<Sample> observed;

  const Sample* nearest(double time, double tolerance) const {
    const auto after = std::lower_bound(samples.begin(), samples.end(), time,
                                        [](const Sample& sample, double t) { return sample.time < t; });
    const Sample* best = nullptr;
    if (after != samples.begin()) best = &*(after - 1);
    if (after != samples.end() && (best == nullptr || after->time - time < time - best->time)) best = &*after;
    return best != nullptr && std::abs(best->time - time) <= tolerance ? best : nullptr;
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

std::map<int, Path> paths_of(const Stretch& stretch, const std::vector<bool>& shown) {
  std::map<int, Path> paths;
  for (std::size_t i = 0; i < stretch.samples.size(); ++i) {
    Path& path = paths[stretch.samples[i].object];
    path.samples.push_back(stretch.samples[i]);
    path.index.push_back(i);
    if (shown[i]) path.observed.push_back(stretch.samples[i]);
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
  std::vector<double> predictor, hold, constant, decayed, nees;
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
      tally.decayed.push_back((moved - decayed(start.velocity, ahead, study_.baselines)).norm());
    }
  }

  // Starts of one time.
  void predictor(std::span<const Start> starts, Forecaster& forecaster) {
    forecaster.listen(starts.front().index);
    labels_.clear();
    for (const Start& start : starts) labels_.push_back(forecaster.label_of(start.truth));
    questions_.clear();
    for (std::size_t i = 0; i < starts.size(); ++i) {
      for (std::size_t h = 0; h < horizon_count; ++h) {
        const Sample* truth = truth_of(starts[i], h);
        if (truth != nullptr && labels_[i]) questions_.push_back({truth, h, *labels_[i]});
      }
    }
    std::stable_sort(questions_.begin(), questions_.end(),
                     [](const Question& a, const Question& b) { return a.truth->time < b.truth->time; });
    for (const Question& each : questions_) {
      forecaster.look(each.truth->time - starts.front().truth.time);
      const std::optional<Estimate> estimate = forecaster.estimate(each.label);
      if (!estimate) continue;
      const Eigen::Vector2d place(each.truth->x, each.truth->y);
      tallies[each.horizon].predictor.push_back((place - estimate->position).norm());
      tallies[each.horizon].nees.push_back(nees(*estimate, place, study_.camera.noise));
    }
  }

  std::array<Tally, horizon_count> tallies;

 private:
  const Sample* truth_of(const Start& start, std::size_t h) const {
    return start.path->nearest(start.truth.time + study_.questions.horizons[h], study_.questions.tolerance);
  }

  struct Question {
    const Sample* truth;
    std::size_t horizon;
    int label;
  };
  const config::PredictorStudy& study_;
  std::vector<std::optional<int>> labels_;
  std::vector<Question> questions_;
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
        scores.predictor(std::span(starts).subspan(i, end - i), *forecaster);
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
    out.horizons[h] = {study.questions.horizons[h], tally.truths,
                       tally.predictor.size(),      errors_of(tally.predictor),
                       errors_of(tally.hold),       errors_of(tally.constant),
                       errors_of(tally.decayed),    consistency_of(tally.nees)};
  }
  return out;
}

}  // namespace regista::study
