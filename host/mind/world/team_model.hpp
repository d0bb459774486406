// SPDX-License-Identifier: MIT
// OLM_j and its update delta (Affinita et al. 2023): for every robot j of the team, what its packets said, each merged
// with what was known before (told.hpp) and carried forward by the team's predictors while nothing arrives. The own
// number has a model too, of what the *others* know of this robot: its own packets as they were decoded. All robots
// that heard the same packets hold the same models.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "config/robot.hpp"
#include "mind/world/fusion.hpp"
#include "mind/world/packet.hpp"
#include "mind/world/told.hpp"
#include "plugin/kinds.hpp"

namespace regista::mind {

class TeamModel {
 public:
  // `balls` and `opponents` hold one predictor per robot, by number. `camera`: what a robot of this team has.
  TeamModel(int team_size, const config::Camera& camera, plugin::Predictor teammates,
            std::vector<plugin::Predictor> balls, std::vector<plugin::Predictor> opponents);

  [[gnu::noinline]] void predict(double dt, const regista_frame* last);  // a stage of benchmarks/profile
  // A packet that left report.time_sent <= now. One older than the newest of its sender changes nothing.
  void absorb(const Report& report, double now);
  // Reads the predictors once; everything below is as of the last call.
  void refresh();

  // What robot `number` last said; null before its first packet.
  const Report* report(int number) const {
    const auto& member = members_[static_cast<std::size_t>(number - 1)];
    return member.report ? &*member.report : nullptr;
  }
  // Its track, carried forward; null before its first packet.
  const regista_track* track(int number) const { return members_[static_cast<std::size_t>(number - 1)].track; }
  // Appends the balls of everyone but `except` (0: of everyone), and everyone's opponents.
  void balls(int except, std::vector<Estimate>& out) const;
  void opponents(std::vector<Estimate>& out) const;

 private:
  struct Member {
    plugin::Predictor ball, opponents;
    std::optional<Report> report;
    const regista_track* track = nullptr;
    std::span<const regista_track> ball_tracks, opponent_tracks;
    bool has_ball = false, has_opponents = false;  // something may be there to be carried forward
  };
  void absorb_robot(const Report& report, double age);
  void absorb_ball(const Report& report, double age, plugin::Predictor& model);
  void absorb_opponents(const Report& report, double age, plugin::Predictor& model);
  void merge(plugin::Predictor& model, const SenderView& sender, double age);

  config::Camera camera_;
  plugin::Predictor teammates_;
  std::vector<Member> members_;
  std::vector<regista_track> told_, known_, merged_;
};

}  // namespace regista::mind
