// SPDX-License-Identifier: MIT
#include "study/tuning/algorithm.hpp"

#include <algorithm>
#include <array>
#include <cassert>

#include "study/tuning/populations.hpp"

namespace regista::study {
namespace {

struct Entry {
  Algorithm algorithm;
  const char* name;
  const char* summary;
  bool wants_replication;
  bool has_population;
};

constexpr std::array<Entry, 11> entries{{
    {Algorithm::sbplx, "sbplx", "Nelder-Mead on subspaces (Rowan's Subplex), by NLopt", true, false},
    {Algorithm::bobyqa, "bobyqa", "quadratic models within bounds (Powell), by NLopt", true, false},
    {Algorithm::nelder_mead, "nelder_mead", "the simplex of Nelder and Mead within bounds, by NLopt", true, false},
    {Algorithm::cobyla, "cobyla", "linear models (Powell), by NLopt", true, false},
    {Algorithm::crs2_lm, "crs2_lm", "controlled random search with local mutation, by NLopt", false, true},
    {Algorithm::direct_l, "direct_l", "dividing rectangles, locally biased, by NLopt", true, false},
    {Algorithm::isres, "isres", "evolution strategy with stochastic ranking, by NLopt", false, true},
    {Algorithm::esch, "esch", "evolutionary algorithm with Cauchy mutation, by NLopt", false, true},
    {Algorithm::spsa, "spsa", "simultaneous perturbation, as testers of chess engines run it", false, false},
    {Algorithm::sep_cma_es, "sep_cma_es", "separable covariance matrix adaptation, large population", false, true},
    {Algorithm::random_search, "random_search", "uniformly drawn points: what every other one has to beat", true,
     false},
}};

const Entry& entry(Algorithm algorithm) {
  const auto index = static_cast<std::size_t>(algorithm);
  assert(index < entries.size() && entries[index].algorithm == algorithm);
  return entries[index];
}

struct Refusal {
  const char* family;  // part of the names that NLopt gives its variants
  const char* reason;
};

constexpr const char* gradients = "what NLopt calls LD_ and GD_ needs gradients, which matches do not have";
constexpr const char* nested =
    "runs other algorithms inside, whose choice and tolerances a tuning file does not give; sbplx restarts by itself";

// Those of which there is more to say than that they are not offered.
constexpr std::array<Refusal, 5> refusals{{
    {"newuoa", "can hang inside NLopt; bobyqa is its successor"},
    {"praxis", "stops early and far from the optimum on noisy values"},
    {"mlsl", nested},
    {"auglag", nested},
    {"direct", "another variant of dividing rectangles: direct_l is the one that is offered"},
}};

// The name in small letters, without the beginnings that NLopt gives it. `kind` becomes "ld" and the like, or stays.
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

}  // namespace

const char* name(Algorithm algorithm) { return entry(algorithm).name; }

std::vector<std::string> algorithm_names() {
  std::vector<std::string> out;
  for (const Entry& each : entries) out.emplace_back(each.name);
  return out;
}

std::optional<Algorithm> algorithm_named(std::string_view name) {
  std::string kind;
  std::string asked = plain(name, kind);
  if (asked == "neldermead") asked = "nelder_mead";
  const auto found =
      std::find_if(entries.begin(), entries.end(), [&](const Entry& each) { return asked == each.name; });
  if (found == entries.end() || (!kind.empty() && kind.back() == 'd')) return std::nullopt;
  return found->algorithm;
}

const char* summary(Algorithm algorithm) { return entry(algorithm).summary; }

std::optional<std::string> why_unsuitable(std::string_view name) {
  if (algorithm_named(name)) return std::nullopt;
  std::string kind;
  const std::string asked = plain(name, kind);
  if (kind.ends_with('d')) return gradients;
  for (const Refusal& each : refusals) {
    if (asked.find(each.family) != std::string::npos) return each.reason;
  }
  return std::nullopt;
}

bool wants_replication(Algorithm algorithm) { return entry(algorithm).wants_replication; }

bool has_population(Algorithm algorithm) { return entry(algorithm).has_population; }

std::uint64_t least_evaluations(Algorithm algorithm, std::size_t dimensions, std::size_t population) {
  const std::uint64_t n = dimensions;
  switch (algorithm) {
    case Algorithm::sbplx:
    case Algorithm::nelder_mead:
    case Algorithm::cobyla:
      return n + 2;  // a simplex, and one point beyond
    case Algorithm::bobyqa:
      return 2 * n + 3;  // the start, the points of its first model, and the model's own optimum
    case Algorithm::direct_l:
      return 2 * n + 2;  // the start, the centre, and both sides of it in each dimension
    case Algorithm::crs2_lm:
    case Algorithm::isres:
    case Algorithm::esch:
    case Algorithm::sep_cma_es:
      return first_generation(algorithm, dimensions, population) + 1;
    case Algorithm::spsa:
      return 2;
    case Algorithm::random_search:
      return 1;
  }
  return 1;
}

}  // namespace regista::study
