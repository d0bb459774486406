// SPDX-License-Identifier: MIT
#include "mind/coordination/unused_parts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <span>
#include <utility>

#include "mind/assembly.hpp"
#include "mind/coordination/coordination.hpp"
#include "mind/mind.hpp"
#include "mind/world/mailboxes.hpp"

namespace regista::mind {
namespace {

constexpr int scenes = 8;
constexpr int matrices = 4;       // number of random matrices per scene with which the assigner is tested
constexpr double interval = 3.7;  // s between two scenes: a robot may keep its role for this time or longer

// A robot of a team that decides in made-up scenes.
struct TriedTeam {
  TriedTeam(const TeamPlan& of, plugin::CallTracing tracing)
      : plan(of),
        caller{plan.team().name, own, 0, tracing, &rooms},
        extensions(caller),
        mailboxes(static_cast<std::size_t>(plan.rules().messages.size)),
        assembly(plan, own, made_up_seed, mailboxes, extensions, caller),
        coordination(plan, own, assembly.contexts(), plan.frame_parts()) {}

  // Decides in a new scene. In the last two scenes one robot is out of play. The result is valid until the next call.
  const Decision& decide(std::size_t context, int scene, double time) {
    const bool one_out = scene >= scenes - 2 && own > 2;
    world.emplace(own);
    make_up(*world, plan, plan.team().contexts[context].role_list, scene, time, own,
            one_out ? 1 + scene % (own - 1) : 0, dice);
    world->close();
    return coordination.decide_in(static_cast<int>(context), *world, time, static_cast<std::uint64_t>(scene));
  }

  // Returns a new instance for one call, because an instance may remember the matrix or frame of an earlier call.
  std::shared_ptr<plugin::Instance> fresh(const Part& part) const {
    auto out =
        std::make_shared<plugin::Instance>(*part.found, part.parameters, plan.environment(own), nullptr, &caller);
    out->reset(made_up_seed);
    return out;
  }

  const TeamPlan& plan;
  int own = plan.rules().team_size;  // the robot with the highest number
  plugin::AnswerBuffers rooms;
  plugin::Caller caller;
  Extensions extensions;
  Mailboxes mailboxes;
  Assembly assembly;
  Coordination coordination;
  Dice dice{made_up_seed};
  std::optional<DistributedWorldModel> world;
};

// Returns whether the assigner's answer depends on the matrix alone, according to the plugin's description.
bool answers_for_itself(const Part& assigner) {
  return (assigner.found->description->assigner_flags() & REGISTA_ASSIGNER_NEGOTIATES) == 0 &&
         assigner.found->description->kinds() == std::vector<int>{REGISTA_KIND_ASSIGNER};
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

std::vector<std::int32_t> assigned(const TriedTeam& team, const Part& assigner, const Decision& decision,
                                   const std::vector<double>& utilities) {
  std::vector<std::int32_t> out(decision.rows(), REGISTA_NO_TASK);
  plugin::Assigner(team.fresh(assigner))
      .assign(decision.frame, matrix(utilities, out.size(), decision.columns.size()), out);
  return out;
}

// Returns whether a number added to each column of the matrix (one number for each column) ever changes the assignment.
bool heeds_columns(TriedTeam& team, const Part& assigner, const Decision& decision) {
  const std::size_t columns = decision.columns.size();
  for (int k = 0; k < matrices; ++k) {
    std::vector<double> utilities = decision.utility.values(), shift(columns);
    for (double& each : utilities) each = std::isfinite(each) ? team.dice.sixteenths(16.0) : each;
    for (double& each : shift) each = team.dice.sixteenths(k % 2 == 0 ? 16.0 : 256.0);
    std::vector<double> shifted = utilities;
    for (std::size_t i = 0; i < shifted.size(); ++i) shifted[i] += shift[i % columns];
    if (assigned(team, assigner, decision, utilities) != assigned(team, assigner, decision, shifted)) return true;
  }
  return false;
}

bool all_are_equal(const std::vector<double>& term) {
  return std::ranges::all_of(term, [&](double each) { return each == term.front(); });
}

// Returns one free waypoint, one waypoint for each task and one waypoint for each robot.
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

std::vector<double> scored(const TriedTeam& team, const Part& term, const Decision& decision,
                           const regista_frame& frame) {
  plugin::Utility utility(team.fresh(term));
  const std::span<const double> out = utility.score(frame, decision.rows(), decision.columns.size());
  return {out.begin(), out.end()};
}

// Returns, for each term of the context, whether the search must examine the term.
std::vector<bool> in_question(const ContextPlan& context) {
  std::vector<bool> out;
  for (const TermPart& term : context.terms) out.push_back(term.weight != 0.0 && !talks(term.part));
  return out;
}

bool any(const std::vector<bool>& list) { return std::ranges::find(list, true) != list.end(); }

// Returns text such as "context a" or "contexts a and b".
std::string contexts_text(const std::vector<std::string>& names) {
  return fmt::format("{} {}", names.size() == 1 ? "context" : "contexts",
                     fmt::join(names, names.size() == 2 ? " and " : ", "));
}

constexpr double seconds = 3.0;
constexpr std::uint64_t seed = 1;

// Makes percepts in Playing: the robots stand in a row in their own half and see the ball on the centre mark.
Percepts percepts_of(int number, int decision, const TeamPlan& plan) {
  const config::Rules& rules = plan.rules();
  Percepts out;
  out.time = decision * plan.robot().decision_period;
  const double x = -0.25 * rules.field.length, apart = rules.field.width / (rules.team_size + 1);
  const Pose pose{x, number * apart - 0.5 * rules.field.width, 0.0};
  if (decision == 0) out.placed = PlacedPose{pose, 0.05, 0.05};
  out.balls.push_back({{-pose.x, -pose.y}, 0.05, 0.05});
  out.game.phase = Phase::playing;
  out.game.phase_time = out.time;
  out.game.half_time_left = rules.durations.half - out.time;
  out.game.match_time_left = rules.durations.halves * rules.durations.half - out.time;
  out.game.packets_left = rules.messages.budget;
  return out;
}

}  // namespace

std::vector<bool> idle_terms(const TeamPlan& plan, plugin::CallTracing tracing) {
  TriedTeam team(plan, tracing);
  std::vector<bool> out;
  for (std::size_t c = 0; c < plan.contexts().size(); ++c) {
    const Part& assigner = plan.contexts()[c].assigner;
    std::vector<bool> idle = in_question(plan.contexts()[c]);
    bool open = answers_for_itself(assigner) && any(idle), seen = false;
    double time = 0.0;
    for (int scene = 0; open && scene < scenes; ++scene) {
      time += interval;
      const Decision& decision = team.decide(c, scene, time);
      const std::size_t rows = decision.rows(), columns = decision.columns.size();
      if (rows < 2 || columns == 0) continue;
      seen = true;
      for (std::size_t k = 0; k < idle.size(); ++k) {
        idle[k] = idle[k] && rows_are_equal(decision.utility.terms()[k], rows, columns);
      }
      open = any(idle) && !heeds_columns(team, assigner, decision);
    }
    if (!open || !seen) idle.assign(idle.size(), false);
    out.insert(out.end(), idle.begin(), idle.end());
  }
  return out;
}

std::vector<bool> terms_without_waypoints(const TeamPlan& plan, plugin::CallTracing tracing) {
  TriedTeam team(plan, tracing);
  std::vector<bool> out;
  for (std::size_t c = 0; c < plan.contexts().size(); ++c) {
    const ContextPlan& context = plan.contexts()[c];
    std::vector<bool> constant = in_question(context), reads(context.terms.size(), false);
    const bool open = !context.positioner && any(constant);
    for (int scene = 0; open && scene < scenes; ++scene) {
      const Decision& decision = team.decide(c, scene, interval * (scene + 1));
      const std::vector<regista_waypoint> waypoints = made_up_waypoints(plan, decision, team.dice);
      regista_frame frame = decision.frame;
      frame.waypoints = abi_span(waypoints);
      for (std::size_t k = 0; k < constant.size(); ++k) {
        constant[k] = constant[k] && all_are_equal(decision.utility.terms()[k]);
        if (!constant[k]) continue;
        reads[k] = reads[k] || !all_are_equal(scored(team, context.terms[k].part, decision, frame));
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
    bool idle = true;                  // the term is idle in all contexts in which it has a weight
    bool has_waypoints = false;        // the term has waypoints in some context, or needs no waypoints
    std::vector<std::string> lacking;  // names of the contexts in which the term lacks waypoints
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
      out.push_back({each.page->use.where, fmt::format("utility.terms.{}: {} rewards nearness to waypoints, which {} "
                                                       "{} no positioner to make: it changes nothing{}",
                                                       each.term->name, plugin, where, one ? "has" : "have",
                                                       each.has_waypoints ? " there" : "")});
    }
    if (!each.idle || !each.has_waypoints) continue;
    out.push_back(
        {each.page->use.where, fmt::format("utility.terms.{}: {} gives all robots the same number for a task, which "
                                           "changes nothing that {} decides; weight: 0 leaves it out",
                                           each.term->name, plugin, each.assigner)});
  }
  return out;
}

std::vector<double> guarded_shares(const TeamPlan& plan, plugin::CallTracing tracing) {
  constexpr int line_ups = 40;
  TriedTeam team(plan, tracing);
  const double behind = -2.0 / 9.0 * plan.rules().field.length, aside = plan.rules().field.width / 3.0;
  std::vector<double> out;
  for (std::size_t c = 0; c < plan.contexts().size(); ++c) {
    const bool asked = plan.contexts()[c].positioner && !talks(*plan.contexts()[c].positioner) &&
                       plan.team().contexts[c].tasks.keep == config::TaskRules::Keep::nearest_to_waypoints;
    int guarded = 0;
    for (int scene = 0; asked && scene < line_ups; ++scene) {
      const Decision& decision = team.decide(c, scene % scenes, interval * (scene + 1));
      guarded += std::ranges::any_of(decision.placement.points, [&](const regista_waypoint& each) {
        return each.x < behind && std::abs(each.y) < aside;
      });
    }
    out.push_back(asked ? static_cast<double>(guarded) / line_ups : 1.0);
  }
  return out;
}

std::vector<config::Warning> guard_warnings(const TeamPlan& plan, const std::vector<double>& shares) {
  std::vector<config::Warning> out;
  for (std::size_t c = 0; c < shares.size(); ++c) {
    if (shares[c] >= 0.5) continue;
    const config::PluginUse& positioner = plan.contexts()[c].positioner->use;
    if (!out.empty() && out.back().where == positioner.where) continue;
    out.push_back(
        {positioner.where,
         fmt::format("positioner: {} makes no waypoint before the own goal in {:.0f} % of made-up scenes, and the "
                     "filter keeps the tasks nearest to waypoints: defenders are left out; its sites decide that",
                     positioner.plugin, 100.0 * (1.0 - shares[c]))});
  }
  return out;
}

std::vector<UnsendableSegment> unsendable_segments(const TeamPlan& plan, plugin::CallTracing tracing) {
  const int team_size = plan.rules().team_size;
  std::vector<Mind> minds;
  for (int number = 1; number <= team_size; ++number)
    minds.emplace_back(plan, number, seed, tracing, MindOptions{.segments = true});
  const std::vector<const Part*> parts = plan.parts();
  std::vector<std::uint64_t> longest(parts.size(), 0);
  std::vector<std::pair<int, std::vector<std::uint8_t>>> air, next;  // (sender, packet) of packets in the air
  const int decisions = static_cast<int>(seconds / plan.robot().decision_period);
  for (int decision = 0; decision < decisions; ++decision) {
    for (int number = 1; number <= team_size; ++number) {
      const Percepts percepts = percepts_of(number, decision, plan);
      std::vector<HeardPacket> heard;
      for (const auto& [sender, bytes] : air) {
        if (sender != number) heard.push_back({percepts.time, bytes});
      }
      Mind& mind = minds[static_cast<std::size_t>(number - 1)];
      Outcome outcome;
      mind.think(percepts, heard, outcome);
      if (outcome.send) next.emplace_back(number, std::move(outcome.packet));
      for (const SegmentEvent& event : mind.segments()) {
        if (event.kind != SegmentEvent::Kind::refused || event.why != SegmentEvent::Why::too_long) continue;
        const auto part = std::ranges::find(parts, &mind.part(event.place));
        if (part == parts.end()) continue;
        std::uint64_t& most = longest[static_cast<std::size_t>(part - parts.begin())];
        most = std::max(most, event.length);
      }
    }
    air = std::exchange(next, {});
  }
  std::vector<UnsendableSegment> out;
  for (std::size_t part = 0; part < parts.size(); ++part) {
    if (longest[part] > 0) out.push_back({part, longest[part]});
  }
  return out;
}

std::vector<config::Warning> unsendable_segment_warnings(const TeamPlan& plan,
                                                         const std::vector<UnsendableSegment>& found) {
  const std::size_t room = Mailboxes(static_cast<std::size_t>(plan.rules().messages.size)).bytes_free();
  const std::size_t most = room > segment_heading ? room - segment_heading : 0;
  std::vector<config::Warning> out;
  for (const UnsendableSegment& each : found) {
    const Part& part = *plan.parts()[each.part];
    out.push_back({part.use.where, fmt::format("{} offers segments of {} bytes, and a packet of these rules takes at "
                                               "most {}: its teammates never hear them",
                                               part.use.plugin, each.bytes, most)});
  }
  return out;
}

}  // namespace regista::mind
