// SPDX-License-Identifier: MIT
// What a formation costs: eleven positions for one place of the ball, and reading and triangulating a file once.
#include <benchmark/benchmark.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "formation.hpp"
#include "formation_file.hpp"

namespace {

const std::filesystem::path path =
    std::filesystem::path(REGISTA_SHARED_DATA) / "formations/helios_base/normal-formation.conf";

std::string content() {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void positions_of_eleven(benchmark::State& state) {
  if (!std::filesystem::exists(path)) return state.SkipWithError("the formation file is not there");
  const formations::Formation formation(formations::read_formation(content()), 9.0 / 105.0, 6.0 / 68.0,
                                        formations::Beyond::nearest_point);
  std::mt19937 random(3);
  const double reach = static_cast<double>(state.range(0)) / 10.0;
  std::uniform_real_distribution<double> x(-4.5 * reach, 4.5 * reach), y(-3.0 * reach, 3.0 * reach);
  std::vector<formations::Position> balls(1024);
  for (formations::Position& ball : balls) {
    ball.x = x(random);
    ball.y = y(random);
  }
  std::size_t next = 0;
  for (auto _ : state) {
    const formations::Shares shares = formation.shares(balls[next]);
    for (std::size_t k = 0; k < 11; ++k) benchmark::DoNotOptimize(formation.position(shares, k));
    next = (next + 1) % balls.size();
  }
}

void reading_a_file(benchmark::State& state) {
  if (!std::filesystem::exists(path)) return state.SkipWithError("the formation file is not there");
  const std::string bytes = content();
  for (auto _ : state) {
    const formations::Formation formation(formations::read_formation(bytes), 9.0 / 105.0, 6.0 / 68.0,
                                          formations::Beyond::nearest_point);
    benchmark::DoNotOptimize(formation.positions());
  }
}

BENCHMARK(positions_of_eleven)->ArgName("reach_tenths")->Arg(10)->Arg(20);  // on the field; half of it far outside
BENCHMARK(reading_a_file)->Unit(benchmark::kMicrosecond);

}  // namespace
