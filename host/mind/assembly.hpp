// SPDX-License-Identifier: MIT
// Creates the plugin instances of one robot's mind from the team's plan. Always in the same order, so that mailboxes
// and seeds match between teammates. Places of a context that name the same plugin with the same parameters share one
// instance: a system whose sender, positioner and assigner share state is one object. Predictors and conditions never
// do.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "mind/coordination/coordination.hpp"
#include "mind/extensions/extensions.hpp"
#include "mind/team_plan.hpp"
#include "mind/world/local_model.hpp"
#include "mind/world/mailbox.hpp"
#include "mind/world/team_model.hpp"
#include "plugin/kinds.hpp"

namespace regista::mind {

class Assembly {
 public:
  // All of it outlives the instances.
  Assembly(const TeamPlan& plan, int number, std::uint64_t seed, Mailboxes& mailboxes, Extensions& extensions,
           const plugin::Caller& caller);

  LocalModel local_model();
  TeamModel team_model();
  std::vector<ContextParts> contexts();
  // In the order of the plan's. After contexts(), whose instances they may share.
  std::vector<plugin::Behaviour> behaviours();
  // What the instance in this place of the mailboxes was made for; of a shared one the first of its parts.
  const Part& part(std::size_t place) const { return *parts_.at(place); }

 private:
  // `stream`: robot whose luck the instance has, 0 = the same luck for all robots.
  std::shared_ptr<plugin::Instance> create(const Part& part, unsigned subject, int stream);
  std::shared_ptr<plugin::Instance> shared(const Part& part);

  struct Shared {
    const Part* part;
    std::shared_ptr<plugin::Instance> instance;
  };
  const TeamPlan* plan_;
  int number_;
  std::uint64_t seed_;
  Mailboxes* mailboxes_;
  Extensions* extensions_;
  const plugin::Caller* caller_;
  std::uint64_t created_ = 0;
  std::vector<Shared> shared_;
  std::vector<const Part*> parts_;  // by place
};

}  // namespace regista::mind
