// SPDX-License-Identifier: MIT
// What an assignment costs: random utilities and distances of the sizes of teams (the mean over 64 of them), and the
// OR-Library's problem of 800 x 800 (Beasley 1990; skipped where the file is absent). No call allocates.
//
//   benchmark_assignment --benchmark_repetitions=5 --benchmark_report_aggregates_only=true
//
// Instructions, which do not depend on how busy the machine is: the calls of the functions measured_*, nothing else.
// Divide by their number, which stands in the same file behind "calls=".
//
//   valgrind --tool=callgrind '--toggle-collect=*measured_*' benchmark_assignment --benchmark_filter=...
#include <benchmark/benchmark.h>
#include <zlib.h>

#include <cstdint>
#include <numeric>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "hungarian/algorithm.hpp"
#include "scram/algorithm.hpp"

namespace {

constexpr std::size_t problems = 64;

struct Problems {
  std::size_t rows, columns;
  std::vector<double> values;  // problem by problem
  std::vector<std::uint32_t> order;
  std::vector<std::int32_t> out;

  Problems(std::size_t robots, std::size_t tasks, int levels)
      : rows(robots), columns(tasks), values(problems * robots * tasks), order(tasks), out(robots) {
    std::iota(order.begin(), order.end(), 0u);
    std::mt19937 random(1);
    for (double& value : values) {
      const double share = static_cast<double>(random()) / 4294967296.0;
      value = levels == 0 ? share : static_cast<double>(static_cast<int>(share * levels));
    }
  }
  const double* problem(std::size_t k) const { return values.data() + k % problems * rows * columns; }
};

Problems of_size(const benchmark::State& state, int levels) {
  return {static_cast<std::size_t>(state.range(0)), static_cast<std::size_t>(state.range(1)), levels};
}

// Not inlined, so that callgrind can tell their instructions from those around them.
[[gnu::noinline]] void measured_hungarian_any(hungarian::Solver& solver, Problems& p, std::size_t k) {
  solver.assign_any({p.problem(k), p.rows, p.columns, p.columns}, p.out);
}
[[gnu::noinline]] void measured_hungarian(hungarian::Solver& solver, Problems& p, std::size_t k) {
  solver.assign({p.problem(k), p.rows, p.columns, p.columns}, p.order, p.out);
}
[[gnu::noinline]] void measured_scram(scram::Solver& solver, Problems& p, std::size_t k, scram::Criterion criterion,
                                      scram::Method method) {
  solver.assign({p.problem(k), p.rows, p.columns, p.columns}, criterion, p.order, p.order, p.out, method);
}

void hungarian_without_tie_rule(benchmark::State& state) {
  Problems p = of_size(state, 0);
  hungarian::Solver solver;
  std::size_t k = 0;
  for (auto _ : state) {
    measured_hungarian_any(solver, p, k++);
    benchmark::DoNotOptimize(p.out.data());
  }
}

void hungarian_with_ties(benchmark::State& state, int levels) {
  Problems p = of_size(state, levels);
  hungarian::Solver solver;
  std::size_t k = 0;
  for (auto _ : state) {
    measured_hungarian(solver, p, k++);
    benchmark::DoNotOptimize(p.out.data());
  }
}

void sizes(benchmark::internal::Benchmark* each) {
  each->Args({3, 5})->Args({7, 7})->Args({7, 12})->Args({11, 16})->Args({22, 27});
}

BENCHMARK(hungarian_without_tie_rule)->Apply(sizes);
BENCHMARK_CAPTURE(hungarian_with_ties, random, 0)->Apply(sizes);
BENCHMARK_CAPTURE(hungarian_with_ties, four_levels, 4)->Apply(sizes);

// Robots and tasks anywhere on a field of 9 x 6 m; costs are squared distances.
std::vector<double> distances(std::size_t robots, std::size_t tasks) {
  std::mt19937 random(2);
  const auto anywhere = [&random](double length) { return length * static_cast<double>(random()) / 4294967296.0; };
  std::vector<double> costs, x(tasks), y(tasks);
  for (std::size_t k = 0; k < problems; ++k) {
    for (std::size_t j = 0; j < tasks; ++j) {
      x[j] = anywhere(9.0);
      y[j] = anywhere(6.0);
    }
    for (std::size_t i = 0; i < robots; ++i) {
      const double robot_x = anywhere(9.0), robot_y = anywhere(6.0);
      for (std::size_t j = 0; j < tasks; ++j) {
        const double dx = x[j] - robot_x, dy = y[j] - robot_y;
        costs.push_back(dx * dx + dy * dy);
      }
    }
  }
  return costs;
}

void scram_on_a_field(benchmark::State& state, scram::Criterion criterion, scram::Method method) {
  Problems p = of_size(state, 0);
  p.values = distances(p.rows, p.columns);
  scram::Solver solver;
  std::size_t k = 0;
  for (auto _ : state) {
    measured_scram(solver, p, k++, criterion, method);
    benchmark::DoNotOptimize(p.out.data());
  }
}

void small_teams(benchmark::internal::Benchmark* each) {
  each->Args({3, 3})->Args({5, 5})->Args({7, 7})->Args({7, 12});
}
void all_teams(benchmark::internal::Benchmark* each) {
  small_teams(each);
  each->Args({11, 11})->Args({22, 22})->Args({100, 100});
}

BENCHMARK_CAPTURE(scram_on_a_field, mmdr_enumeration, scram::Criterion::mmdr, scram::Method::enumeration)
    ->Apply(small_teams);
BENCHMARK_CAPTURE(scram_on_a_field, mmdr_polynomial, scram::Criterion::mmdr, scram::Method::polynomial)
    ->Apply(all_teams);
BENCHMARK_CAPTURE(scram_on_a_field, mmd_msd2_enumeration, scram::Criterion::mmd_msd2, scram::Method::enumeration)
    ->Apply(small_teams);
BENCHMARK_CAPTURE(scram_on_a_field, mmd_msd2_polynomial, scram::Criterion::mmd_msd2, scram::Method::polynomial)
    ->Apply(all_teams);

// assignp800: a list of the pairs that are allowed, with their costs.
std::vector<double> read_assignp800() {
  std::string text;
  if (gzFile in = gzopen(REGISTA_SHARED_DATA "/assignment/orlib/assignp800.txt.gz", "rb")) {
    char block[1 << 16];
    for (int got; (got = gzread(in, block, sizeof block)) > 0;) text.append(block, static_cast<std::size_t>(got));
    gzclose(in);
  }
  std::istringstream in(text);
  std::size_t n = 0, i, j;
  in >> n;
  std::vector<double> utilities(n * n, hungarian::forbidden);
  for (double cost; in >> i >> j >> cost;) utilities[(i - 1) * n + j - 1] = -cost;
  return utilities;
}

void hungarian_800(benchmark::State& state, bool published) {
  constexpr std::size_t n = 800;
  std::vector<double> utilities = read_assignp800();
  if (published && utilities.size() != n * n) {
    state.SkipWithError("no assignp800.txt.gz");
    return;
  }
  if (!published) {
    std::mt19937 random(1);
    utilities.resize(n * n);
    for (double& value : utilities) value = static_cast<double>(random()) / 4294967296.0;
  }
  std::vector<std::uint32_t> order(n);
  std::iota(order.begin(), order.end(), 0u);
  std::vector<std::int32_t> out(n);
  hungarian::Solver solver;
  for (auto _ : state) {
    solver.assign({utilities.data(), n, n, n}, order, out);
    benchmark::DoNotOptimize(out.data());
  }
}

BENCHMARK_CAPTURE(hungarian_800, assignp800, true)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(hungarian_800, random, false)->Unit(benchmark::kMillisecond);

}  // namespace
