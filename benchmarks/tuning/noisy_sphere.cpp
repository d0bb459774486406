// SPDX-License-Identifier: MIT
// How near the search algorithms come to the optimum of a noisy sphere with equal numbers of simulations: a simulation
// of x in [-5, 5]^n answers -(|x - x*|^2 + sigma z) with z standard normal, x* uniform in [-1, 1]^n, the start uniform
// in the whole box. Printed is the true regret |x - x*|^2 of the first recommended point. Those that want replication
// average a 200th of the simulations in each evaluation; noise is never shared between evaluations. "kept": noise
// belongs to the point, and comes again with it, as values on fixed pairs of matches do.
//
//   noisy_sphere [SEEDS [FIRST [ALGORITHM [rough]]]]     default: 51 seeds from 1 on, all
//
// rough: instead, noise as large as what there is to win, as matches have it.
//
// A Markdown table: median [quartiles], beside the medians of others (r: replicated) where there are any; then what a
// search itself costs.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <optional>
#include <random>
#include <string>
#include <string_view>
#include <vector>

#include "study/tuning/search.hpp"
#include "study/tuning/stochastic_search.hpp"

namespace {

using namespace regista::study;

struct Problem {
  std::size_t dimensions;
  double sigma;
  std::uint64_t simulations;
};

constexpr std::array<Problem, 3> problems{{{4, 1.0, 4000}, {8, 1.0, 20000}, {4, 10.0, 20000}}};
constexpr std::array<Problem, 3> rough_problems{{{4, 30.0, 2000}, {4, 100.0, 4000}, {8, 100.0, 20000}}};
constexpr std::uint64_t replicated_evaluations = 200;

// One seed's optimum, start and noise.
class Sphere {
 public:
  Sphere(const Problem& problem, std::uint64_t seed, std::uint64_t replication, bool kept)
      : seed_(seed),
        kept_(kept),
        random_(seed * 1000003),
        deviation_(problem.sigma / std::sqrt(static_cast<double>(replication))) {
    const auto n = static_cast<Eigen::Index>(problem.dimensions);
    optimum_.resize(n);
    start_.resize(n);
    for (double& each : optimum_) each = 0.4 + 0.2 * uniform();
    for (double& each : start_) each = uniform();
  }

  const Point& start() const { return start_; }
  double regret(const Point& point) const { return 100.0 * (point - optimum_).squaredNorm(); }

  // The mean of so many normal variables is one of a smaller deviation.
  std::vector<double> answer(const Question& question) {
    std::vector<double> out;
    for (const Point& point : question.points) out.push_back(-regret(point) - deviation_ * noise(point));
    return out;
  }

 private:
  double uniform() { return static_cast<double>(random_() >> 11) * 0x1p-53; }

  double noise(const Point& point) {
    if (!kept_) return normal_(random_);
    std::vector<std::uint32_t> words{static_cast<std::uint32_t>(seed_)};
    for (const double each : point) {
      const auto bits = std::bit_cast<std::uint64_t>(each);
      words.push_back(static_cast<std::uint32_t>(bits));
      words.push_back(static_cast<std::uint32_t>(bits >> 32));
    }
    std::seed_seq sequence(words.begin(), words.end());
    std::mt19937_64 random(sequence);
    return std::normal_distribution<double>()(random);
  }

  std::uint64_t seed_;
  bool kept_;
  std::mt19937_64 random_;
  std::normal_distribution<double> normal_;
  double deviation_;
  Point optimum_, start_;
};

using Search = std::function<SearchResult(const SearchSettings& settings, const Evaluate& evaluate)>;

struct Row {
  std::string name;
  bool replicated;
  Search search;
  std::array<std::optional<double>, 3> reference;  // medians of others, same budgets
  bool kept = false;                               // noise belongs to the point
};

struct Spread {
  double lower, median, upper;  // quartiles
};

Spread regrets(const Row& row, const Problem& problem, std::uint64_t first_seed, std::uint64_t seeds) {
  const std::uint64_t replication = row.replicated ? problem.simulations / replicated_evaluations : 1;
  std::vector<double> out;
  for (std::uint64_t seed = first_seed; seed < first_seed + seeds; ++seed) {
    Sphere sphere(problem, seed, replication, row.kept);
    SearchSettings settings;
    settings.start = sphere.start();
    settings.evaluations = problem.simulations / replication;
    settings.seed = seed;
    const SearchResult result = row.search(settings, [&](const Question& question) { return sphere.answer(question); });
    out.push_back(sphere.regret(result.recommended.front()));
  }
  std::sort(out.begin(), out.end());
  const auto quantile = [&](double part) {
    return out[static_cast<std::size_t>(std::lround(part * static_cast<double>(out.size() - 1)))];
  };
  return {quantile(0.25), quantile(0.5), quantile(0.75)};
}

std::string judged(const Spread& ours, std::optional<double> reference) {
  if (!reference) return "";
  if (ours.median <= *reference) return ours.upper < *reference ? ", better" : ", reached";
  return ours.lower <= *reference ? ", reached" : ", **missed**";
}

std::vector<Row> rows() {
  std::vector<Row> out;
  const auto add = [&](Algorithm algorithm, std::array<std::optional<double>, 3> reference) {
    out.push_back({name(algorithm), wants_replication(algorithm),
                   [algorithm](const SearchSettings& settings, const Evaluate& evaluate) {
                     return search(algorithm, settings, evaluate);
                   },
                   reference});
  };
  add(Algorithm::sbplx, {0.110, 0.123, 0.472});
  add(Algorithm::bobyqa, {0.156, 0.116, 1.446});
  add(Algorithm::nelder_mead, {});
  add(Algorithm::cobyla, {});
  add(Algorithm::direct_l, {0.133, 0.619, 0.660});
  add(Algorithm::crs2_lm, {0.310, 0.340, 1.99});
  add(Algorithm::isres, {0.502, 0.466, 2.32});
  add(Algorithm::esch, {});
  add(Algorithm::spsa, {0.0215, 0.0043, 0.174});
  for (const double factor : {0.5, 1.0, 2.0}) {
    const auto run = [factor](const SearchSettings& settings, const Evaluate& evaluate) {
      Evaluator inquiry(evaluate, settings.evaluations);
      SpsaGains gains = spsa_gains(settings.evaluations / 2);
      gains.r_end *= factor;
      return spsa(settings, inquiry, gains);
    };
    out.push_back({fmt::format("spsa, r_end x {:g}", factor), false, run, {}});
  }
  add(Algorithm::sep_cma_es, {0.0173, 0.0259, 0.149});
  add(Algorithm::random_search, {2.68, 17.1, 2.96});
  for (const Algorithm each : {Algorithm::sbplx, Algorithm::bobyqa, Algorithm::nelder_mead, Algorithm::cobyla}) {
    add(each, {});
    out.back().name += " kept";
    out.back().kept = true;
  }
  return out;
}

// Microseconds of processor time that each evaluation costs besides being answered, replicated or not as usual.
double cost(const Row& row) {
  const Problem& problem = problems[1];
  const std::uint64_t evaluations = row.replicated ? replicated_evaluations : problem.simulations;
  const int runs = row.replicated ? 50 : 1;
  const std::clock_t begin = std::clock();
  for (int run = 0; run < runs; ++run) {
    SearchSettings settings;
    settings.start = Point::Constant(static_cast<Eigen::Index>(problem.dimensions), 0.7);
    settings.evaluations = evaluations;
    row.search(settings, [](const Question& question) {
      std::vector<double> out(question.points.size());
      for (std::size_t i = 0; i < out.size(); ++i) out[i] = -question.points[i].squaredNorm();
      return out;
    });
  }
  const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  return 1e6 * seconds / (runs * static_cast<double>(evaluations));
}

}  // namespace

int main(int argc, char** argv) {
  const std::uint64_t seeds = argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 51;
  const std::uint64_t first = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 1;
  const std::string only = argc > 3 ? argv[3] : "all";
  const bool rough = argc > 4 && std::string_view(argv[4]) == "rough";
  if (seeds < 1) {
    fmt::print(stderr, "noisy_sphere [SEEDS [FIRST [ALGORITHM [rough]]]]: a number of seeds above 0 is wanted\n");
    return 2;
  }
  const auto& posed = rough ? rough_problems : problems;
  fmt::print("| algorithm |");
  for (const Problem& each : posed) {
    fmt::print(" n={} sigma={:g}, {} | of others |", each.dimensions, each.sigma, each.simulations);
  }
  fmt::print(" us per evaluation |\n|---|---|---|---|---|---|---|---|\n");
  for (const Row& row : rows()) {
    if (only != "all" && !row.name.starts_with(only)) continue;
    fmt::print("| {}{} |", row.name, row.replicated ? " r" : "");
    for (std::size_t i = 0; i < posed.size(); ++i) {
      const std::optional<double> reference = rough ? std::nullopt : row.reference[i];
      const Spread spread = regrets(row, posed[i], first, seeds);
      fmt::print(" {:.3g} [{:.3g}, {:.3g}] | {}{} |", spread.median, spread.lower, spread.upper,
                 reference ? fmt::format("{:g}", *reference) : "", judged(spread, reference));
    }
    fmt::print(" {:.2f} |\n", cost(row));
    std::fflush(stdout);
  }
}
