// SPDX-License-Identifier: MIT
// Contexts that hold, and use extensions as they must not be used. lies_in_numbers does so as robot 3, from its tick 50
// on.
#include <array>
#include <limits>
#include <string>

#include <regista/context.hpp>
#include <regista/draw.hpp>
#include <regista/log.hpp>
#include <regista/metric.hpp>

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

}  // namespace

REGISTA_PLUGINS(regista::Plugin<DrawsTooMuch, regista::context>, regista::Plugin<LogsTooMuch, regista::context>,
                regista::Plugin<WarnsOnce, regista::context>, regista::Plugin<LiesInNumbers, regista::context>)
