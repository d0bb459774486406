// SPDX-License-Identifier: MIT
#include "study/prediction/forecast.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>

#include "config/rules.hpp"
#include "match/chance.hpp"
#include "plugin/parameters.hpp"

namespace regista::study {

std::vector<bool> shown(const Stretch& stretch, const config::PredictorStudy::Observations& observations) {
  constexpr double slack = 1e-6;  // s; tolerance, because recordings round their times
  std::vector<bool> out(stretch.samples.size(), false);
  std::map<int, double> last;
  for (std::size_t i = 0; i < out.size(); ++i) {
    const Sample& sample = stretch.samples[i];
    if (observations.every > 0.0) {
      const auto [place, first] = last.emplace(sample.object, sample.time);
      if (!first && sample.time - place->second < observations.every - slack) continue;
      place->second = sample.time;
    }
    match::RandomWords words(static_cast<std::uint32_t>(observations.seed),
                             {static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(sample.object),
                              static_cast<std::uint32_t>(stretch.number), 0});
    out[i] = words.next() * 0x1p-32 >= observations.drop;
  }
  return out;
}

namespace {

unsigned subject_of(const config::PredictorStudy& study) {
  return study.subject == config::PredictorStudy::Subject::ball ? REGISTA_SUBJECT_BALL : REGISTA_SUBJECT_OPPONENTS;
}

// The environment for the plugin: field and robots of the recording; all other values are from the rules of the SPL.
regista_environment environment_of(const config::PredictorStudy& study) {
  const config::Rules rules;
  const config::FieldSize& field = rules.field;
  regista_environment out{};
  out.size = sizeof out;
  out.team_size = static_cast<std::uint32_t>(rules.team_size);
  out.own_number = 1;
  out.subject = subject_of(study);
  out.field_length = study.field.length;
  out.field_width = study.field.width;
  out.border_strip = field.border_strip;
  out.goal_width = std::min(field.goal_width, study.field.width);
  out.goal_depth = field.goal_depth;
  out.goal_area_length = std::min(field.goal_area_length, study.field.length / 2.0);
  out.goal_area_width = std::min(field.goal_area_width, study.field.width);
  out.penalty_area_length = std::min(field.penalty_area_length, study.field.length / 2.0);
  out.penalty_area_width = std::min(field.penalty_area_width, study.field.width);
  out.penalty_mark_distance = std::min(field.penalty_mark_distance, study.field.length / 2.0);
  out.centre_circle_radius = std::min(field.centre_circle_diameter, study.field.width) / 2.0;
  out.ball_radius = rules.ball.diameter / 2.0;
  out.robot_radius = study.robot_radius;
  out.decision_period = study.questions.step;
  out.packet_size = static_cast<std::uint32_t>(rules.messages.size);
  out.packet_budget = static_cast<std::uint32_t>(rules.messages.budget);
  out.landmarks = {nullptr, 0, sizeof(regista_landmark)};
  out.roles = {nullptr, 0, sizeof(regista_role)};
  return out;
}

}  // namespace

Forecaster::Forecaster(const config::PredictorStudy& study, const plugin::Catalogue& catalogue) : study_(study) {
  const unsigned subject = subject_of(study);
  const plugin::Found& found = catalogue.find(study.predictor, REGISTA_KIND_PREDICTOR, subject);
  instance_ = std::make_shared<plugin::Instance>(found, plugin::resolve(*found.descriptor, study.predictor),
                                                 environment_of(study), nullptr, nullptr);
  instance_->reset(1);
  predictor_.emplace(instance_);
}

void Forecaster::begin(const Stretch& stretch, const std::vector<bool>& shown) {
  stretch_ = &stretch;
  shown_ = &shown;
  oldest_ = 0;
}

void Forecaster::listen(std::size_t now) {
  const std::vector<Sample>& samples = stretch_->samples;
  const double time = samples[now].time, since = time - study_.questions.memory;
  while (samples[oldest_].time < since) ++oldest_;
  instance_->reset(1);
  const bool ball = study_.subject == config::PredictorStudy::Subject::ball;
  const double variance = study_.camera.noise * study_.camera.noise;
  const regista_visible_area area{0.0, 0.0, 0.0, std::numbers::pi, study_.camera.range, study_.camera.range};
  double reached = samples[oldest_].time;
  for (std::size_t i = oldest_; i < samples.size() && samples[i].time <= time;) {
    const double then = samples[i].time;
    image_.clear();
    for (; i < samples.size() && samples[i].time == then; ++i) {
      if (!(*shown_)[i]) continue;
      regista_measurement& measurement = image_.emplace_back();
      measurement.kind = ball ? REGISTA_MEASURED_BALL : REGISTA_MEASURED_ROBOT;
      measurement.position[0] = samples[i].x;
      measurement.position[1] = samples[i].y;
      measurement.covariance[0] = measurement.covariance[2] = variance;
    }
    if (image_.empty()) continue;
    carry(then - reached);
    reached = then;
    predictor_->correct(image_, area);
  }
  carry(time - reached);
  ahead_ = 0.0;
  tracks_ = predictor_->tracks();
}

std::optional<int> Forecaster::label_of(const Sample& truth) {
  if (tracks_.empty()) return std::nullopt;
  if (study_.subject == config::PredictorStudy::Subject::ball) return tracks_.front().label;
  const auto distance = [&truth](const regista_track& track) {
    const double x = track.x - truth.x, y = track.y - truth.y;
    return x * x + y * y;
  };
  return std::min_element(tracks_.begin(), tracks_.end(),
                          [&](const regista_track& a, const regista_track& b) { return distance(a) < distance(b); })
      ->label;
}

void Forecaster::look(double ahead) {
  if (ahead == ahead_) return;
  carry(ahead - ahead_);
  ahead_ = ahead;
  tracks_ = predictor_->tracks();
}

std::optional<Estimate> Forecaster::estimate(int label) {
  const auto of_track = [](const regista_track& track) {
    Estimate out;
    out.position << track.x, track.y;
    out.covariance << track.covariance[0], track.covariance[1], track.covariance[1], track.covariance[2];
    return out;
  };
  if (tracks_.empty()) return std::nullopt;
  if (study_.subject == config::PredictorStudy::Subject::ball) return of_track(tracks_.front());
  for (const regista_track& track : tracks_) {
    if (track.label == label) return of_track(track);
  }
  return std::nullopt;
}

void Forecaster::carry(double seconds) {
  constexpr double shortest = 1e-9;  // s; a shorter time comes only from rounding
  if (seconds <= shortest) return;
  const double steps = std::max(1.0, std::ceil(seconds / study_.questions.step - shortest));
  for (double k = 0.0; k < steps; k += 1.0) predictor_->predict(seconds / steps, nullptr, nullptr);
}

}  // namespace regista::study
