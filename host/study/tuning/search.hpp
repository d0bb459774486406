// SPDX-License-Identifier: MIT
// A search looks for the point of the unit cube with the largest value. Values are noisy and expensive. This file does
// not depend on matches. Measured properties of NLopt 2.7.1 on noisy objectives: docs/tuning.md.
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace regista::study {

// The first eight algorithms are those of NLopt (S. G. Johnson).
enum class Algorithm {
  sbplx,
  bobyqa,
  nelder_mead,
  cobyla,
  crs2_lm,
  direct_l,
  isres,
  esch,
  spsa,           // simultaneous perturbation, as testers of chess engines run it
  sep_cma_es,     // separable covariance matrix adaptation
  random_search,  // uniform points; a baseline for the other algorithms
};

// name(): "sep_cma_es". algorithm_names(): all names, in the order of Algorithm.
const char* name(Algorithm algorithm);
std::vector<std::string> algorithm_names();
std::optional<Algorithm> algorithm_named(std::string_view name);

// A description in a few words, for help and reports.
const char* summary(Algorithm algorithm);

// Why an algorithm of NLopt is not offered ("can hang inside NLopt; bobyqa is its successor"); nullopt if no reason is
// known. name: NLopt's name, in upper or lower case, with or without the prefixes NLOPT_, LN_, GN_, LD_, GD_.
std::optional<std::string> why_unsuitable(std::string_view name);

// Returns whether the algorithm treats values as exact, and so needs several pairs of matches for each point.
bool wants_replication(Algorithm algorithm);

// Returns whether the algorithm has a population, and so uses the setting `population`.
bool has_population(Algorithm algorithm);

// The number of evaluations that an algorithm needs for its first step. dimensions: number of free parameters.
// population: 0 means the algorithm's own number.
std::uint64_t least_evaluations(Algorithm algorithm, std::size_t dimensions, std::size_t population);

// The number of points in the first generation, and in each later generation: `population`, or the algorithm's own
// number if `population` is 0. For algorithms of NLopt, these are the defaults of NLopt 2.7.1; the program must know
// them, because the points of a generation play the same pairs of matches. sep_cma_es derives its own number from the
// budget; for sep_cma_es, the functions return the least possible number. Precondition: the algorithm has a population.
std::uint64_t first_generation(Algorithm algorithm, std::size_t dimensions, std::size_t population);
std::uint64_t later_generation(Algorithm algorithm, std::size_t dimensions, std::size_t population);

using Point = Eigen::VectorXd;  // in the unit cube; one coordinate per free parameter

// Points that an algorithm compares with each other.
struct Question {
  std::span<const Point> points;
  // The number of a set of pairs of matches. All points with the same number, in any question, play the same pairs. The
  // first number is 0; a new number is one more than the largest number so far. The points of a generation share a
  // number, and each generation has a new number. Algorithms that need a deterministic function always use 0.
  std::uint64_t pairs = 0;
};

// Returns one finite value per point; larger is better. If the function returns no values, the search ends with the
// points that it has, as if its budget were used up. If the function throws, the search throws the same exception.
using Evaluate = std::function<std::vector<double>(const Question& question)>;

struct SearchSettings {
  Point start;
  std::uint64_t evaluations = 0;  // largest number of points to evaluate
  std::uint64_t seed = 1;
  std::size_t population = 0;  // 0: the algorithm's own number
};

struct SearchResult {
  // One to eight different points, best first. The algorithm determines which points:
  //   - crs2_lm, isres, esch, which give each point a single value: of the 200 best points, those whose neighbours have
  //     the best mean value (study/tuning/evaluator.hpp);
  //   - spsa, sep_cma_es: the last estimate, means of late estimates, and the start;
  //   - the other algorithms: the points with the best mean values; of equal means, the earlier point.
  std::vector<Point> recommended;
  std::string ended;  // in a few words: "budget used up", "steps became too small"
};

// The result depends only on the arguments and the answers of `evaluate`, even if several threads search at once.
// Preconditions: the start is in the cube; `evaluations` is least_evaluations() or more. An algorithm that ends before
// the budget is used up starts again from the best point. A value that is not finite is worse than all finite values.
SearchResult search(Algorithm algorithm, const SearchSettings& settings, const Evaluate& evaluate);

}  // namespace regista::study
