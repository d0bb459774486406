// SPDX-License-Identifier: MIT
// Assembly creates the plugin instances of one robot's mind from the team's plan. All teammates create the instances in
// one order. So a use of a plugin has the same place (the instance's number in this order) in every mind; messages find
// a teammate's plugin by its place (mailboxes.hpp), and seeds depend on it. If the plan uses a plugin twice with the
// same parameters, the two uses share one instance and its state. Predictors and conditions never share an instance.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "mind/coordination/coordination.hpp"
#include "mind/extensions/extensions.hpp"
#include "mind/team_plan.hpp"
#include "mind/world/mailboxes.hpp"
#include "mind/world/world_model.hpp"
#include "plugin/kinds.hpp"

namespace regista::mind {

class Assembly {
 public:
  // All arguments must outlive the created instances.
  Assembly(const TeamPlan& plan, int number, std::uint64_t seed, Mailboxes& mailboxes, Extensions& extensions,
           const plugin::Caller& caller);

  LocalModel local_model();
  TeamModel team_model();
  std::vector<ContextParts> contexts();
  // Returns the behaviours in the order of TeamPlan::behaviours(). Must be called after contexts(): contexts and
  // behaviours may share instances, and the first use determines the order of creation.
  std::vector<plugin::Behaviour> behaviours();
  // Returns the part of the plan for which the instance with this place was created: of several uses, the first.
  const Part& part(std::size_t place) const { return *parts_.at(place); }

 private:
  // `stream`: number of the robot whose random stream the instance gets; 0: the stream that all robots share.
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
  std::vector<const Part*> parts_;  // indexed by place
};

}  // namespace regista::mind
