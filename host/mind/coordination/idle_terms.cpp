// SPDX-License-Identifier: MIT
#include "mind/coordination/idle_terms.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>

#include "mind/assembly.hpp"
#include "mind/coordination/coordination.hpp"
#include "mind/coordination/made_up.hpp"

namespace regista::mind {
namespace {

constexpr int scenes = 8;
constexpr int matrices = 4;       // for each scene, to find out what the assigner heeds
constexpr double interval = 3.7;  // s between scenes, so that roles are held for a while

// From the seventh scene on one robot is out of play.
void make_up_scene(DistributedWorldModel& world, const TeamPlan& plan, int list, int scene, double time, int own,
                   Dice& dice) {
  const int team_size = plan.rules().team_size;
  const bool one_out = scene >= scenes - 2 && team_size > 2;
  make_up(world, plan, list, scene, time, own, one_out ? 1 + scene % (team_size - 1) : 0, dice);
  world.close();
}

// Whether what it answers follows from its matrix, as far as can be known: not of teammates, nor of another step.
bool answers_for_itself(const Part& assigner) {
  return (plugin::assigner_flags(*assigner.found) & REGISTA_ASSIGNER_NEGOTIATES) == 0 &&
         plugin::kinds(*assigner.found) == std::vector<int>{REGISTA_KIND_ASSIGNER};
}

bool rows_are_equal(const std::vector<double>& term, std::size_t rows, std::size_t columns) {
  for (std::size_t i = 1; i < rows; ++i) {
    if (!std::equal(term.begin(), term.begin() + static_cast<std::ptrdiff_t>(columns),
                    term.begin() + static_cast<std::ptrdiff_t>(i * columns))) {
      return false;
    }
  }
  return true;
}

// A fresh one for each call: what it remembers is of no other matrix.
std::vector<std::int32_t> assigned(const TeamPlan& plan, const Part& assigner, const plugin::Caller& caller,
                                   const Decision& decision, std::vector<double>& utilities) {
  auto instance = std::make_shared<plugin::Instance>(*assigner.found, assigner.parameters,
                                                     plan.environment(caller.robot), nullptr, &caller);
  instance->reset(made_up_seed);
  const auto columns = static_cast<std::uint32_t>(decision.columns.size());
  std::vector<std::int32_t> out(decision.rows(), REGISTA_NO_TASK);
  plugin::Assigner(std::move(instance))
      .assign(decision.frame, {utilities.data(), static_cast<std::uint32_t>(out.size()), columns, columns, 0}, out);
  return out;
}

// Whether a number for each column ever changed the assignment, in the place of this decision.
bool heeds_columns(const TeamPlan& plan, const Part& assigner, const plugin::Caller& caller, const Decision& decision,
                   Dice& dice) {
  const std::size_t columns = decision.columns.size();
  for (int k = 0; k < matrices; ++k) {
    std::vector<double> utilities = decision.utility.values(), shift(columns);
    for (double& each : utilities) each = std::isfinite(each) ? dice.sixteenths(16.0) : each;
    for (double& each : shift) each = dice.sixteenths(k % 2 == 0 ? 16.0 : 256.0);
    std::vector<double> shifted = utilities;
    for (std::size_t i = 0; i < shifted.size(); ++i) shifted[i] += shift[i % columns];
    if (assigned(plan, assigner, caller, decision, utilities) != assigned(plan, assigner, caller, decision, shifted)) {
      return true;
    }
  }
  return false;
}

bool all_are_equal(const std::vector<double>& term) {
  return std::ranges::all_of(term, [&](double each) { return each == term.front(); });
}

// One of no task and no robot, one of each.
std::vector<regista_waypoint> made_up_waypoints(const TeamPlan& plan, const Decision& decision, Dice& dice) {
  const double x = plan.rules().field.length / 2.0, y = plan.rules().field.width / 2.0;
  std::vector<regista_waypoint> out;
  const auto add = [&](int task, int robot) {
    regista_waypoint& point = out.emplace_back();
    point = {};
    point.x = dice.real(-x, x);
    point.y = dice.real(-y, y);
    point.score = dice.real(0.5, 1.0);
    point.task = task;
    point.robot = robot;
  };
  add(-1, 0);
  for (std::size_t j = 0; j < decision.columns.size(); ++j) add(static_cast<int>(j), 0);
  for (int number = 1; number <= plan.rules().team_size; ++number) add(-1, number);
  return out;
}

// By a fresh one: what it remembers is of no other frame.
std::vector<double> scored(const TeamPlan& plan, const Part& term, const plugin::Caller& caller,
                           const Decision& decision, const regista_frame& frame) {
  auto instance = std::make_shared<plugin::Instance>(*term.found, term.parameters, plan.environment(caller.robot),
                                                     nullptr, &caller);
  instance->reset(made_up_seed);
  plugin::Utility utility(std::move(instance));
  const std::span<const double> out = utility.score(frame, decision.rows(), decision.columns.size());
  return {out.begin(), out.end()};
}

// "context a", "contexts a and b"
std::string contexts_text(const std::vector<std::string>& names) {
  return fmt::format("{} {}", names.size() == 1 ? "context" : "contexts",
                     fmt::join(names, names.size() == 2 ? " and " : ", "));
}

}  // namespace

std::vector<bool> idle_terms(const TeamPlan& plan, plugin::Noting noting) {
  const int own = plan.rules().team_size;
  plugin::AnswerRooms rooms;
  const plugin::Caller caller{plan.team().name, own, 0, noting, &rooms};
  Extensions extensions(caller);
  Mailboxes mailboxes(static_cast<std::size_t>(plan.rules().messages.size));
  Assembly assembly(plan, own, made_up_seed, mailboxes, extensions, caller);
  Coordination coordination(plan, own, assembly.contexts(), FrameParts(plan));
  Dice dice(made_up_seed);
  std::vector<bool> out;
  for (std::size_t c = 0; c < plan.contexts().size(); ++c) {
    const ContextPlan& context = plan.contexts()[c];
    std::vector<bool> idle;
    for (const TermPart& term : context.terms) idle.push_back(term.weight != 0.0 && !talks(term.part));
    bool open = answers_for_itself(context.assigner) && std::ranges::find(idle, true) != idle.end(), seen = false;
    double time = 0.0;
    for (int scene = 0; open && scene < scenes; ++scene) {
      time += interval;
      DistributedWorldModel world(plan.rules().team_size);
      make_up_scene(world, plan, plan.team().contexts[c].role_list, scene, time, own, dice);
      const Decision& decision =
          coordination.decide_in(static_cast<int>(c), world, time, static_cast<std::uint64_t>(scene));
      const std::size_t rows = decision.rows(), columns = decision.columns.size();
      if (rows < 2 || columns == 0) continue;
      seen = true;
      for (std::size_t k = 0; k < idle.size(); ++k) {
        idle[k] = idle[k] && rows_are_equal(decision.utility.terms()[k], rows, columns);
      }
      open =
          std::ranges::find(idle, true) != idle.end() && !heeds_columns(plan, context.assigner, caller, decision, dice);
    }
    if (!open || !seen) idle.assign(idle.size(), false);
    out.insert(out.end(), idle.begin(), idle.end());
  }
  return out;
}

std::vector<bool> terms_without_waypoints(const TeamPlan& plan, plugin::Noting noting) {
  const int own = plan.rules().team_size;
  plugin::AnswerRooms rooms;
  const plugin::Caller caller{plan.team().name, own, 0, noting, &rooms};
  Extensions extensions(caller);
  Mailboxes mailboxes(static_cast<std::size_t>(plan.rules().messages.size));
  Assembly assembly(plan, own, made_up_seed, mailboxes, extensions, caller);
  Coordination coordination(plan, own, assembly.contexts(), FrameParts(plan));
  Dice dice(made_up_seed);
  std::vector<bool> out;
  for (std::size_t c = 0; c < plan.contexts().size(); ++c) {
    const ContextPlan& context = plan.contexts()[c];
    std::vector<bool> constant, reads(context.terms.size(), false);
    for (const TermPart& term : context.terms) constant.push_back(term.weight != 0.0 && !talks(term.part));
    const bool open = !context.positioner && std::ranges::find(constant, true) != constant.end();
    for (int scene = 0; open && scene < scenes; ++scene) {
      const double time = interval * (scene + 1);
      DistributedWorldModel world(plan.rules().team_size);
      make_up_scene(world, plan, plan.team().contexts[c].role_list, scene, time, own, dice);
      const Decision& decision =
          coordination.decide_in(static_cast<int>(c), world, time, static_cast<std::uint64_t>(scene));
      const std::vector<regista_waypoint> waypoints = made_up_waypoints(plan, decision, dice);
      regista_frame frame = decision.frame;
      frame.waypoints = {waypoints.data(), static_cast<std::uint32_t>(waypoints.size()), sizeof(regista_waypoint)};
      for (std::size_t k = 0; k < constant.size(); ++k) {
        constant[k] = constant[k] && all_are_equal(decision.utility.terms()[k]);
        if (!constant[k]) continue;
        reads[k] = reads[k] || !all_are_equal(scored(plan, context.terms[k].part, caller, decision, frame));
      }
    }
    for (std::size_t k = 0; k < constant.size(); ++k) out.push_back(open && constant[k] && reads[k]);
  }
  return out;
}

std::vector<config::Warning> idle_term_warnings(const TeamPlan& plan, const std::vector<bool>& idle,
                                                const std::vector<bool>& without_waypoints) {
  struct Found {
    const TermPart* term;
    const config::UtilityTerm* page;
    std::string assigner;
    bool idle = true;                  // in all contexts
    bool has_waypoints = false;        // in some context, or needs none
    std::vector<std::string> lacking;  // contexts without waypoints
  };
  std::vector<Found> all;
  std::size_t next = 0;
  for (std::size_t c = 0; c < plan.contexts().size(); ++c) {
    const ContextPlan& context = plan.contexts()[c];
    for (std::size_t k = 0; k < context.terms.size(); ++k, ++next) {
      const TermPart& term = context.terms[k];
      if (term.weight == 0.0) continue;
      const auto same = std::ranges::find_if(all, [&](const Found& each) { return each.term->name == term.name; });
      Found& found = same != all.end()
                         ? *same
                         : all.emplace_back(Found{
                               &term, &plan.team().contexts[c].terms[k], context.assigner.use.plugin, true, false, {}});
      found.idle = found.idle && idle.at(next);
      if (without_waypoints.at(next)) {
        found.lacking.push_back(plan.team().contexts[c].name);
      } else {
        found.has_waypoints = true;
      }
    }
  }
  std::vector<config::Warning> out;
  for (const Found& each : all) {
    const std::string& plugin = each.term->part.use.plugin;
    if (!each.lacking.empty()) {
      const std::string where = each.has_waypoints ? contexts_text(each.lacking) : "the team";
      const bool one = !each.has_waypoints || each.lacking.size() == 1;
      out.push_back(
          {each.page->use.where,
           fmt::format("utility.terms.{}: {} rewards nearness to waypoints, which {} {} no positioner to "
                       "make: it changes nothing{}",
                       each.term->name, plugin, where, one ? "has" : "have", each.has_waypoints ? " there" : "")});
    }
    if (!each.idle || !each.has_waypoints) continue;
    out.push_back(
        {each.page->use.where,
         fmt::format("utility.terms.{}: {} gives all robots the same number for a task, which changes nothing "
                     "that {} decides; weight: 0 leaves it out",
                     each.term->name, plugin, each.assigner)});
  }
  return out;
}

}  // namespace regista::mind
