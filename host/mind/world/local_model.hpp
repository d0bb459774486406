// SPDX-License-Identifier: MIT
// LM and its update psi (Affinita et al. 2023): what one robot knows through its own sensors alone. Own pose, ball and
// obstacles, which are "all robots", are modelled by the team's predictors (plugins/predictors); this class brings
// sightings into the field frame, with the uncertainty of the own pose added to theirs. Opponents and teammates are
// told apart by their jerseys, so each side has a model of its own, by the predictor of opponents.
#pragma once

#include <span>
#include <vector>

#include "mind/geometry.hpp"
#include "mind/percepts.hpp"
#include "mind/team_plan.hpp"
#include "plugin/kinds.hpp"

namespace regista::mind {

class LocalModel {
 public:
  LocalModel(const TeamPlan& plan, plugin::Predictor self, plugin::Predictor ball, plugin::Predictor opponents,
             plugin::Predictor teammates);

  // Carries everything dt seconds forward and takes the new percepts. `last`: the frame of the last decision, or null.
  // `ball_on_centre`: the rules say so, as both teams wait for a kick-off.
  void update(const Percepts& percepts, double dt, const regista_frame* last, bool ball_on_centre);

  const regista_track& self() const { return self_; }
  Pose pose() const { return {self_.x, self_.y, self_.pose.heading}; }
  const Frame2& frame() const { return frame_; }  // of the pose
  // Hypotheses, best first; robots in no order, and without a number. Valid until the next update.
  std::span<const regista_track> balls() const { return balls_; }
  std::span<const regista_track> opponents() const { return opponents_; }
  std::span<const regista_track> teammates() const { return teammates_; }
  // A ball was seen at the last update, near the best hypothesis.
  bool sees_ball() const { return sighted_ && !balls_.empty() && balls_.front().age < 0.5 * decision_period_; }

 private:
  void measure_self(const Percepts& percepts);
  std::span<const regista_track> update_robots(plugin::Predictor& model, const Percepts& percepts, bool own_team,
                                               double dt, const regista_motion& motion, const regista_frame* last,
                                               const regista_visible_area& area);
  void add_in_field_frame(int kind, const Frame2& frame, const Vector2d& position, double along, double across);

  double decision_period_;
  plugin::Predictor self_model_, ball_model_, opponent_model_, teammate_model_;
  regista_track self_{};
  Frame2 frame_{Pose{}};
  bool sighted_ = false;  // a ball, true or false, at the last update
  std::span<const regista_track> balls_, opponents_, teammates_;
  std::vector<regista_measurement> measurements_;
};

}  // namespace regista::mind
