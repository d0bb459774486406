// SPDX-License-Identifier: MIT
// A host that records what an instance offers, logs, draws and reports, and answers as the real one does.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <regista/extensions/budget.h>
#include <regista/extensions/draw.h>
#include <regista/extensions/log.h>
#include <regista/extensions/metric.h>
#include <regista/extensions/pass.h>
#include <regista/extensions/roles.h>
#include <regista/extensions/told.h>
#include <regista/testkit/storage.hpp>

namespace regista::testkit {

class RecordingHost {
 public:
  struct Offered {
    std::uint64_t handle;
    std::vector<std::uint8_t> bytes;
    double urgency, expiry;
    std::int32_t medium;
    std::uint64_t replaces;  // 0 = none
    bool withdrawn = false;
    bool replaced = false;  // by one that came later
    bool waits() const { return !withdrawn && !replaced; }
  };

  explicit RecordingHost(std::uint32_t bytes_free = 64, const Layout& layout = {});
  RecordingHost(const RecordingHost&) = delete;
  RecordingHost& operator=(const RecordingHost&) = delete;

  const Layout& layout() const { return layout_; }
  const regista_host* raw() const { return &raw_.get(); }
  void set_bytes_free(std::uint32_t bytes) { bytes_free_ = bytes; }
  // Match time, against which an offer may be expired already.
  void set_time(double seconds) { time_ = seconds; }
  // Offers that are refused when so many wait: those in `offers` that were neither withdrawn nor replaced.
  void set_most_pending(std::size_t offers_that_wait) { most_pending_ = offers_that_wait; }

  // Of which plugin reports are taken.
  void set_metrics(const regista_descriptor& plugin);
  // What the last call asked of an extension against its rules, in one line; empty when nothing.
  std::string take_broken();

  std::vector<Offered> offers;  // accepted, in order
  unsigned refused = 0;
  struct Line {
    std::int32_t level;
    std::string text;
  };
  std::vector<Line> log;
  unsigned shapes = 0;  // that were drawn
  struct Report {
    std::uint32_t metric;
    double value;
  };
  std::vector<Report> reports;
  std::vector<std::int32_t> receivers;  // of kicks that were meant for a teammate
  // What the extensions told, budget and roles answer. told: by shirt number - 1; nobody has spoken by default. budget:
  // of the beginning of a match by default.
  std::vector<std::optional<regista_told_packet>> told;
  bool sees_ball = false;
  int receiver = 0;
  regista_budget budget = whole_budget();
  std::vector<regista_role_facts> roles;  // by row of the table of roles; none by default
  // What each call of the instance took, by name of the call; where somebody wants to know.
  struct CallCosts {
    std::vector<double> seconds;
    std::vector<std::size_t> allocations;  // by operator new; empty where they are not counted
  };
  std::map<std::string, CallCosts>* costs = nullptr;
  // How often this process has allocated by operator new; null where nobody counts.
  std::size_t (*allocated)() = nullptr;
  // Of these, what this host itself allocated when the instance called it.
  std::size_t own_allocations = 0;

 private:
  static regista_budget whole_budget();
  std::uint64_t offer(const std::uint8_t* bytes, std::uint32_t count, double urgency, double expiry,
                      std::int32_t medium, std::uint64_t replaces);

  const void* extension(const char* id) const;
  void draw(const regista_shape& shape);
  void report(std::uint32_t metric, double value);
  void break_rule(std::string rule);

  Layout layout_;
  Grown<regista_host> raw_;
  regista_log log_{};
  regista_draw draw_{};
  regista_metric_reports reports_{};
  regista_pass pass_{};
  regista_told told_{};
  regista_budget_now budget_{};
  regista_roles roles_{};
  std::uint32_t metric_count_ = 0;
  std::string broken_;
  std::uint32_t bytes_free_;
  std::uint64_t last_handle_ = 0;
  double time_ = 0.0;
  std::size_t most_pending_ = std::numeric_limits<std::size_t>::max();
};

}  // namespace regista::testkit
