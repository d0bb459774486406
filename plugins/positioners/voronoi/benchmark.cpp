// SPDX-License-Identifier: GPL-3.0-or-later
// What the graph of 11 opponents (19 sites with the fixed ones) costs, beside CGAL alone: insertion of the same sites,
// each from where the last one went, and the circumcentre of every triangle. Two runs alternate in one process, so that
// the machine's clock moves both. `allocations` is their number per graph in the steady state.
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <benchmark/benchmark.h>

#include <array>
#include <random>
#include <vector>

#include <regista/testkit/count_allocations.hpp>

#include "algorithm.hpp"

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangulation = CGAL::Delaunay_triangulation_2<Kernel>;

// So many teams of opponents that nothing can be reused from call to call, and that the processor cannot learn the
// course of a few hundred triangulations by heart, as it does when they come around: in a match none comes twice.
std::vector<std::vector<voronoi::Point>> teams(std::size_t opponents) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> x(-4.5, 4.5), y(-3.0, 3.0);
  std::vector<std::vector<voronoi::Point>> out(16384);
  for (auto& team : out) {
    team.resize(opponents);
    for (voronoi::Point& point : team) {
      point.x = x(random);
      point.y = y(random);
    }
  }
  return out;
}

// Runs `work` on team after team, and once over all of them before and after: to reach the steady state, and to count.
void on_every_team(benchmark::State& state, const auto& work) {
  const auto all = teams(static_cast<std::size_t>(state.range(0)));
  const auto once = [&] {
    for (const auto& team : all) work(team);
  };
  once();
  std::size_t next = 0;
  for (auto _ : state) {
    work(all[next]);
    next = (next + 1) % all.size();
  }
  const auto allocations = static_cast<double>(regista::testkit::allocations_during(once));
  state.counters["allocations"] = allocations / static_cast<double>(all.size());
}

void graph(benchmark::State& state) {
  voronoi::Diagram diagram{voronoi::Settings{}};
  on_every_team(state, [&](const auto& team) { benchmark::DoNotOptimize(diagram.of(team).nodes.data()); });
}

void cgal_alone(benchmark::State& state) {
  const voronoi::Settings settings;
  Triangulation triangulation;
  on_every_team(state, [&](const auto& team) {
    triangulation.clear();
    Triangulation::Face_handle near;
    const auto insert = [&](const voronoi::Point& site) {
      near = triangulation.insert(Kernel::Point_2(site.x, site.y), near)->face();
    };
    for (const voronoi::Point& site : team) insert(site);
    for (const voronoi::Point& site : settings.fixed) insert(site);
    for (auto face = triangulation.finite_faces_begin(); face != triangulation.finite_faces_end(); ++face) {
      benchmark::DoNotOptimize(triangulation.circumcenter(face));
    }
  });
}

BENCHMARK(graph)->Arg(3)->Arg(7)->Arg(11)->Arg(22);
BENCHMARK(cgal_alone)->Arg(3)->Arg(7)->Arg(11)->Arg(22);

}  // namespace

BENCHMARK_MAIN();
