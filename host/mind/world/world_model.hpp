// SPDX-License-Identifier: MIT
// WorldModel contains all beliefs of a robot. As in Affinita et al. 2023: LM (LocalModel: its own sensing), OLM_j for
// each robot j (TeamModel: what the packets of j told), and two distributed world models (DWM), which f computes from
// LM and OLM_j. The world `mine` fuses LM with the teammates' models; of opponents also with the model from the
// robot's own packets. The world `common` fuses only packets, also the robot's own, so robots that heard the same
// packets have equal common worlds.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "config/robot.hpp"
#include "mind/geometry.hpp"
#include "mind/percepts.hpp"
#include "mind/team_plan.hpp"
#include "mind/world/fusion.hpp"
#include "mind/world/packet.hpp"
#include "plugin/kinds.hpp"
#include "regista/abi.h"

namespace regista::mind {

// Returns a view of a list in the form that plugins see. Valid until the list changes.
template <class T>
regista_span abi_span(const std::vector<T>& list) {
  return {list.data(), static_cast<std::uint32_t>(list.size()), sizeof(T)};
}

// DWM of the paper: one consistent picture of the game. Plugins see `raw`, which points into the other members.
class DistributedWorldModel {
 public:
  explicit DistributedWorldModel(int team_size) : robots(static_cast<std::size_t>(team_size)) {
    for (int number = 1; number <= team_size; ++number) {
      robot(number).number = number;
      robot(number).role = -1;
    }
    active.reserve(robots.size());
    raw.size = sizeof raw;
    raw.game = &game;
    raw.ball = &ball_state;
  }
  // Not copyable, because `raw` points into the other members.
  DistributedWorldModel(const DistributedWorldModel&) = delete;
  DistributedWorldModel& operator=(const DistributedWorldModel&) = delete;

  regista_robot& robot(int number) { return robots[static_cast<std::size_t>(number - 1)]; }
  const regista_robot& robot(int number) const { return robots[static_cast<std::size_t>(number - 1)]; }
  bool is_active(int number) const { return (robot(number).flags & REGISTA_ROBOT_ACTIVE) != 0; }
  bool ball_known() const { return (ball_state.flags & REGISTA_BALL_KNOWN) != 0; }
  Vector2d ball() const { return {ball_state.position[0], ball_state.position[1]}; }
  Vector2d ball_velocity() const { return {ball_state.velocity[0], ball_state.velocity[1]}; }

  // Must be called after the last change of robots and opponents. Fills `active` and sets all pointers of `raw`.
  void close() {
    active.clear();
    for (const regista_robot& each : robots) {
      if ((each.flags & REGISTA_ROBOT_ACTIVE) != 0) active.push_back(each.number);
    }
    game.size = sizeof game;
    ball_state.size = sizeof ball_state;
    raw.robots = abi_span(robots);
    raw.opponents = abi_span(opponents);
    raw.active = abi_span(active);
  }

  regista_world raw{};
  regista_game game{};
  regista_ball ball_state{};
  std::vector<regista_robot> robots;
  std::vector<regista_opponent> opponents;
  std::vector<std::int32_t> active;  // numbers of the active robots, ascending
};

// LM and its update psi (Affinita et al. 2023): what one robot knows from its own sensors alone. The team's predictors
// model the robot's own pose, the ball and the obstacles ("all robots"). LocalModel converts sightings to the field
// frame and adds the uncertainty of the own pose. The jerseys tell the team of a robot, so opponents and teammates have
// separate models. The predictor of opponents gives both models.
class LocalModel {
 public:
  LocalModel(const TeamPlan& plan, plugin::Predictor self, plugin::Predictor ball, plugin::Predictor opponents,
             plugin::Predictor teammates);

  // Carries all models forward by dt (s) and adds the new percepts. `last`: frame of the last decision, or null.
  // `ball_on_centre`: the ball is on the centre by the rules, because the teams wait for a kick-off.
  void update(const Percepts& percepts, double dt, const regista_frame* last, bool ball_on_centre);

  const regista_track& self() const { return self_; }
  Pose pose() const { return {self_.x, self_.y, self_.pose.heading}; }
  const Frame2& frame() const { return frame_; }  // converts between robot frame and field frame
  // Until the next update(). balls(): hypotheses, the best first. Others: robots in any order, without shirt numbers.
  std::span<const regista_track> balls() const { return balls_; }
  std::span<const regista_track> opponents() const { return opponents_; }
  std::span<const regista_track> teammates() const { return teammates_; }
  // Returns whether the percepts of the last update() had a ball sighting that belongs to the best hypothesis.
  bool sees_ball() const { return sighted_ && !balls_.empty() && balls_.front().age < 0.5 * decision_period_; }

 private:
  void measure_self(const Percepts& percepts);
  regista_measurement& add(int kind, double x, double y);
  void add_in_field_frame(int kind, const Vector2d& seen, double along, double across);

  double decision_period_;
  plugin::Predictor self_model_, ball_model_, opponent_model_, teammate_model_;
  regista_track self_{};
  Frame2 frame_{Pose{}};
  bool sighted_ = false;  // the percepts of the last update() had a true or false ball sighting
  std::span<const regista_track> balls_, opponents_, teammates_;
  std::vector<regista_measurement> measurements_;
};

// All OLM_j and their update delta (Affinita et al. 2023). For every robot j of the team: the content of its packets,
// merged with earlier knowledge (merge_told()) and carried forward by the team's predictors. The model of this
// robot is made from its own packets, so this model is what teammates know of it. Equal packets give equal models.
class TeamModel {
 public:
  // `balls`, `opponents`: one predictor for each robot, by number. `camera`: the camera of the team's robots.
  TeamModel(int team_size, const config::Camera& camera, plugin::Predictor teammates,
            std::vector<plugin::Predictor> balls, std::vector<plugin::Predictor> opponents);

  [[gnu::noinline]] void predict(double dt, const regista_frame* last);  // benchmarks/profile measures this function
  // Adds a packet with report.time_sent <= now (s). Ignores a packet that is older than the sender's newest packet.
  void absorb(const Report& report, double now);
  // Reads the tracks of all predictors. track(), balls() and opponents() return the state at the last refresh().
  void refresh();

  // Returns the newest report of robot `number`; null before the robot's first packet.
  const Report* report(int number) const {
    const auto& member = members_[static_cast<std::size_t>(number - 1)];
    return member.report ? &*member.report : nullptr;
  }
  // Returns the track of robot `number`, carried forward; null before the robot's first packet.
  const regista_track* track(int number) const { return members_[static_cast<std::size_t>(number - 1)].track; }
  // Appends the balls of all robots except `except` (0: no exception) to `out`.
  void balls(int except, std::vector<Estimate>& out) const;
  std::span<const regista_track> opponents(int number) const {
    return members_[static_cast<std::size_t>(number - 1)].opponent_tracks;
  }

 private:
  struct Member {
    plugin::Predictor ball, opponents;
    std::optional<Report> report;
    const regista_track* track = nullptr;
    std::span<const regista_track> ball_tracks, opponent_tracks;
    bool has_ball = false, has_opponents = false;  // the predictor may have tracks
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

struct OwnRole {
  int role = -1;
  double since = 0.0;
  Vector2d target{0, 0};
};

class WorldModel {
 public:
  WorldModel(const TeamPlan& plan, int own_number, LocalModel local, TeamModel team, FrameParts made);

  // Each decision calls, in this order: sense(), hear() for each report, fuse(). `last`: last decision's frame or null.
  void sense(const Percepts& percepts, double dt, const regista_frame* last);
  void hear(const Report& report, double now) { team_.absorb(report, now); }
  void fuse(const Percepts& percepts, double dt, const OwnRole& own);

  const DistributedWorldModel& mine() const { return mine_; }
  const DistributedWorldModel& common() const { return common_; }
  const LocalModel& local() const { return local_; }
  const TeamModel& team() const { return team_; }
  // Returns whether this robot's camera refutes every estimate of the ball. The ball's place in `mine` is then wrong.
  bool ball_refuted() const { return ball_refuted_; }

 private:
  void fuse_balls(const Percepts& percepts, double dt);
  void fuse_opponents();
  void fill_robots(const Percepts& percepts);
  void sharpen_teammates();
  void fill_self(const Percepts& percepts, const OwnRole& own);
  regista_game game(const Percepts& percepts) const;

  const TeamPlan* plan_;
  FrameParts made_;
  int own_number_;
  LocalModel local_;
  TeamModel team_;
  DistributedWorldModel mine_, common_;
  bool ball_refuted_ = false;
  NegativeInformation negative_;
  OpponentFusion fusion_;
  std::vector<Estimate> estimates_;
  std::vector<SeenTeammate> seen_teammates_;
};

}  // namespace regista::mind
