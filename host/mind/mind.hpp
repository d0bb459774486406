// SPDX-License-Identifier: MIT
// Mind is the mind of one robot. Its input is percepts and packets; its output is a command and perhaps a packet. A
// mind has no access to physics or true positions, so a mind could run on a robot or in another simulator.
//
// Order of a decision: sense and predict -> hear -> fuse -> choose context -> place -> filter and offset tasks -> score
// -> assign -> act -> decide to send. Plugins make all choices.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "mind/action.hpp"
#include "mind/coordination/coordination.hpp"
#include "mind/extensions/plugin_log.hpp"
#include "mind/percepts.hpp"
#include "mind/team_plan.hpp"
#include "mind/world/packet.hpp"
#include "mind/world/world_model.hpp"
#include "plugin/call_inputs.hpp"

namespace regista::mind {

// What a mind records in addition to its outcomes. No option changes a decision.
struct MindOptions {
  bool whole_frame = false;  // the mind also makes frame parts that no plugin reads (REGISTA_READS_*)
  // For recorders: whether segments() and whether log() and drawings() return what happened in the last decision.
  bool segments = false, drawings = false;
  LogSink log{};  // receives each log line when a plugin writes it
};

class Mind {
 public:
  // `plan` and everything that `tracing` points to must outlive the mind. `seed`: seed of the match and the side; every
  // plugin instance gets its own random stream from the seed. Throws plugin::Failure if a plugin cannot be created.
  Mind(const TeamPlan& plan, int number, std::uint64_t seed, plugin::CallTracing tracing = {},
       MindOptions options = {});
  ~Mind();
  Mind(Mind&&) noexcept;
  Mind& operator=(Mind&&) noexcept;

  // Makes one decision. Throws plugin::Failure if a plugin fails, or gives an invalid answer or report.
  void think(const Percepts& percepts, std::span<const HeardPacket> heard, Outcome& out);

  // For recorders. These functions return the steps of the last decision. Results are valid until the next decision.
  const Decision& decision() const;
  const WorldModel& world() const;
  std::span<const regista_event> events() const;
  // The next three functions return lists in order of time. A list is empty if MindOptions does not enable it.
  std::span<const SegmentEvent> segments() const;
  std::span<const LogLine> log() const;
  std::span<const DrawnShape> drawings() const;
  int number() const;
  // Returns the part of the team's plan whose instance has this place (see mailboxes.hpp).
  const Part& part(int place) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> parts_;
};

}  // namespace regista::mind
