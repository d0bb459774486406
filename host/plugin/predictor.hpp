// SPDX-License-Identifier: MIT
// Calls of a predictor, and the checks of the estimate it hands back.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "plugin/instance.hpp"

namespace regista::plugin {

class Predictor {
 public:
  static constexpr std::uint32_t track_capacity = 64;

  // Throws Failure when the plugin is no predictor or cannot model environment.subject.
  explicit Predictor(std::shared_ptr<Instance> instance);

  // dt > 0 seconds forward. motion: of the own body since the last call, robot frame at its beginning; null for the
  // model of a teammate. last: the frame of the last decision, null before the first.
  void predict(double dt, const regista_motion* motion, const regista_frame* last);
  void correct(std::span<const regista_measurement> measurements, const regista_visible_area& area);
  // What a packet said `age` >= 0 seconds ago, carried forward to now.
  void absorb(std::span<const regista_track> tracks, double age);
  // The present estimate, valid until the next call. Checked: finite; |heading| <= pi; covariances positive
  // semi-definite; weights in (0, 1]; ages >= 0; self is one track with the own number; the best hypothesis of the ball
  // comes first; teammates are in ascending order of their numbers; labels of opponents are unique.
  std::span<const regista_track> tracks();

 private:
  void check(const regista_track& track, bool has_pose) const;
  void note_answer(std::span<const regista_track> tracks, bool poses) const;
  void check_together(std::span<const regista_track> tracks) const;

  std::shared_ptr<Instance> instance_;
  const regista_predictor* calls_;
  std::vector<regista_track> tracks_;  // of its own, of the size in use: what was answered last stays readable
};

}  // namespace regista::plugin
