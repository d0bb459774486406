// SPDX-License-Identifier: MIT
// Glue of the behaviour `search`, which ../supporting.hpp and ../gaze.hpp are.
#include <algorithm>
#include <optional>
#include <vector>

#include <regista/behaviour.hpp>

#include "../by_phase.hpp"
#include "../gaze.hpp"
#include "../place_parameters.hpp"
#include "../read_situation.hpp"
#include "../write_action.hpp"

namespace {

struct Search {
  static constexpr auto
      id = "search",
      version = "1.0.0",
      summary = "Turns about at the place of the task, or where it stands; looks through its part of the field";
  static constexpr unsigned reads = REGISTA_READS_FACINGS | REGISTA_READS_PREVIOUS;
  static constexpr unsigned purposes = REGISTA_BEHAVIOUR_SEARCHES;

  behaviours::Conduct conduct;
  behaviours::SearchSettings settings;
  behaviours::LookedAtSettings shared;
  static constexpr std::tuple parameters{
      regista::within(&Search::conduct, behaviours::conduct_parameters),
      regista::within(&Search::settings, behaviours::search_parameters, behaviours::search_turn_parameter),
      regista::within(&Search::shared, behaviours::looked_at_parameters)};

  behaviours::SituationReader reader{behaviours::Duty::other};

  behaviours::LookedAt looked_at;
  std::vector<behaviours::Teammate> teammates;
  std::optional<double> began, searched;  // match times of this search, and of the last decision to search

  void setup(const regista::Environment& environment) {
    reader.setup(environment);
    teammates.reserve(environment->team_size);
    looked_at.begin(reader.facts().field);                      // and so has its memory
    shared.sight = std::max(shared.sight, settings.at_target);  // it goes no nearer, so there it must have looked
  }

  void reset(std::uint64_t) { searched.reset(); }

  void act(const regista::Frame& frame, const regista::Body& body, regista::Action& out) {
    behaviours::Situation situation = reader.read(frame, body, conduct.ball_trusted_for);
    if (situation.phase == behaviours::Phase::playing && !situation.incapable) {
      const bool first = begin(situation);
      if (shared.divides) divide(frame, situation, first);
      if (situation.time - *began < settings.search_turn_seconds)
        situation.has_task = false;  // it turns where it stands
    }
    const behaviours::Movement movement = behaviours::by_phase(
        situation, conduct.legal, [&] { return behaviours::search(situation, settings, conduct.legal); });
    behaviours::write_action(movement, behaviours::look(situation, conduct.gaze), out);
  }

  // Whether this decision is the first of a search.
  bool begin(const behaviours::Situation& situation) {
    constexpr double another_search = 3.0;  // s without one: the ball has been seen, and lies anywhere now
    const bool first = !searched || situation.time - *searched > another_search;
    if (first) began = situation.time;
    searched = situation.time;
    return first;
  }

  // Its target becomes what it should look at next.
  void divide(const regista::Frame& frame, behaviours::Situation& situation, bool first) {
    if (first) looked_at.begin(situation.facts.field);
    behaviours::read_teammates(frame, situation, teammates);
    looked_at.hear(situation, shared, teammates);
    looked_at.see(situation, shared);
    if (!situation.has_task) return;
    const behaviours::Vector2d place(situation.target.x, situation.target.y);
    const auto next = looked_at.next(situation, shared, place, reader.read_targets_of(frame, teammates));
    if (!next) return;
    const behaviours::Vector2d way = *next - situation.frame.origin();
    situation.target = {next->x(), next->y(), behaviours::angle_of(way)};
  }
};

}  // namespace

REGISTA_PLUGIN(Search, regista::behaviour)
