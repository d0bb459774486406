// SPDX-License-Identifier: MIT
#include "mind/assembly.hpp"

#include <Random123/philox.h>

namespace regista::mind {

Assembly::Assembly(const TeamPlan& plan, int number, std::uint64_t seed, Mailboxes& mailboxes, Extensions& extensions,
                   const plugin::Caller& caller)
    : plan_(&plan), number_(number), seed_(seed), mailboxes_(&mailboxes), extensions_(&extensions), caller_(&caller) {
  extensions.tell_roles([&plan](int id, regista_role_facts& out) {
    if (id < 0 || static_cast<std::size_t>(id) >= plan.roles().size()) return false;
    const config::Role& role = *plan.roles()[static_cast<std::size_t>(id)].role;
    out.group = role.group;
    out.moves = role.offset ? 1 : 0;
    out.purposes = static_cast<std::int32_t>(plan.purposes(id));
    out.behaviour = role.behaviour.c_str();
    return true;
  });
}

std::shared_ptr<plugin::Instance> Assembly::create(const Part& part, unsigned subject, int stream) {
  const regista_host* host = mailboxes_->open(&extensions_->open(*part.found, plan_->metrics_of(*part.found)));
  std::shared_ptr<plugin::Instance> instance;
  try {
    instance = std::make_shared<plugin::Instance>(*part.found, part.parameters, plan_->environment(number_, subject),
                                                  host, caller_);
  } catch (plugin::Failure& failure) {
    failure.used_at(part.use.where);
    throw;
  }
  parts_.push_back(&part);
  mailboxes_->connect(instance);
  // created_ gives every instance of a robot its own random stream.
  instance->reset(r123::Philox2x64()({{static_cast<std::uint64_t>(stream), created_++}}, {{seed_}})[0]);
  return instance;
}

std::shared_ptr<plugin::Instance> Assembly::shared(const Part& part) {
  for (const Shared& each : shared_) {
    if (each.part->found == part.found && same(each.part->use.params, part.use.params)) return each.instance;
  }
  return shared_.emplace_back(Shared{&part, create(part, 0, number_)}).instance;
}

LocalModel Assembly::local_model() {
  plugin::Predictor self(create(plan_->self(), REGISTA_SUBJECT_SELF, number_));
  plugin::Predictor ball(create(plan_->ball(), REGISTA_SUBJECT_BALL, number_));
  plugin::Predictor opponents(create(plan_->opponents(), REGISTA_SUBJECT_OPPONENTS, number_));
  plugin::Predictor teammates(create(plan_->opponents(), REGISTA_SUBJECT_OPPONENTS, number_));
  return {*plan_, std::move(self), std::move(ball), std::move(opponents), std::move(teammates)};
}

TeamModel Assembly::team_model() {
  const int team_size = plan_->rules().team_size;
  // These predictors have the same random stream in every robot, so that the common world is the same in every robot.
  constexpr int everyone = 0;
  plugin::Predictor teammates(create(plan_->teammates(), REGISTA_SUBJECT_TEAMMATES, everyone));
  std::vector<plugin::Predictor> balls, opponents;
  for (int number = 1; number <= team_size; ++number) {
    balls.emplace_back(create(plan_->ball(), REGISTA_SUBJECT_BALL, everyone));
    opponents.emplace_back(create(plan_->opponents(), REGISTA_SUBJECT_OPPONENTS, everyone));
  }
  return {team_size, plan_->robot().camera, std::move(teammates), std::move(balls), std::move(opponents)};
}

std::vector<ContextParts> Assembly::contexts() {
  std::vector<ContextParts> out;
  for (const ContextPlan& context : plan_->contexts()) {
    plugin::Context condition(create(context.condition, 0, number_));
    std::optional<plugin::Positioner> positioner;
    if (context.positioner) positioner.emplace(shared(*context.positioner));
    std::vector<plugin::Utility> terms;
    for (const TermPart& term : context.terms) terms.emplace_back(shared(term.part));
    plugin::Assigner assigner(shared(context.assigner));
    plugin::Sender sender(shared(context.sender));
    out.push_back(
        {std::move(condition), std::move(positioner), std::move(terms), std::move(assigner), std::move(sender)});
  }
  return out;
}

std::vector<plugin::Behaviour> Assembly::behaviours() {
  std::vector<plugin::Behaviour> out;
  for (const BehaviourPlan& each : plan_->behaviours()) out.emplace_back(shared(each.part));
  return out;
}

}  // namespace regista::mind
