// SPDX-License-Identifier: MIT
// A predictor plugin that is shown observations up to a time and asked how things will be after it. Every question
// begins with a reset, so that no answer depends on the questions before; what is carried forward to answer one
// is not used again.
#pragma once

#include <Eigen/Core>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "config/predictor_study.hpp"
#include "plugin/catalogue.hpp"
#include "plugin/predictor.hpp"
#include "study/prediction/recording.hpp"

namespace regista::study {

// The distribution of an object's place that a predictor gives.
struct Estimate {
  Eigen::Vector2d position;
  Eigen::Matrix2d covariance;
};

class Forecaster {
 public:
  // Throws config::Error at the study's predictor when there is no such plugin, it does not model the study's subject,
  // or its parameters are not sound; plugin::Failure when it cannot be created. `study` must outlive this.
  Forecaster(const config::PredictorStudy& study, const plugin::Catalogue& catalogue);

  // One stretch of samples by time, of which those marked in `shown` are observations.
  void begin(const Stretch& stretch, const std::vector<bool>& shown);

  // Shows what was observed in the study's memory up to the sample `now` and all others of its time.
  void listen(std::size_t now);

  // After listen(): the track that stands for an object now, by its label. The ball: the best hypothesis. An anonymous
  // robot: the track nearest its true place. None when there is no track.
  std::optional<int> label_of(const Sample& truth);

  // After listen(): carries the model to `ahead` seconds after now; calls must not go back.
  void look(double ahead);

  // The estimate of a track as of the last call. The ball: of the best hypothesis, whatever its label.
  std::optional<Estimate> estimate(int label);

 private:
  void carry(double seconds);

  const config::PredictorStudy& study_;
  std::shared_ptr<plugin::Instance> instance_;
  std::optional<plugin::Predictor> predictor_;
  const Stretch* stretch_ = nullptr;
  const std::vector<bool>* shown_ = nullptr;
  std::vector<regista_measurement> image_;
  std::span<const regista_track> tracks_;
  std::size_t oldest_ = 0;  // sample that may still be shown
  double ahead_ = 0.0;
};

}  // namespace regista::study
