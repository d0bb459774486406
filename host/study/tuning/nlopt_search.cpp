// SPDX-License-Identifier: MIT
#include "study/tuning/nlopt_search.hpp"

#include <nlopt.h>

#include <algorithm>
#include <array>
#include <climits>
#include <exception>
#include <memory>
#include <new>
#include <stdexcept>
#include <utility>

#include "study/tuning/draws.hpp"
#include "study/tuning/neighbours.hpp"
#include "study/tuning/populations.hpp"

namespace regista::study {
namespace {

// Steps that a local search begins with, in sides of the cube. It ends when its steps have become a small part of that,
// long before the budget: the next one begins at the best point, in drawn directions and with a drawn one of these, as
// the same one again would go the same way where values do not change. Without that, medians on noisy spheres are 1 to
// 1.6 (sbplx, nelder_mead) and 1.5 to 2.6 times as large (bobyqa, cobyla).
constexpr double first_step = 0.25;
constexpr std::array<double, 4> later_steps{0.05, 0.1, 0.2, 0.4};
constexpr double smallest_part = 0.05;

// Of a search by generations, so many best points are looked at more closely in the end.
constexpr std::size_t candidates = 200;

nlopt_algorithm of_nlopt(Algorithm algorithm) {
  switch (algorithm) {
    case Algorithm::sbplx:
      return NLOPT_LN_SBPLX;
    case Algorithm::bobyqa:
      return NLOPT_LN_BOBYQA;
    case Algorithm::nelder_mead:
      return NLOPT_LN_NELDERMEAD;
    case Algorithm::cobyla:
      return NLOPT_LN_COBYLA;
    case Algorithm::crs2_lm:
      return NLOPT_GN_CRS2_LM;
    case Algorithm::direct_l:
      return NLOPT_GN_DIRECT_L;
    case Algorithm::isres:
      return NLOPT_GN_ISRES;
    case Algorithm::esch:
      return NLOPT_GN_ESCH;
    default:
      break;
  }
  throw std::logic_error("not an algorithm of NLopt");
}

bool local(Algorithm algorithm) {
  return algorithm == Algorithm::sbplx || algorithm == Algorithm::bobyqa || algorithm == Algorithm::nelder_mead ||
         algorithm == Algorithm::cobyla;
}

// Whether it may leave out the point where it is to start: DIRECT begins at the centre, BOBYQA moves a start that is
// nearer to a bound than its first step.
bool may_pass_over_start(Algorithm algorithm, const Point& start) {
  if (algorithm == Algorithm::direct_l) return true;
  const auto near = [](double x) { return (x > 0.0 && x < first_step) || (x < 1.0 && x > 1.0 - first_step); };
  return algorithm == Algorithm::bobyqa && std::any_of(start.begin(), start.end(), near);
}

struct Destroy {
  void operator()(nlopt_opt optimizer) const { nlopt_destroy(optimizer); }
};

// What a call of the objective knows. Nothing may be thrown through NLopt, which is C.
struct NloptRun {
  Inquiry* inquiry;
  nlopt_opt optimizer;
  std::uint64_t first_pairs;       // of this run's first generation
  std::uint64_t first_generation;  // points of it; 0: all questions are of number 0
  std::uint64_t later_generation;
  std::uint64_t asked = 0;
  std::exception_ptr failure;
  Point point;

  std::uint64_t pairs() const {
    if (first_generation == 0) return 0;
    return asked < first_generation ? first_pairs : first_pairs + 1 + (asked - first_generation) / later_generation;
  }

  // To be minimised.
  double value(std::span<const double> coordinates) {
    if (failure || inquiry->left() == 0) {
      nlopt_force_stop(optimizer);
      return -inquiry->worst();
    }
    for (std::size_t i = 0; i < coordinates.size(); ++i) {
      // Rounding may leave the bounds; a model that broke down asks for no number at all.
      if (!(coordinates[i] > -1.0 && coordinates[i] < 2.0)) return -inquiry->worst();
      point[static_cast<Eigen::Index>(i)] = std::clamp(coordinates[i], 0.0, 1.0);
    }
    try {
      const std::span<const double> answer = inquiry->ask({&point, 1}, pairs());
      if (answer.empty()) {
        nlopt_force_stop(optimizer);
        return -inquiry->worst();
      }
      ++asked;
      return -answer[0];
    } catch (...) {
      failure = std::current_exception();
      nlopt_force_stop(optimizer);
      return -inquiry->worst();
    }
  }
};

double objective(unsigned dimensions, const double* point, double*, void* run) {
  return static_cast<NloptRun*>(run)->value({point, dimensions});
}

}  // namespace

SearchResult nlopt_search(Algorithm algorithm, const SearchSettings& settings, Inquiry& inquiry) {
  const auto dimensions = static_cast<unsigned>(settings.start.size());
  const bool generations = has_population(algorithm);
  Draws draws(settings.seed, Draws::Use::nlopt);
  Point start = settings.start;
  std::uint64_t next_pairs = 0;
  if (may_pass_over_start(algorithm, start)) inquiry.ask({&start, 1}, 0);
  for (bool first = true; inquiry.left() > 0; first = false) {
    const std::unique_ptr<nlopt_opt_s, Destroy> optimizer(nlopt_create(of_nlopt(algorithm), dimensions));
    if (!optimizer) throw std::bad_alloc();
    NloptRun run{&inquiry, optimizer.get(), next_pairs, 0, 0, 0, nullptr, Point(start.size())};
    nlopt_set_lower_bounds1(optimizer.get(), 0.0);
    nlopt_set_upper_bounds1(optimizer.get(), 1.0);
    nlopt_set_min_objective(optimizer.get(), objective, &run);
    // Without it some of them never end; no time, as results must not depend on the clock.
    nlopt_set_maxeval(optimizer.get(), static_cast<int>(std::min<std::uint64_t>(inquiry.left(), INT_MAX)));
    if (generations) {
      run.first_generation = first_generation(algorithm, dimensions, settings.population);
      run.later_generation = later_generation(algorithm, dimensions, settings.population);
      nlopt_set_population(optimizer.get(), static_cast<unsigned>(run.first_generation));
    }
    if (local(algorithm)) {
      const double size = first ? first_step : later_steps[draws.bits() % later_steps.size()];
      Point step(start.size());
      for (Eigen::Index i = 0; i < step.size(); ++i) {
        const double side = first ? 1.0 : draws.sign();
        const double end = start[i] + side * size;
        step[i] = end < 0.0 || end > 1.0 ? -side * size : side * size;
      }
      nlopt_set_initial_step(optimizer.get(), step.data());
      nlopt_set_xtol_abs1(optimizer.get(), smallest_part * size);
    }
    // Its random state belongs to the thread, and starts from the time of day.
    nlopt_srand(draws.bits());
    Point end = start;
    double value = 0.0;
    // What it returns says nothing: reached limits, forced stops and rounding all end a search, and the point may be
    // any.
    nlopt_optimize(optimizer.get(), end.data(), &value);
    if (run.failure) std::rethrow_exception(run.failure);
    if (run.asked == 0) break;
    next_pairs = generations ? run.first_pairs + 1 +
                                   (run.asked <= run.first_generation
                                        ? 0
                                        : (run.asked - run.first_generation - 1) / run.later_generation + 1)
                             : 0;
    start = inquiry.best(1).front();
  }
  // Values on the same pairs, many matches each, are compared as they are; single ones, of ever other pairs, are not.
  std::vector<Point> recommended = inquiry.best(generations ? candidates : most_recommended);
  if (generations && !recommended.empty()) {
    recommended = best_by_neighbours(inquiry.points(), inquiry.values(), recommended, most_recommended);
  }
  if (recommended.empty()) recommended.push_back(settings.start);
  return {std::move(recommended), inquiry.left() == 0 ? inquiry.ended() : "no further step possible"};
}

}  // namespace regista::study
