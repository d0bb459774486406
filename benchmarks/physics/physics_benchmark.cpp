// SPDX-License-Identifier: MIT
// What a match costs besides its minds, against Box2D alone on the same scene. A match of scripted minds is recorded
// once; then its bare physics is replayed, and the match is played again by puppets that repeat the recorded outcomes.
// Counters are microseconds: per physics step and per second of match time. `ratio` is match without minds to bare
// physics; run the benchmarks together, for the machine's clock moves them both.
#include <benchmark/benchmark.h>

#include <ctime>
#include <memory>

#include "match/match.hpp"
#include "match/physics_world.hpp"
#include "scripted.hpp"

namespace regista::match {
namespace {

struct Recorded {
  Setup setup = scripted::setup(1);
  PhysicsLog log;
  std::array<std::vector<std::vector<mind::Outcome>>, 2> outcomes;  // by side, number - 1, decision
  Result result;

  Recorded() {
    const int size = setup.rules.team_size;
    for (auto& side : outcomes) side.resize(static_cast<std::size_t>(size));
    Observer observer;
    observer.physics_log = &log;
    observer.decision = [this](const Decision& decision) {
      outcomes[index(decision.side)][static_cast<std::size_t>(decision.number - 1)].push_back(decision.outcome);
    };
    result = play(setup, scripted::chasers(size, 20), scripted::chasers(size, 20), &observer);
  }

  std::vector<mind::Think> puppets(Side side) const {
    std::vector<mind::Think> minds;
    for (const auto& line : outcomes[index(side)]) {
      minds.emplace_back([&line, next = std::size_t{0}](const mind::Percepts&, std::span<const mind::HeardPacket>,
                                                        mind::Outcome& out) mutable { out = line[next++]; });
    }
    return minds;
  }
};

const Recorded& recorded() {
  static const Recorded once;
  return once;
}

// Processor time, so that a busy machine does not count.
double seconds_of(const auto& work) {
  const std::clock_t begin = std::clock();
  work();
  return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

void count(benchmark::State& state, double seconds) {
  const double matches = static_cast<double>(state.iterations());
  const double steps = static_cast<double>(recorded().log.step_ends.size());
  state.counters["us_per_step"] = 1e6 * seconds / matches / steps;
  state.counters["us_per_match_second"] = 1e6 * seconds / matches / recorded().result.simulated_seconds;
}

void bare_physics(benchmark::State& state) {
  double seconds = 0.0;
  for (auto _ : state) {
    PhysicsWorld world(recorded().log.field, recorded().log.ball, recorded().log.robots);
    seconds += seconds_of([&world] { world.replay(recorded().log); });
  }
  count(state, seconds);
}

void match_without_minds(benchmark::State& state) {
  double seconds = 0.0, bare = 0.0;
  for (auto _ : state) {
    PhysicsWorld world(recorded().log.field, recorded().log.ball, recorded().log.robots);
    bare += seconds_of([&world] { world.replay(recorded().log); });
    const auto home = recorded().puppets(Side::home), away = recorded().puppets(Side::away);
    Result again;
    seconds += seconds_of([&] { again = play(recorded().setup, home, away); });
    if (again.hash != recorded().result.hash) state.SkipWithError("the puppets played another match");
  }
  count(state, seconds);
  state.counters["ratio"] = seconds / bare;
}

BENCHMARK(bare_physics)->Unit(benchmark::kMillisecond);
BENCHMARK(match_without_minds)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace regista::match

BENCHMARK_MAIN();
