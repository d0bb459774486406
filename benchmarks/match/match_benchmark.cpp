// SPDX-License-Identifier: MIT
// What a whole match of configs/teams/paper.yaml against fixed_rate.yaml costs: fourteen minds, referee, senses, radio,
// metrics. `r` is its processor time over that of Box2D alone on the same scene, body by body and step by step,
// measured in turn in one run, so that the machine's clock moves both. `us_per_match_second` and `us_per_decision` (a
// decision with its share of everything but physics) are processor time; `peak_mb` is the process's largest memory.
#include <benchmark/benchmark.h>
#include <sys/resource.h>

#include <ctime>

#include "config/documents.hpp"
#include "match/replay.hpp"
#include "match/teams.hpp"
#include "teams.hpp"

namespace regista {
namespace {

// Processor time, so that a busy machine does not count.
double seconds_of(const auto& work) {
  const std::clock_t begin = std::clock();
  work();
  return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

void whole_match(benchmark::State& state) {
  static const Teams teams;
  match::PhysicsLog log;
  std::size_t decisions = 0;
  match::Observer observer;
  observer.physics_log = &log;
  observer.decision = [&decisions](const match::Decision&) { ++decisions; };
  const std::array<const mind::TeamPlan*, 2> both{&teams.paper, &teams.fixed_rate};
  const match::Result recorded = match::play(teams.setup, both, &observer);

  double bare = 0.0, whole = 0.0;
  for (auto _ : state) {
    match::Replay replay(log);
    bare += seconds_of([&replay] { replay.run(); });
    match::Result result;
    whole += seconds_of([&] { result = match::play(teams.setup, both); });
    if (result.hash != recorded.hash) state.SkipWithError("the match was another one");
  }
  const auto matches = static_cast<double>(state.iterations());
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  state.counters["r"] = whole / bare;
  state.counters["us_per_match_second"] = 1e6 * whole / matches / recorded.simulated_seconds;
  state.counters["us_per_decision"] = 1e6 * (whole - bare) / matches / static_cast<double>(decisions);
  state.counters["us_per_physics_step"] = 1e6 * bare / matches / static_cast<double>(log.step_ends.size());
  state.counters["peak_mb"] = static_cast<double>(usage.ru_maxrss) / 1024.0;
}

// How the cost grows with the number of robots a side: 300 s of the same match. Everybody sees and hears everybody, so
// the square of the number is to be expected, and no more.
void robots_a_side(benchmark::State& state) {
  const plugin::Catalogue catalogue{{REGISTA_PLUGINS}};
  match::Setup setup;
  setup.rules.team_size = static_cast<int>(state.range(0));
  setup.limit = 300.0;
  const mind::TeamPlan paper{config::read_team(REGISTA_CONFIGS "/teams/paper.yaml"), setup.rules, setup.robots[0],
                             catalogue};
  const mind::TeamPlan fixed_rate{config::read_team(REGISTA_CONFIGS "/teams/fixed_rate.yaml"), setup.rules,
                                  setup.robots[1], catalogue};
  double whole = 0.0, simulated = 0.0;
  for (auto _ : state) {
    whole += seconds_of([&] { simulated += match::play(setup, {&paper, &fixed_rate}).simulated_seconds; });
  }
  const auto n = static_cast<double>(state.range(0));
  state.counters["us_per_match_second"] = 1e6 * whole / simulated;
  state.counters["the_same_over_n2"] = 1e6 * whole / simulated / (n * n);
}

BENCHMARK(robots_a_side)->Arg(7)->Arg(11)->Arg(22)->Unit(benchmark::kMillisecond)->Iterations(3);
BENCHMARK(whole_match)->Unit(benchmark::kMillisecond)->Iterations(3)->Repetitions(3)->ReportAggregatesOnly();

}  // namespace
}  // namespace regista
