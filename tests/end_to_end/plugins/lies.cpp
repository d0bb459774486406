// SPDX-License-Identifier: MIT
// Plugins that use extensions as they must not be used. Most are contexts that hold. lies_in_numbers and
// passes_to_nobody do so as robot 3, from tick 50 on.
#include <array>
#include <limits>
#include <string>

#include <regista/behaviour.hpp>
#include <regista/context.hpp>
#include <regista/draw.hpp>
#include <regista/log.hpp>
#include <regista/metric.hpp>
#include <regista/pass.hpp>

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

struct DrawsTooMuch {
  static constexpr auto id = "draws_too_much", version = "1.0.0",
                        summary = "Draws 10^9 points, and one that is nowhere";
  regista::Draw draw;
  void setup(const regista::Environment&, const regista::Host& host) { draw = regista::Draw(host); }
  bool holds(const regista::Frame&) {
    const std::array<regista::Point, 3> corners{{{0.0, 0.0}, {1.0, not_a_number}, {0.0, 1.0}}};
    draw.points("dust", {corners.data(), 1'000'000'000});
    draw.polygon("cells", corners);
    return true;
  }
};

struct LogsTooMuch {
  static constexpr auto id = "logs_too_much", version = "1.0.0", summary = "Logs a megabyte at each decision";
  regista::Log log;
  void setup(const regista::Environment&, const regista::Host& host) { log = regista::Log(host); }
  bool holds(const regista::Frame&) {
    for (int i = 0; i < 1000; ++i) log.info(std::string(1000, 'x'));
    return true;
  }
};

struct WarnsOnce {
  static constexpr auto id = "warns_once", version = "1.0.0", summary = "Logs much that is information, then a warning";
  regista::Log log;
  bool warned = false;
  void setup(const regista::Environment&, const regista::Host& host) { log = regista::Log(host); }
  void reset(std::uint64_t) { warned = false; }
  bool holds(const regista::Frame& frame) {
    log.info("all is well");
    if (frame.tick() >= 50 && !warned) log.warning("it rains");
    warned = frame.tick() >= 50;
    return true;
  }
};

struct LiesInNumbers {
  static constexpr auto id = "lies_in_numbers", version = "1.0.0", summary = "Reports what is no number";
  static constexpr std::array metrics{regista::metric("truth", "1", "How much of it", REGISTA_METRIC_MEAN)};
  regista::MetricReports reports;
  void setup(const regista::Environment&, const regista::Host& host) { reports = regista::MetricReports(host); }
  bool holds(const regista::Frame& frame) {
    reports.report(0, frame.own_number() == 3 && frame.tick() >= 50 ? not_a_number : 1.0);
    return true;
  }
};

// Always wants to kick; only robot 3 says for whom.
struct PassesToNobody {
  static constexpr auto id = "passes_to_nobody", version = "1.0.0", summary = "Means a kick for a robot that is none";
  regista::Pass pass;
  void setup(const regista::Environment&, const regista::Host& host) { pass = regista::Pass(host); }
  void act(const regista::Frame& frame, const regista::Body&, regista::Action& out) {
    out.kick = 0;
    out.kick_distance = 2.0;
    if (frame.own_number() == 3 && frame.tick() >= 50) pass.meant_for(8);
  }
};

}  // namespace

REGISTA_PLUGINS(regista::Plugin<DrawsTooMuch, regista::context>, regista::Plugin<LogsTooMuch, regista::context>,
                regista::Plugin<WarnsOnce, regista::context>, regista::Plugin<LiesInNumbers, regista::context>,
                regista::Plugin<PassesToNobody, regista::behaviour>)
