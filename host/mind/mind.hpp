// SPDX-License-Identifier: MIT
// One robot, alone: percepts and packets in, a command and perhaps a packet out. Knows neither physics nor truth, so
// the same code could run on a robot or against another simulator.
//
// A decision: sense and predict -> hear -> fuse -> choose context -> place -> filter and offset tasks -> score
// -> assign -> act -> decide to send. All that decides is a plugin.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "mind/command.hpp"
#include "mind/coordination/decision.hpp"
#include "mind/percepts.hpp"
#include "mind/team_plan.hpp"
#include "mind/world/segment_journal.hpp"
#include "mind/world/world_model.hpp"
#include "plugin/call_note.hpp"

namespace regista::mind {

// Whether a mind keeps a journal of what its plugins say to teammates. It costs memory and time and changes nothing.
enum class Journal { none, kept };

class Mind {
 public:
  // `plan` outlives the mind. `seed`: of the match and the side; every plugin instance gets its own stream of it.
  // `noting`: where calls of plugins are noted, if anywhere; outlives the mind. `journal`: of its segments, see below.
  // Throws plugin::Failure when a plugin cannot be created.
  Mind(const TeamPlan& plan, int number, std::uint64_t seed, plugin::Noting noting = {},
       Journal journal = Journal::none);
  ~Mind();
  Mind(Mind&&) noexcept;
  Mind& operator=(Mind&&) noexcept;

  // One decision. Throws plugin::Failure when a plugin fails or breaks a promise.
  void think(const Percepts& percepts, std::span<const HeardPacket> heard, Outcome& out);

  // For recorders: how the last decision came about. Valid until the next one.
  const Decision& decision() const;
  const WorldModel& world() const;
  std::span<const regista_event> events() const;
  // What became of segments at the last decision, in the order in which it happened; nothing without a journal.
  std::span<const SegmentEvent> segments() const;
  int number() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace regista::mind
