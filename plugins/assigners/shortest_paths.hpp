// SPDX-License-Identifier: MIT
// The rectangular assignment problem by shortest augmenting paths, with dual variables: Jonker and Volgenant, "A
// shortest augmenting path algorithm for dense and sparse linear assignment problems", Computing 38, 1987, in the
// rectangular form of Crouse, "On implementing 2D rectangular assignment algorithms", IEEE Trans. Aerospace and
// Electronic Systems 52(4), 2016. O(agents^2 * objects).
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

namespace assignment {

inline constexpr double infinity = std::numeric_limits<double>::infinity();
inline constexpr std::int32_t nobody = -1;

// A cost of two ranks: first how many agents stay without an object, then the sum. Exact where a large number in place
// of the first rank would swallow digits of the second.
struct Ranked {
  std::int32_t left_out = 0;
  double sum = 0.0;
  friend Ranked operator+(Ranked a, Ranked b) { return {a.left_out + b.left_out, a.sum + b.sum}; }
  friend Ranked operator-(Ranked a, Ranked b) { return {a.left_out - b.left_out, a.sum - b.sum}; }
  friend bool operator<(Ranked a, Ranked b) {
    return a.left_out != b.left_out ? a.left_out < b.left_out : a.sum < b.sum;
  }
};

// Dense costs, row-major, at most as many agents as objects; infinity forbids a pair.
struct Costs {
  const double* values;
  std::size_t agents, objects;
};

// An assignment of least cost and the dual variables that prove it: cost - agent_dual - object_dual >= 0 for every
// pair, and = 0 for the assigned ones; object_dual <= 0, and = 0 for objects that stay free.
//
// Cost = double: every agent gets an object, or solve() returns false and nothing else is defined. Cost = Ranked: as
// many agents as possible get one, at the least sum among such assignments; agents without one have the dual {1, 0}.
template <class Cost>
class ShortestPaths {
 public:
  static constexpr bool may_leave_out = std::is_same_v<Cost, Ranked>;

  std::vector<std::int32_t> object_of, agent_of;  // or nobody
  std::vector<Cost> agent_dual, object_dual;

  void reserve(std::size_t agents, std::size_t objects) {
    object_of.reserve(agents);
    agent_dual.reserve(agents);
    tree_.reserve(agents);
    agent_of.reserve(objects);
    object_dual.reserve(objects);
    distance_.reserve(objects);
    before_.reserve(objects);
    remaining_.reserve(objects);
  }

  bool solve(const Costs& costs) {
    object_of.assign(costs.agents, nobody);
    agent_of.assign(costs.objects, nobody);
    distance_.resize(costs.objects);
    before_.resize(costs.objects);
    remaining_.resize(costs.objects);
    tree_.resize(costs.agents);
    return solve_on(costs);
  }

  // Begins with the pairs as they stand after solve() with as many agents and objects, or after changes to object_of
  // and agent_of (an inverse pair, always); duals are forgotten. The pairs must be optimal under duals of 0: each costs
  // 0, and no allowed pair costs less.
  bool solve_on(const Costs& costs) {
    agent_dual.assign(costs.agents, Cost{});
    object_dual.assign(costs.objects, Cost{});
    for (std::size_t agent = 0; agent < costs.agents; ++agent) {
      if (object_of[agent] == nobody && !add(costs, static_cast<std::int32_t>(agent))) return false;
    }
    return true;
  }

 private:
  static std::size_t at(std::int32_t index) { return static_cast<std::size_t>(index); }

  static Cost unreachable() {
    if constexpr (may_leave_out) {
      return {std::numeric_limits<std::int32_t>::max(), infinity};
    } else {
      return infinity;
    }
  }

  static Cost finite(double cost) {
    if constexpr (may_leave_out) {
      return {0, cost};
    } else {
      return cost;
    }
  }

  // Brings one more agent in along the shortest path of reassignments to a free object, or, failing that and if
  // allowed, to the agent that is cheapest to leave out.
  bool add(const Costs& costs, std::int32_t newcomer) {
    const std::size_t objects = costs.objects;
    for (std::size_t j = 0; j < objects; ++j) {
      distance_[j] = unreachable();
      remaining_[j] = static_cast<std::int32_t>(j);
    }
    std::size_t left = objects, reached = 0, in_tree = 0;
    Cost least{};
    std::int32_t agent = newcomer, sink = nobody, outcast = nobody;
    Cost outcast_distance = unreachable();
    while (true) {
      tree_[in_tree++] = agent;
      if constexpr (may_leave_out) {
        const Cost price = least + Cost{1, 0.0} - agent_dual[at(agent)];
        if (price < outcast_distance) {
          outcast_distance = price;
          outcast = agent;
        }
      }
      const double* row = costs.values + at(agent) * objects;
      const Cost offset = least - agent_dual[at(agent)];
      Cost nearest = unreachable();
      std::size_t where = left;
      for (std::size_t k = 0; k < left; ++k) {
        const std::size_t j = at(remaining_[k]);
        if (row[j] != infinity) {
          const Cost through = offset + finite(row[j]) - object_dual[j];
          if (through < distance_[j]) {
            distance_[j] = through;
            before_[j] = agent;
          }
        }
        // Of equally near objects a free one ends the search.
        if (distance_[j] < nearest || (agent_of[j] == nobody && where < left && !(nearest < distance_[j]))) {
          nearest = distance_[j];
          where = k;
        }
      }
      if (outcast != nobody && (where == left || outcast_distance < nearest)) {
        least = outcast_distance;
        break;
      }
      if (where == left) return false;
      least = nearest;
      const std::int32_t object = remaining_[where];
      // The objects that the tree has taken collect behind the remaining ones.
      remaining_[where] = remaining_[left - 1];
      remaining_[--left] = object;
      ++reached;
      if (agent_of[at(object)] == nobody) {
        sink = object;
        break;
      }
      agent = agent_of[at(object)];
    }

    agent_dual[at(newcomer)] = agent_dual[at(newcomer)] + least;
    for (std::size_t k = 1; k < in_tree; ++k) {
      Cost& dual = agent_dual[at(tree_[k])];
      dual = dual + (least - distance_[at(object_of[at(tree_[k])])]);
    }
    for (std::size_t k = 0; k < reached; ++k) {
      const std::size_t j = at(remaining_[objects - 1 - k]);
      object_dual[j] = object_dual[j] - (least - distance_[j]);
    }

    if (sink == nobody) {  // somebody is left out; his object is handed back along the path
      if (outcast == newcomer) return true;
      sink = object_of[at(outcast)];
      object_of[at(outcast)] = nobody;
    }
    for (std::int32_t object = sink, taker = nobody; taker != newcomer;) {
      taker = before_[at(object)];
      agent_of[at(object)] = taker;
      const std::int32_t handed_on = object_of[at(taker)];
      object_of[at(taker)] = object;
      object = handed_on;
    }
    return true;
  }

  std::vector<Cost> distance_;
  std::vector<std::int32_t> before_, remaining_, tree_;
};

}  // namespace assignment
