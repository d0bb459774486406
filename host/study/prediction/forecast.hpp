// SPDX-License-Identifier: MIT
// A Forecaster shows a predictor plugin the observations up to a time, then asks for the state at later times. Every
// question begins with a reset of the plugin, so no answer depends on earlier questions.
#pragma once

#include <Eigen/Core>

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "config/predictor_study.hpp"
#include "plugin/catalogue.hpp"
#include "plugin/predictor.hpp"
#include "study/prediction/game_recording.hpp"

namespace regista::study {

// Returns for every sample of the stretch (a part of a recording without cuts) whether the predictor gets it. Each
// object has at most one observation in `every` seconds, as in a team's packets. Each observation is lost with
// probability `drop`. The draw depends on (seed, stretch, object, sample number): Philox4x32 of Salmon et al.,
// "Parallel Random Numbers: As Easy as 1, 2, 3", SC 2011.
std::vector<bool> shown(const Stretch& stretch, const config::PredictorStudy::Observations& observations);

// The predicted distribution of an object's place, m and m^2.
struct Estimate {
  Eigen::Vector2d position;
  Eigen::Matrix2d covariance;
};

class Forecaster {
 public:
  // Throws config::Error at the study's predictor if the plugin does not exist, does not model the study's subject, or
  // rejects its parameters. Throws plugin::Failure if the plugin cannot be created. `study` must outlive this object.
  Forecaster(const config::PredictorStudy& study, const plugin::Catalogue& catalogue);

  // Begins a stretch. The samples marked in `shown` are observations. Both arguments must live until the next begin().
  void begin(const Stretch& stretch, const std::vector<bool>& shown);

  // Resets the plugin. Then shows it the observations up to sample `now` that are not older than the study's memory.
  void listen(std::size_t now);

  // Call this after listen(). Returns the label of the object's track. For the ball, this is the track of the best
  // hypothesis. For an anonymous robot, this is the track nearest to its true place. nullopt: there are no tracks.
  std::optional<int> label_of(const Sample& truth);

  // Call this after listen(). Moves the model to `ahead` seconds after sample `now`. `ahead` must not decrease.
  void look(double ahead);

  // The estimate of the track with this label after the last look(). For the ball: the best hypothesis for any label.
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
  std::size_t oldest_ = 0;  // index of the first sample in the memory
  double ahead_ = 0.0;
};

}  // namespace regista::study
