// SPDX-License-Identifier: GPL-3.0-or-later
// What the graph of 11 opponents (15 sites with the fixed ones) costs, beside CGAL alone: insertion of the same sites,
// each from where the last one went, and the circumcentre of every triangle. Two runs alternate in one process, so that
// the machine's clock moves both. `allocations` counts calls of operator new per graph in the steady state.
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <benchmark/benchmark.h>

#include <array>
#include <cstdlib>
#include <new>
#include <random>
#include <vector>

#include "algorithm.hpp"

namespace {

std::size_t allocated = 0;

}  // namespace

void* operator new(std::size_t size) {
  ++allocated;
  void* memory = std::malloc(size);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

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

void graph(benchmark::State& state) {
  const auto all = teams(static_cast<std::size_t>(state.range(0)));
  voronoi::Diagram diagram{voronoi::Settings{}};
  std::size_t next = 0;
  for (std::size_t k = 0; k < all.size(); ++k) benchmark::DoNotOptimize(diagram.of(all[k]).nodes.data());
  const std::size_t before = allocated;
  for (auto _ : state) {
    benchmark::DoNotOptimize(diagram.of(all[next]).nodes.data());
    next = (next + 1) % all.size();
  }
  state.counters["allocations"] = static_cast<double>(allocated - before) / static_cast<double>(state.iterations());
}

void cgal_alone(benchmark::State& state) {
  const auto all = teams(static_cast<std::size_t>(state.range(0)));
  const voronoi::Settings settings;
  Triangulation triangulation;
  std::size_t next = 0;
  const std::size_t before = allocated;
  for (auto _ : state) {
    triangulation.clear();
    Triangulation::Face_handle near;
    const auto insert = [&](const voronoi::Point& site) {
      near = triangulation.insert(Kernel::Point_2(site.x, site.y), near)->face();
    };
    for (const voronoi::Point& site : all[next]) insert(site);
    for (const voronoi::Point& site : settings.fixed) insert(site);
    for (auto face = triangulation.finite_faces_begin(); face != triangulation.finite_faces_end(); ++face) {
      benchmark::DoNotOptimize(triangulation.circumcenter(face));
    }
    next = (next + 1) % all.size();
  }
  state.counters["allocations"] = static_cast<double>(allocated - before) / static_cast<double>(state.iterations());
}

BENCHMARK(graph)->Arg(3)->Arg(7)->Arg(11)->Arg(22);
BENCHMARK(cgal_alone)->Arg(3)->Arg(7)->Arg(11)->Arg(22);

}  // namespace

BENCHMARK_MAIN();
