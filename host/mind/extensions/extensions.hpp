// SPDX-License-Identifier: MIT
// The host's implementation of the extensions that a robot's plugins may request by name: log, draw, metric, pass,
// told, budget, roles. Each instance gets its own function tables, so that the host knows which plugin calls.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include <regista/extensions/budget.h>
#include <regista/extensions/draw.h>
#include <regista/extensions/log.h>
#include <regista/extensions/metric.h>
#include <regista/extensions/pass.h>
#include <regista/extensions/roles.h>
#include <regista/extensions/told.h>

#include "mind/extensions/plugin_log.hpp"
#include "mind/world/packet.hpp"
#include "plugin/description.hpp"
#include "plugin/fatal_signal.hpp"

namespace regista::mind {

class Extensions;

class InstanceExtensions {
 public:
  InstanceExtensions(Extensions& owner, const plugin::Found& plugin, std::span<const int> metrics, int place);
  InstanceExtensions(const InstanceExtensions&) = delete;
  InstanceExtensions& operator=(const InstanceExtensions&) = delete;

  // Returns the function table of the extension `id`; null for an unknown name.
  const void* find(std::string_view id) const;

 private:
  static InstanceExtensions& of(void* context) { return *static_cast<InstanceExtensions*>(context); }
  // Resets the counts of a decision with the first call in it: to reset all at its beginning would fetch all memory.
  void begin_call();

  Extensions* owner_;
  const plugin::Found* plugin_;
  std::span<const int> metrics_;  // the plugin's metrics: indices into TeamPlan::metrics()
  int place_;                     // place of the instance in the robot's mind (see mailboxes.hpp)
  std::uint64_t counted_in_ = 0;  // the decision of the counts in the next two
  LogUse log_use_;
  DrawUse draw_use_;
  regista_log log_{};
  regista_draw draw_{};
  regista_metric_reports metric_reports_{};
  regista_pass pass_{};
  regista_told told_{};
  regista_budget_now budget_{};
  regista_roles roles_{};
};

// A plugin's report that the robot's kick is a pass.
struct MeantPass {
  const plugin::Found* plugin;
  int receiver;  // shirt number that the plugin gave; not yet checked
};

// Functions that the extensions call to answer questions of plugins.
struct Answers {
  std::function<const Report*(int number)> packet;  // newest packet of a robot, which may be this robot; null: none
  std::function<bool()> sees_ball;                  // whether this robot's camera sees the ball; see LocalModel
  std::function<regista_budget()> budget;
};

// Writes the facts about role `id` (a row of the table of roles); returns false if the row does not exist.
using RoleFacts = std::function<bool(int id, regista_role_facts& out)>;

class Extensions {
 public:
  // `caller` must outlive the extensions. sink: receives each log line when the plugin writes it. records: whether the
  // log lines and drawings of a decision are kept for recorders.
  explicit Extensions(const plugin::Caller& caller, LogSink sink = {}, bool records = false)
      : log_(caller, std::move(sink), records), drawings_(log_, records) {}
  Extensions(const Extensions&) = delete;
  Extensions& operator=(const Extensions&) = delete;

  // Makes the function tables of the next instance. metrics: indices into TeamPlan::metrics(). Both must outlive this.
  const InstanceExtensions& open(const plugin::Found& plugin, std::span<const int> metrics);

  // Must be called before a plugin asks a question (extensions told, budget).
  void answer_with(Answers answers) { answers_ = std::move(answers); }
  // Must be called before the first instance is created. Sets the answers of the extension roles.
  void tell_roles(RoleFacts roles) { roles_ = std::move(roles); }

  void begin(double time);  // Must be called at the beginning of a decision. time: match time, s.
  // While muted, the extensions log, draw, metric and pass do nothing. Used for plugin calls that only serve recorders.
  void mute(bool muted) { muted_ = muted; }

  const PluginLog& log() const { return log_; }
  const Drawings& drawings() const { return drawings_; }
  MetricReports& metrics() { return metrics_; }
  // The last pass that a plugin reported in this decision; empty: no report.
  const std::optional<MeantPass>& pass() const { return pass_; }

 private:
  friend InstanceExtensions;
  PluginLog log_;
  Drawings drawings_;
  MetricReports metrics_;
  std::optional<MeantPass> pass_;
  Answers answers_;
  RoleFacts roles_;
  bool muted_ = false;
  std::uint64_t decision_ = 0;  // number of calls of begin()
  std::vector<std::unique_ptr<InstanceExtensions>> instances_;
};

}  // namespace regista::mind
