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
#include "mind/extensions/drawings.hpp"
#include "mind/extensions/log_line.hpp"
#include "mind/percepts.hpp"
#include "mind/team_plan.hpp"
#include "mind/world/segment_journal.hpp"
#include "mind/world/world_model.hpp"
#include "plugin/call_note.hpp"

namespace regista::mind {

// What a mind tells beside its outcomes. None of it changes what it decides.
struct Telling {
  // Makes every part of the frame, also those that no plugin of the team reads (REGISTA_READS_*).
  bool whole_frame = false;
  // Keeps what recorders want of the last decision, at the cost of memory and time: what became of segments; what
  // plugins logged and drew.
  bool segments = false, drawings = false;
  LogSink log{};  // told each line that a plugin writes, at once
};

class Mind {
 public:
  // `plan` outlives the mind. `seed`: of the match and the side; every plugin instance gets its own stream of it.
  // `noting`: where calls of plugins are noted, if anywhere; outlives the mind.
  // Throws plugin::Failure when a plugin cannot be created.
  Mind(const TeamPlan& plan, int number, std::uint64_t seed, plugin::Noting noting = {}, Telling telling = {});
  ~Mind();
  Mind(Mind&&) noexcept;
  Mind& operator=(Mind&&) noexcept;

  // One decision. Throws plugin::Failure when a plugin fails or breaks a promise.
  void think(const Percepts& percepts, std::span<const HeardPacket> heard, Outcome& out);

  // For recorders: how the last decision came about. Valid until the next one.
  const Decision& decision() const;
  const WorldModel& world() const;
  std::span<const regista_event> events() const;
  // Nothing of these where a mind does not keep them. What became of segments at the last decision, in the order in
  // which it happened; what plugins wrote; what they drew, in the order of drawing.
  std::span<const SegmentEvent> segments() const;
  std::span<const LogLine> log() const;
  std::span<const DrawnShape> drawings() const;
  int number() const;
  // Of the team's plan: what the plugin of a segment event is there for.
  const Part& part(int place) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace regista::mind
