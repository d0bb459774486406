// SPDX-License-Identifier: MIT
// The calls of each kind of plugin, with checks of answers. Constructors throw Failure for a plugin of another kind.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "plugin/instance.hpp"
#include "plugin/predictor.hpp"

namespace regista::plugin {

class Context : CallsOfKind<regista_context, REGISTA_KIND_CONTEXT> {
 public:
  explicit Context(std::shared_ptr<Instance> instance) : CallsOfKind(std::move(instance)) {}

  // Returns whether the context's condition holds now. Must be called once per decision for every context.
  bool holds(const regista_frame& frame);
};

// The answer of a positioner: points in the field frame, edges between points, and the cells of robots. Cell c has the
// vertices [c.first, c.first + c.count), counter-clockwise.
struct Placement {
  std::vector<regista_waypoint> points;
  std::vector<regista_edge> edges;
  std::vector<regista_cell> cells;
  std::vector<regista_vertex> vertices;
};

class Positioner : CallsOfKind<regista_positioner, REGISTA_KIND_POSITIONER> {
 public:
  static constexpr std::uint32_t point_capacity = 256, edge_capacity = 768, cell_capacity = 32, vertex_capacity = 512;

  explicit Positioner(std::shared_ptr<Instance> instance) : CallsOfKind(std::move(instance)) {}

  // Writes the plugin's answer to `out`. Allocates memory only at the first call. Checks that points are finite and
  // inside field and border strip, scores are >= 0, tasks and robots exist, edges join existing points, and cells
  // belong to existing robots and have existing vertices, counter-clockwise.
  void place(const regista_frame& frame, Placement& out);
};

class Utility : CallsOfKind<regista_utility, REGISTA_KIND_UTILITY> {
 public:
  explicit Utility(std::shared_ptr<Instance> instance);

  // Returns the utility of each active robot (row) for each task (column). The numbers are valid until the next call of
  // score() for the same robot. An entry that the plugin does not write is 0. An empty matrix needs no call of the
  // plugin. Checks that every entry is finite and in [0, 1e12].
  std::span<const double> score(const regista_frame& frame, std::size_t rows, std::size_t columns);
};

class Assigner : CallsOfKind<regista_assigner, REGISTA_KIND_ASSIGNER> {
 public:
  explicit Assigner(std::shared_ptr<Instance> instance);

  // Writes the column of row i to out[i], or REGISTA_NO_TASK or REGISTA_UNKNOWN_TASK. `out` must have one element for
  // each row of the matrix. Checks that columns exist, that no utility of an assigned pair is -infinity, and, unless
  // negotiates(), that no column is assigned twice.
  void assign(const regista_frame& frame, const regista_matrix& utilities, std::span<std::int32_t> out);

  // Returns whether the robots of this assigner negotiate. Until they agree, two robots may choose the same task.
  bool negotiates() const { return (calls_->flags & REGISTA_ASSIGNER_NEGOTIATES) != 0; }

 private:
  std::vector<std::int32_t> row_of_column_;
};

class Behaviour : CallsOfKind<regista_behaviour, REGISTA_KIND_BEHAVIOUR> {
 public:
  explicit Behaviour(std::shared_ptr<Instance> instance) : CallsOfKind(std::move(instance)) {}

  // Returns the robot's action until its next decision. The reference is valid until the next call. Checks that the
  // numbers of the chosen motion are finite and in range, that enumerators exist, and that the robot can do the kick.
  const regista_action& act(const regista_frame& frame, const regista_body& body);
};

struct SendDecision {
  bool send = false;
  int reason = REGISTA_EVENT_PERIOD;       // REGISTA_EVENT_* or one of the sender's own reasons, if `send`
  std::span<const std::uint64_t> granted;  // handles of the offers to send, in this order; valid until the next call
};

class Sender : CallsOfKind<regista_sender, REGISTA_KIND_SENDER> {
 public:
  explicit Sender(std::shared_ptr<Instance> instance);

  // The caller must call this function at every decision in the phases Ready, Set and Playing. Checks that the reason
  // exists, that granted handles are in `offers`, and that no handle is granted twice.
  SendDecision decide(const regista_frame& frame, std::span<const regista_event> events,
                      std::span<const regista_offer> offers, const regista_budget& budget);
};

class Mailbox : CallsOfKind<regista_mailbox, REGISTA_KIND_MAILBOX> {
 public:
  // Returns the mailbox of a plugin, or nothing if the plugin takes no messages.
  static std::optional<Mailbox> of(std::shared_ptr<Instance> instance);

  void transmitted(std::uint64_t handle);  // the host sent this offer in a packet
  void dropped(std::uint64_t handle);      // this offer expired, was replaced or was withdrawn
  void receive(const regista_message& message);
  // Returns the meaning of a plugin's message in one line, for recordings. Empty if the plugin gives no text.
  std::string describe(std::span<const std::uint8_t> bytes);

 private:
  explicit Mailbox(std::shared_ptr<Instance> instance) : CallsOfKind(std::move(instance)) {}
};

}  // namespace regista::plugin
