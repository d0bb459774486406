// SPDX-License-Identifier: MIT
// All that a robot believes: LM and all OLM_j of Affinita et al. 2023, and the distributed world model that f makes of
// them, twice over. `mine` fuses the own local model with the models of the others; `common` fuses only what has been
// sent, the own packets included, so that robots which heard the same packets see the same world.
#pragma once

#include <vector>

#include "mind/frame_parts.hpp"
#include "mind/percepts.hpp"
#include "mind/world/distributed_world_model.hpp"
#include "mind/world/fusion.hpp"
#include "mind/world/local_model.hpp"
#include "mind/world/negative_information.hpp"
#include "mind/world/seen_teammates.hpp"
#include "mind/world/team_model.hpp"

namespace regista::mind {

// What this robot plays now: for its own row in `mine`.
struct OwnRole {
  int role = -1;
  double since = 0.0;
  Vector2d target{0, 0};
};

class WorldModel {
 public:
  WorldModel(const TeamPlan& plan, int own_number, LocalModel local, TeamModel team, FrameParts made);

  // Order of a decision: sense(), hear() for each report, fuse(). `last` as in LocalModel::update.
  void sense(const Percepts& percepts, double dt, const regista_frame* last);
  void hear(const Report& report, double now) { team_.absorb(report, now); }
  void fuse(const Percepts& percepts, double dt, const OwnRole& own);

  const DistributedWorldModel& mine() const { return mine_; }
  const DistributedWorldModel& common() const { return common_; }
  const LocalModel& local() const { return local_; }
  const TeamModel& team() const { return team_; }
  // Every estimate of the ball has been looked for in vain: `mine` still tells the last news, but it is not there.
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
