// SPDX-License-Identifier: MIT
// The host's side of the extensions that the plugins of one robot may ask for by name: log, draw, metric, pass, told,
// budget, roles. Each instance gets tables of its own, so that it is known who speaks.
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

#include "mind/extensions/drawings.hpp"
#include "mind/extensions/metric_reports.hpp"
#include "mind/extensions/plugin_log.hpp"
#include "mind/world/packet.hpp"
#include "plugin/failure.hpp"
#include "plugin/found.hpp"

namespace regista::mind {

class Extensions;

// What one instance is given.
class InstanceExtensions {
 public:
  InstanceExtensions(Extensions& owner, const plugin::Found& plugin, std::span<const int> metrics, int place);
  InstanceExtensions(const InstanceExtensions&) = delete;
  InstanceExtensions& operator=(const InstanceExtensions&) = delete;

  // Null for a name that nobody knows.
  const void* find(std::string_view id) const;
  void begin_decision();

 private:
  Extensions* owner_;
  const plugin::Found* plugin_;
  std::span<const int> metrics_;  // of the team, by the plugin's own index
  int place_;
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

// For whom a kick is meant, as a plugin said it.
struct MeantPass {
  const plugin::Found* plugin;
  int receiver;  // not looked at yet
};

// What plugins may ask for. Called from within their calls.
struct Answers {
  std::function<const Report*(int number)> packet;  // the newest of a robot, the own one too; null: none
  std::function<bool()> sees_ball;
  std::function<regista_budget()> budget;
};

// What the page says of the role in a row of the table; false: there is no such row.
using RoleFacts = std::function<bool(int id, regista_role_facts& out)>;

class Extensions {
 public:
  // caller outlives the extensions. sink: told each log line at once. records: log lines and drawings of a decision are
  // kept for recorders.
  explicit Extensions(const plugin::Caller& caller, LogSink sink = {}, bool records = false)
      : log_(caller, std::move(sink), records), drawings_(log_, records) {}
  Extensions(const Extensions&) = delete;
  Extensions& operator=(const Extensions&) = delete;

  // For the next instance. metrics: see InstanceExtensions; plugin and metrics outlive it.
  const InstanceExtensions& open(const plugin::Found& plugin, std::span<const int> metrics);

  // Before the first call of a plugin that asks.
  void answer_with(Answers answers) { answers_ = std::move(answers); }

  // The same, from before the first instance on.
  void tell_roles(RoleFacts roles) { roles_ = std::move(roles); }

  // At the beginning of a decision. time: s since the start of the match.
  void begin(double time);
  // While plugins are asked what only recorders want to know, nothing of what they do counts.
  void mute(bool muted) { muted_ = muted; }

  const PluginLog& log() const { return log_; }
  const Drawings& drawings() const { return drawings_; }
  MetricReports& metrics() { return metrics_; }
  // What was said last in this decision.
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
  std::vector<std::unique_ptr<InstanceExtensions>> instances_;
};

}  // namespace regista::mind
