// SPDX-License-Identifier: MIT
// What a whole match of configs/teams/paper.yaml against fixed_rate.yaml costs: fourteen minds, referee, senses, radio,
// metrics. Processor time: `us_per_match_second`, and `us_per_decision`, a decision with its share of everything but
// physics. `r` is the match over Box2D alone on the same scene, body by body and step by step; `r0` the same over a
// Box2D that reads the clock, as it did in older figures. All are measured in turn in one run, so that the machine's
// speed moves them alike. `committed_instructions_per_decision` is the number, which scripts/check holds within 3 % of
// what callgrind counts; `peak_mb` is the process's largest memory.
#include <benchmark/benchmark.h>
#include <box2d/b2_timer.h>
#include <sys/resource.h>
#include <sys/time.h>

#include <ctime>
#include <fstream>

#include "config/documents.hpp"
#include "match/physics_world.hpp"
#include "match/teams.hpp"
#include "teams.hpp"

namespace {

bool box2d_reads_the_clock = false;

timeval clock_of_box2d() {
  timeval now{};
  if (box2d_reads_the_clock) gettimeofday(&now, nullptr);
  return now;
}

}  // namespace

// In place of the program's own (host/match/physics_world.cpp).
b2Timer::b2Timer() { Reset(); }
void b2Timer::Reset() {
  const timeval now = clock_of_box2d();
  m_start_sec = static_cast<unsigned long>(now.tv_sec);
  m_start_usec = static_cast<unsigned long>(now.tv_usec);
}
float b2Timer::GetMilliseconds() const {
  const timeval now = clock_of_box2d();
  return 1e3f * static_cast<float>(static_cast<unsigned long>(now.tv_sec) - m_start_sec) +
         1e-3f * static_cast<float>(static_cast<double>(now.tv_usec) - static_cast<double>(m_start_usec));
}

namespace regista {
namespace {

// Processor time, so that a busy machine does not count.
double seconds_of(const auto& work) {
  const std::clock_t begin = std::clock();
  work();
  return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

double replayed(const match::PhysicsLog& log, bool with_clock) {
  match::PhysicsWorld world(log.field, log.ball, log.robots);
  box2d_reads_the_clock = with_clock;
  const double seconds = seconds_of([&] { world.replay(log); });
  box2d_reads_the_clock = false;
  return seconds;
}

double committed_instructions() {
  double out = 0.0;
  std::ifstream(REGISTA_INSTRUCTIONS) >> out;
  return out;
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

  double bare = 0.0, bare_with_clock = 0.0, whole = 0.0;
  for (auto _ : state) {
    bare += replayed(log, false);
    bare_with_clock += replayed(log, true);
    match::Result result;
    whole += seconds_of([&] { result = match::play(teams.setup, both); });
    if (result.hash != recorded.hash) state.SkipWithError("the match was another one");
  }
  const auto matches = static_cast<double>(state.iterations());
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  state.counters["r"] = whole / bare;
  state.counters["r0"] = whole / bare_with_clock;
  state.counters["us_per_match_second"] = 1e6 * whole / matches / recorded.simulated_seconds;
  state.counters["us_per_decision"] = 1e6 * (whole - bare) / matches / static_cast<double>(decisions);
  state.counters["us_per_physics_step"] = 1e6 * bare / matches / static_cast<double>(log.step_ends.size());
  state.counters["committed_instructions_per_decision"] = committed_instructions();
  state.counters["peak_mb"] = static_cast<double>(usage.ru_maxrss) / 1024.0;
}

// 300 s of other teams; `over_paper` is over paper against fixed_rate, played in turn in the same run.
void other_teams(benchmark::State& state, const std::string& home, const std::string& away) {
  const Teams teams;
  match::Setup setup = teams.setup;
  setup.limit = 300.0;
  const auto plan = [&](const std::string& name) {
    return mind::TeamPlan{config::read_document<config::Team>(REGISTA_CONFIGS "/teams/" + name + ".yaml"), setup.rules,
                          setup.robots[0], teams.catalogue};
  };
  const mind::TeamPlan one = plan(home), other = plan(away);
  double usual = 0.0, whole = 0.0, simulated = 0.0;
  for (auto _ : state) {
    usual += seconds_of([&] { match::play(setup, {&teams.paper, &teams.fixed_rate}); });
    whole += seconds_of([&] { simulated += match::play(setup, {&one, &other}).simulated_seconds; });
  }
  state.counters["us_per_match_second"] = 1e6 * whole / simulated;
  state.counters["over_paper"] = whole / usual;
}

// How the cost grows with the number of robots a side: 300 s of the same match. Everybody sees and hears everybody, so
// the square of the number is to be expected, and no more.
void robots_a_side(benchmark::State& state) {
  const plugin::Catalogue catalogue{{REGISTA_PLUGINS}};
  match::Setup setup;
  setup.rules.team_size = static_cast<int>(state.range(0));
  setup.limit = 300.0;
  const mind::TeamPlan paper{config::read_document<config::Team>(REGISTA_CONFIGS "/teams/paper.yaml"), setup.rules,
                             setup.robots[0], catalogue};
  const mind::TeamPlan fixed_rate{config::read_document<config::Team>(REGISTA_CONFIGS "/teams/fixed_rate.yaml"),
                                  setup.rules, setup.robots[1], catalogue};
  double whole = 0.0, simulated = 0.0;
  for (auto _ : state) {
    whole += seconds_of([&] { simulated += match::play(setup, {&paper, &fixed_rate}).simulated_seconds; });
  }
  const auto n = static_cast<double>(state.range(0));
  state.counters["us_per_match_second"] = 1e6 * whole / simulated;
  state.counters["the_same_over_n2"] = 1e6 * whole / simulated / (n * n);
}

BENCHMARK(robots_a_side)->Arg(7)->Arg(11)->Arg(22)->Unit(benchmark::kMillisecond)->Iterations(3);
BENCHMARK_CAPTURE(other_teams, regista_paper, "regista", "paper")->Unit(benchmark::kMillisecond)->Iterations(5);
BENCHMARK_CAPTURE(other_teams, scram_formation, "scram", "formation")->Unit(benchmark::kMillisecond)->Iterations(5);
BENCHMARK(whole_match)->Unit(benchmark::kMillisecond)->Iterations(3)->Repetitions(3)->ReportAggregatesOnly();

}  // namespace
}  // namespace regista
