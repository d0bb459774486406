// SPDX-License-Identifier: MIT
#include "study/tuning/search.hpp"

#include <nlopt.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <climits>
#include <exception>
#include <memory>
#include <new>
#include <utility>

#include "study/tuning/evaluator.hpp"
#include "study/tuning/stochastic_search.hpp"
#include "texts/message.hpp"

namespace regista::study {
namespace {

struct Entry {
  Algorithm algorithm;
  const char *name, *summary;
  bool wants_replication, has_population;
  std::uint64_t least_for_each, least_besides;  // for algorithms without population, see below
};

// Without population, the first step needs least_for_each * n + least_besides evaluations. A simplex method needs the n
// + 1 points of its simplex and one new point. bobyqa needs the start, the points of its first model, and the model's
// optimum. direct_l needs the start, the centre, and both sides of the centre in each dimension.
constexpr std::array<Entry, 11> entries{{
    {Algorithm::sbplx, "sbplx", "Nelder-Mead on subspaces (Rowan's Subplex), by NLopt", true, false, 1, 2},
    {Algorithm::bobyqa, "bobyqa", "quadratic models within bounds (Powell), by NLopt", true, false, 2, 3},
    {Algorithm::nelder_mead, "nelder_mead", "the simplex of Nelder and Mead within bounds, by NLopt", true, false, 1,
     2},
    {Algorithm::cobyla, "cobyla", "linear models (Powell), by NLopt", true, false, 1, 2},
    {Algorithm::crs2_lm, "crs2_lm", "controlled random search with local mutation, by NLopt", false, true, 0, 0},
    {Algorithm::direct_l, "direct_l", "dividing rectangles, locally biased, by NLopt", true, false, 2, 2},
    {Algorithm::isres, "isres", "evolution strategy with stochastic ranking, by NLopt", false, true, 0, 0},
    {Algorithm::esch, "esch", "evolutionary algorithm with Cauchy mutation, by NLopt", false, true, 0, 0},
    {Algorithm::spsa, "spsa", "simultaneous perturbation, as testers of chess engines run it", false, false, 0, 2},
    {Algorithm::sep_cma_es, "sep_cma_es", "separable covariance matrix adaptation, large population", false, true, 0,
     0},
    {Algorithm::random_search, "random_search", "uniformly drawn points: what every other one has to beat", true, false,
     0, 1},
}};

const Entry& entry(Algorithm algorithm) {
  const auto index = static_cast<std::size_t>(algorithm);
  assert(index < entries.size() && entries[index].algorithm == algorithm);
  return entries[index];
}

constexpr const char* nested =
    "runs other algorithms inside, whose choice and tolerances a tuning file does not give; sbplx restarts by itself";

// Parts of NLopt's names for variants of an algorithm, each with the reason why the variant is not offered.
constexpr std::array<std::pair<const char*, const char*>, 5> refusals{{
    {"newuoa", "can hang inside NLopt; bobyqa is its successor"},
    {"praxis", "stops early and far from the optimum on noisy values"},
    {"mlsl", nested},
    {"auglag", nested},
    {"direct", "another variant of dividing rectangles: direct_l is the one that is offered"},
}};

// The name in small letters, without the prefixes of NLopt. kind: set to the second prefix, such as "ld".
std::string plain(std::string_view name, std::string& kind) {
  std::string out;
  for (const char c : name) out += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c == '-' ? '_' : c;
  if (out.starts_with("nlopt_")) out.erase(0, 6);
  if (out.size() > 3 && (out[0] == 'l' || out[0] == 'g') && (out[1] == 'n' || out[1] == 'd') && out[2] == '_') {
    kind = out.substr(0, 2);
    out.erase(0, 3);
  }
  return out;
}

// Evaluates the start, then uniform points of the cube, all on set 0 of pairs. Recommends the points of best mean.
SearchResult random_search(const SearchSettings& settings, Evaluator& inquiry) {
  constexpr std::uint64_t block = 64;  // enough for all workers; few, so that the trace grows steadily
  Rng draws(settings.seed, Rng::Use::random);
  std::vector<Point> points{settings.start};
  while (inquiry.left() > 0) {
    const std::uint64_t number = std::min(block, inquiry.left());
    while (points.size() < number) {
      Point& point = points.emplace_back(settings.start.size());
      for (double& each : point) each = draws.uniform();
    }
    inquiry.ask(points, 0);
    points.clear();
  }
  std::vector<Point> best = inquiry.best(most_recommended);
  if (best.empty()) best.push_back(settings.start);
  return {std::move(best), inquiry.ended()};
}

// The first steps of a local search, in sides of the cube. A local search ends long before the budget, when its steps
// are a small part of the first step. The next search begins at the best point, with random directions and a random
// step. With fixed steps, a search would repeat itself if values do not change: on noisy spheres, the median regret is
// then 1 to 1.6 times (sbplx, nelder_mead) or 1.5 to 2.6 times (bobyqa, cobyla) as large.
constexpr double first_step = 0.25;
constexpr std::array<double, 4> later_steps{0.05, 0.1, 0.2, 0.4};
constexpr double smallest_part = 0.05;

// At the end, a search by generations compares this number of best points by their neighbours.
constexpr std::size_t candidates = 200;

// The algorithms of NLopt in the order of Algorithm. The first four algorithms are local.
constexpr std::array of_nlopt{NLOPT_LN_SBPLX,   NLOPT_LN_BOBYQA,   NLOPT_LN_NELDERMEAD, NLOPT_LN_COBYLA,
                              NLOPT_GN_CRS2_LM, NLOPT_GN_DIRECT_L, NLOPT_GN_ISRES,      NLOPT_GN_ESCH};
constexpr bool is_local(Algorithm algorithm) { return algorithm <= Algorithm::cobyla; }

// Returns whether the algorithm may skip its start. DIRECT begins at the centre. BOBYQA moves a start near a bound.
bool may_pass_over_start(Algorithm algorithm, const Point& start) {
  if (algorithm == Algorithm::direct_l) return true;
  const auto near = [](double x) { return (x > 0.0 && x < first_step) || (x < 1.0 && x > 1.0 - first_step); };
  return algorithm == Algorithm::bobyqa && std::any_of(start.begin(), start.end(), near);
}

struct Destroy {
  void operator()(nlopt_opt optimizer) const { nlopt_destroy(optimizer); }
};

// One run of an algorithm of NLopt, which calls value() through objective(). No exception may pass through NLopt (C).
struct NloptRun {
  Evaluator* inquiry;
  nlopt_opt optimizer;
  std::uint64_t first_pairs;                               // set of pairs of this run's first generation
  std::uint64_t first_generation = 0, later_generation{};  // points of a generation; 0: all questions use set 0
  std::uint64_t asked = 0;
  std::exception_ptr failure{};
  Point point{};

  std::uint64_t pairs_of(std::uint64_t question) const {
    if (first_generation == 0) return 0;
    return question < first_generation ? first_pairs
                                       : first_pairs + 1 + (question - first_generation) / later_generation;
  }

  double stop() const {
    nlopt_force_stop(optimizer);
    return -inquiry->worst();
  }

  // The value that NLopt minimises.
  double value(std::span<const double> coordinates) {
    if (failure || inquiry->left() == 0) return stop();
    for (std::size_t i = 0; i < coordinates.size(); ++i) {
      // Rounding may exceed the bounds slightly, and a broken model may ask for NaN.
      if (!(coordinates[i] > -1.0 && coordinates[i] < 2.0)) return -inquiry->worst();
      point[static_cast<Eigen::Index>(i)] = std::clamp(coordinates[i], 0.0, 1.0);
    }
    try {
      const std::span<const double> answer = inquiry->ask({&point, 1}, pairs_of(asked));
      if (answer.empty()) return stop();
      ++asked;
      return -answer[0];
    } catch (...) {
      failure = std::current_exception();
      return stop();
    }
  }
};

double objective(unsigned dimensions, const double* point, double*, void* run) {
  return static_cast<NloptRun*>(run)->value({point, dimensions});
}

// Runs an algorithm of NLopt. An algorithm with generations uses a new set of pairs for each generation. crs2_lm has no
// generations and uses a new set after each `population` points. All other algorithms use set 0. The function seeds
// NLopt's random state, ignores NLopt's own result, and throws exceptions only after NLopt has returned.
SearchResult nlopt_search(Algorithm algorithm, const SearchSettings& settings, Evaluator& inquiry) {
  const auto dimensions = static_cast<unsigned>(settings.start.size());
  const bool generations = has_population(algorithm);
  Rng draws(settings.seed, Rng::Use::nlopt);
  Point start = settings.start;
  std::uint64_t next_pairs = 0;
  if (may_pass_over_start(algorithm, start)) inquiry.ask({&start, 1}, 0);
  for (bool first = true; inquiry.left() > 0; first = false) {
    const std::unique_ptr<nlopt_opt_s, Destroy> optimizer(
        nlopt_create(of_nlopt.at(static_cast<std::size_t>(algorithm)), dimensions));
    if (!optimizer) throw std::bad_alloc();
    NloptRun run{.inquiry = &inquiry,
                 .optimizer = optimizer.get(),
                 .first_pairs = next_pairs,
                 .point = Point(settings.start.size())};
    nlopt_set_lower_bounds1(optimizer.get(), 0.0);
    nlopt_set_upper_bounds1(optimizer.get(), 1.0);
    nlopt_set_min_objective(optimizer.get(), objective, &run);
    // Some algorithms never end without a limit. The limit is not a time, because results must not depend on the clock.
    nlopt_set_maxeval(optimizer.get(), static_cast<int>(std::min<std::uint64_t>(inquiry.left(), INT_MAX)));
    if (generations) {
      run.first_generation = first_generation(algorithm, dimensions, settings.population);
      run.later_generation = later_generation(algorithm, dimensions, settings.population);
      nlopt_set_population(optimizer.get(), static_cast<unsigned>(run.first_generation));
    }
    if (is_local(algorithm)) {
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
    // NLopt's random state belongs to the thread, and by default starts from the time of day.
    nlopt_srand(draws.bits());
    Point end = start;
    double value = 0.0;
    // The return value is not used: limits, forced stops and rounding all end a search, and `end` may be any point.
    nlopt_optimize(optimizer.get(), end.data(), &value);
    if (run.failure) std::rethrow_exception(run.failure);
    if (run.asked == 0) break;
    next_pairs = generations ? run.pairs_of(run.asked - 1) + 1 : 0;
    start = inquiry.best(1).front();
  }
  // Means over the same pairs rank points directly. Single values are noisy, so best_by_neighbours() ranks them.
  std::vector<Point> recommended = inquiry.best(generations ? candidates : most_recommended);
  if (generations && !recommended.empty()) {
    recommended = best_by_neighbours(inquiry.points(), inquiry.values(), recommended, most_recommended);
  }
  if (recommended.empty()) recommended.push_back(settings.start);
  return {std::move(recommended), inquiry.left() == 0 ? inquiry.ended() : "no further step possible"};
}

}  // namespace

const char* name(Algorithm algorithm) { return entry(algorithm).name; }

std::vector<std::string> algorithm_names() { return texts::names_of(entries, &Entry::name); }

std::optional<Algorithm> algorithm_named(std::string_view name) {
  std::string kind;
  std::string asked = plain(name, kind);
  if (asked == "neldermead") asked = "nelder_mead";
  const auto found = std::ranges::find(entries, asked, &Entry::name);
  if (found == entries.end() || kind.ends_with('d')) return std::nullopt;
  return found->algorithm;
}

const char* summary(Algorithm algorithm) { return entry(algorithm).summary; }

std::optional<std::string> why_unsuitable(std::string_view name) {
  if (algorithm_named(name)) return std::nullopt;
  std::string kind;
  const std::string asked = plain(name, kind);
  if (kind.ends_with('d')) return "what NLopt calls LD_ and GD_ needs gradients, which matches do not have";
  for (const auto& [family, reason] : refusals) {
    if (asked.find(family) != std::string::npos) return reason;
  }
  return std::nullopt;
}

bool wants_replication(Algorithm algorithm) { return entry(algorithm).wants_replication; }

bool has_population(Algorithm algorithm) { return entry(algorithm).has_population; }

std::uint64_t least_evaluations(Algorithm algorithm, std::size_t dimensions, std::size_t population) {
  if (has_population(algorithm)) return first_generation(algorithm, dimensions, population) + 1;
  return entry(algorithm).least_for_each * dimensions + entry(algorithm).least_besides;
}

std::uint64_t first_generation(Algorithm algorithm, std::size_t dimensions, std::size_t population) {
  assert(has_population(algorithm));
  const std::uint64_t n = dimensions, given = population;
  switch (algorithm) {
    case Algorithm::crs2_lm:
      return std::max(given == 0 ? 10 * (n + 1) : given, n + 1);  // a simplex needs n + 1 points
    case Algorithm::isres:
      return given == 0 ? 20 * (n + 1) : given;
    case Algorithm::esch:
      return given == 0 ? 40 : given;
    default:
      return given == 0 ? least_sep_cma_es_population(dimensions) : std::max<std::uint64_t>(given, 2);
  }
}

std::uint64_t later_generation(Algorithm algorithm, std::size_t dimensions, std::size_t population) {
  const std::uint64_t first = first_generation(algorithm, dimensions, population);
  // ESCH keeps its parents and evaluates one and a half times as many children.
  return algorithm == Algorithm::esch ? std::max<std::uint64_t>(first * 3 / 2, 1) : first;
}

SearchResult search(Algorithm algorithm, const SearchSettings& settings, const Evaluate& evaluate) {
  assert(settings.start.size() > 0);
  assert(settings.evaluations >= least_evaluations(algorithm, static_cast<std::size_t>(settings.start.size()),
                                                   has_population(algorithm) ? settings.population : 0));
  Evaluator inquiry(evaluate, settings.evaluations);
  switch (algorithm) {
    case Algorithm::spsa:
      return spsa(settings, inquiry, spsa_gains(settings.evaluations / 2));
    case Algorithm::sep_cma_es:
      return sep_cma_es(settings, inquiry);
    case Algorithm::random_search:
      return random_search(settings, inquiry);
    default:
      return nlopt_search(algorithm, settings, inquiry);
  }
}

}  // namespace regista::study
