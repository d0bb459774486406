// SPDX-License-Identifier: MIT
// The two worlds of one decision, and which of them answers where a team asks for one.
#pragma once

#include "config/team.hpp"
#include "mind/world/distributed_world_model.hpp"

namespace regista::mind {

// What all know may have given this robot up, as after a long silence of its own. Nothing that is computed there counts
// it: no task is kept for it, and it stands still. Then the common world no longer speaks for this robot, and what it
// knows itself answers in its place.
class Worlds {
 public:
  Worlds(const DistributedWorldModel& mine, const DistributedWorldModel& common, int own_number)
      : mine_(&mine), common_(&common), speaks_for_self_(common.is_active(own_number) || !mine.is_active(own_number)) {}

  // The world that answers when `asked` is asked.
  config::Knowledge answering(config::Knowledge asked) const {
    return speaks_for_self_ ? asked : config::Knowledge::mine;
  }
  const DistributedWorldModel& of(config::Knowledge asked) const {
    return answering(asked) == config::Knowledge::common ? *common_ : *mine_;
  }
  const DistributedWorldModel& mine() const { return *mine_; }
  const DistributedWorldModel& common() const { return *common_; }

 private:
  const DistributedWorldModel *mine_, *common_;
  bool speaks_for_self_;  // the common world counts this robot, or it does not play
};

}  // namespace regista::mind
