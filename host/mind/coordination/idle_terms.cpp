// SPDX-License-Identifier: MIT
#include "mind/coordination/idle_terms.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <random>

#include "mind/assembly.hpp"
#include "mind/coordination/coordination.hpp"
#include "mind/geometry.hpp"

namespace regista::mind {
namespace {

constexpr int scenes = 8;
constexpr int matrices = 4;       // for each scene, to find out what the assigner heeds
constexpr double interval = 3.7;  // s between scenes, so that roles are held for a while
constexpr std::uint64_t seed = 1;

// The standard's distributions differ between libraries, its generator does not.
class Dice {
 public:
  double real(double low, double high) {
    const double share = static_cast<double>(random_() >> 11) * 0x1p-53;
    return low + share * (high - low);
  }
  // Sixteenths, whose sums are exact: equal sums stay equal.
  double sixteenths(double most) { return std::floor(real(0.0, 16.0 * most)) / 16.0; }

 private:
  std::mt19937_64 random_{seed};
};

// Everybody somewhere on the field with a role of the list, everything known. From the seventh scene on one robot is
// out of play.
void make_up(Snapshot& world, const TeamPlan& plan, int list, int scene, double time, int own, Dice& dice) {
  const double x = plan.rules().field.length / 2.0, y = plan.rules().field.width / 2.0;
  const int team_size = plan.rules().team_size;
  const auto roles = static_cast<int>(plan.team().role_lists[static_cast<std::size_t>(list)].roles.size());
  for (int number = 1; number <= team_size; ++number) {
    regista_robot& robot = world.robot(number);
    const bool out_of_play = scene >= scenes - 2 && team_size > 2 && number == 1 + scene % (team_size - 1);
    robot.flags = REGISTA_ROBOT_KNOWN | REGISTA_ROBOT_HAS_TARGET;
    robot.flags |= out_of_play ? REGISTA_ROBOT_PENALISED : REGISTA_ROBOT_ACTIVE;
    if (number == own) robot.flags |= REGISTA_ROBOT_SELF;
    robot.pose[0] = dice.real(-x, x);
    robot.pose[1] = dice.real(-y, y);
    robot.pose[2] = dice.real(-pi, pi);
    robot.velocity[0] = dice.real(-0.2, 0.2);
    robot.velocity[1] = dice.real(-0.2, 0.2);
    for (const std::size_t k : {0u, 4u, 8u}) robot.covariance[k] = 0.01;
    robot.target[0] = dice.real(-x, x);
    robot.target[1] = dice.real(-y, y);
    robot.age = number == own ? 0.0 : dice.real(0.0, 5.0);
    robot.role = plan.first_role(list) + (number + scene) % roles;
    robot.role_since = time - dice.real(0.0, 20.0);
  }
  for (int k = 0; k < team_size; ++k) {
    regista_opponent& opponent = world.opponents.emplace_back();
    opponent = {};
    opponent.label = k;
    opponent.position[0] = dice.real(-x, x);
    opponent.position[1] = dice.real(-y, y);
    opponent.covariance[0] = opponent.covariance[3] = 0.04;
    opponent.weight = 0.9;
  }
  regista_ball& ball = world.raw.ball;
  ball.flags = REGISTA_BALL_KNOWN;
  ball.position[0] = dice.real(-x, x);
  ball.position[1] = dice.real(-y, y);
  ball.velocity[0] = dice.real(-1.0, 1.0);
  ball.velocity[1] = dice.real(-1.0, 1.0);
  for (const std::size_t k : {0u, 5u, 10u, 15u}) ball.covariance[k] = 0.01;
  world.raw.game.phase = REGISTA_PHASE_PLAYING;
  world.raw.game.half = 1;
  world.raw.game.phase_time = time;
  world.raw.game.time_left = plan.rules().durations.half - time;
  world.close();
}

bool talks(const Part& part) { return plugin::implements(*part.found, REGISTA_KIND_MAILBOX); }

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
  instance->reset(seed);
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
    std::vector<double> utilities = decision.utility, shift(columns);
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

}  // namespace

std::vector<bool> idle_terms(const TeamPlan& plan, plugin::Noting noting) {
  const int own = plan.rules().team_size;
  plugin::AnswerRooms rooms;
  const plugin::Caller caller{plan.team().name, own, 0, noting, &rooms};
  Mailboxes mailboxes(static_cast<std::size_t>(plan.rules().messages.size));
  Assembly assembly(plan, own, seed, mailboxes, caller);
  Coordination coordination(plan, own, assembly.contexts());
  Dice dice;
  std::vector<bool> out;
  for (std::size_t c = 0; c < plan.contexts().size(); ++c) {
    const ContextPlan& context = plan.contexts()[c];
    std::vector<bool> idle;
    for (const TermPart& term : context.terms) idle.push_back(term.weight != 0.0 && !talks(term.part));
    bool open = answers_for_itself(context.assigner) && std::ranges::find(idle, true) != idle.end(), seen = false;
    double time = 0.0;
    for (int scene = 0; open && scene < scenes; ++scene) {
      time += interval;
      Snapshot world(plan.rules().team_size);
      make_up(world, plan, plan.team().contexts[c].role_list, scene, time, own, dice);
      const Decision& decision =
          coordination.decide_in(static_cast<int>(c), world, time, static_cast<std::uint64_t>(scene));
      const std::size_t rows = decision.rows(), columns = decision.columns.size();
      if (rows < 2 || columns == 0) continue;
      seen = true;
      for (std::size_t k = 0; k < idle.size(); ++k) {
        idle[k] = idle[k] && rows_are_equal(decision.terms[k], rows, columns);
      }
      open =
          std::ranges::find(idle, true) != idle.end() && !heeds_columns(plan, context.assigner, caller, decision, dice);
    }
    if (!open || !seen) idle.assign(idle.size(), false);
    out.insert(out.end(), idle.begin(), idle.end());
  }
  return out;
}

std::vector<config::Warning> idle_term_warnings(const TeamPlan& plan, const std::vector<bool>& idle) {
  struct Found {
    const TermPart* term;
    const config::UtilityTerm* page;
    std::string assigner;
    bool everywhere;
  };
  std::vector<Found> all;
  std::size_t next = 0;
  for (std::size_t c = 0; c < plan.contexts().size(); ++c) {
    const ContextPlan& context = plan.contexts()[c];
    for (std::size_t k = 0; k < context.terms.size(); ++k) {
      const TermPart& term = context.terms[k];
      const bool is_idle = idle.at(next++);
      if (term.weight == 0.0) continue;
      const auto same = std::ranges::find_if(all, [&](const Found& each) { return each.term->name == term.name; });
      if (same == all.end()) {
        all.push_back({&term, &plan.team().contexts[c].terms[k], context.assigner.use.plugin, is_idle});
      } else {
        same->everywhere = same->everywhere && is_idle;
      }
    }
  }
  std::vector<config::Warning> out;
  for (const Found& each : all) {
    if (!each.everywhere) continue;
    out.push_back(
        {each.page->use.where,
         fmt::format("utility.terms.{}: {} gives all robots the same number for a task, which changes nothing "
                     "that {} decides; weight: 0 leaves it out",
                     each.term->name, each.term->part.use.plugin, each.assigner)});
  }
  return out;
}

}  // namespace regista::mind
