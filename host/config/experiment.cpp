// SPDX-License-Identifier: MIT
#include "config/experiment.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "config/read.hpp"
#include "config/scalar.hpp"
#include "texts/message.hpp"

namespace regista::config {
namespace {

Node list_of(const std::vector<Node>& elements) { return elements.empty() ? Node() : Node::sequence(elements); }

std::optional<double> number_of(const Node& node) {
  if (node.kind() != Node::Kind::scalar || node.quoted()) return std::nullopt;
  try {
    return to_real(node, "");
  } catch (const Error&) {
    return std::nullopt;
  }
}

// Returns whether two nodes are equal. Numbers are compared by value: 0.1 and 1e-1 are equal.
bool same_value(const Node& a, const Node& b) {
  const auto number = number_of(a), other = number_of(b);
  if (number && other) return *number == *other;
  if (a.kind() != Node::Kind::sequence || b.kind() != Node::Kind::sequence) return same(a, b);
  return std::ranges::equal(a.elements(), b.elements(), same_value);
}

void check_value(const std::vector<Node>& values, std::size_t i, const std::string& what) {
  if (values[i].kind() == Node::Kind::null) refuse_kind(values[i], what, "a value");
  for (std::size_t j = 0; j < i; ++j) {
    if (same_value(values[i], values[j])) throw Error(values[i].where(), what + ": the same value a second time");
  }
}

Field values(std::string key, std::vector<Node>& values, std::string doc) {
  const auto read_values = [&values](const Node& node, const std::string& what, Mistakes& mistakes) {
    const auto elements = elements_of(node, what, "a list of values");
    values.assign(elements.begin(), elements.end());
    for (std::size_t i = 0; i < values.size(); ++i) {
      mistakes.attempt(what, [&] { check_value(values, i, what); });
    }
  };
  return {std::move(key), std::move(doc), Own{"values", read_values, [&values] { return list_of(values); }}};
}

Field pairs(std::string key, std::vector<Node>& pairs, std::string doc) {
  const auto read_pairs = [&pairs](const Node& node, const std::string& what, Mistakes& mistakes) {
    for (const Node& each : elements_of(node, what, "a list of pairs")) {
      mistakes.attempt(what, [&] {
        if (each.kind() != Node::Kind::sequence || each.elements().size() != 2) {
          refuse_kind(each, what, "a list of two names");
        }
        for (const Node& name : each.elements()) to_line(name, what);
        pairs.push_back(each);
      });
    }
  };
  return {std::move(key), std::move(doc), Own{"pairs", read_pairs, [&pairs] { return list_of(pairs); }}};
}

void check_compared(const Experiment& experiment, Mistakes& mistakes) {
  constexpr std::string_view path = "primary.compare";
  const std::vector<std::string> known = texts::names_of(experiment.arms, &Experiment::Arm::name);
  const std::vector<Node>& compared = experiment.primary->compare;
  for (std::size_t i = 0; i < compared.size(); ++i) {
    const Node& pair = compared[i];
    if (!mistakes.doubtful("arms")) {
      for (const Node& arm : pair.elements()) {
        if (std::ranges::find(known, arm.text()) != known.end()) continue;
        mistakes.add(Error(arm.where(), "primary.compare: " + texts::unknown("arm", arm.text(), "", known)), path);
      }
    }
    if (pair.elements()[0].text() == pair.elements()[1].text()) {
      mistakes.add(Error(pair.where(), "primary.compare: an arm is compared with itself"), path);
      continue;
    }
    const bool second_time = std::ranges::any_of(std::span(compared).first(i), [&](const Node& other) {
      return std::ranges::is_permutation(pair.elements(), other.elements(), {}, &Node::text, &Node::text);
    });
    if (second_time) mistakes.add(Error(pair.where(), "primary.compare: the same two arms a second time"), path);
  }
}

}  // namespace

static Map declare(Experiment::Arm& arm) {
  return {{
              required(line("name", arm.name, "what it is called in every table")),
              file("team", arm.team, "the team that plays; without it that of the experiment"),
              free("set", arm.set, "settings", "values laid over documents, by path"),
          },
          &arm.where};
}

static Map declare(Experiment::Sweep& sweep) {
  return {{
      required(line("path", sweep.path, "of the value that is varied")),
      required(values("values", sweep.values, "that it takes, each with every arm")),
  }};
}

static Map declare(ExperimentPrimary& primary) {
  return {{
      required(line("measure", primary.measure, "number of a match that the test is about")),
      pairs("compare", primary.compare, "arms, two by two; without it every two of them"),
      choice("test", primary.test, {"paired_t", "sign_flip"}, "of the differences, seed by seed"),
  }};
}

Map declare(Experiment& experiment) {
  return {
      .fields = joined(
          {
              required(name("experiment", experiment.name, "name of this experiment")),
              without_effect(line("question", experiment.question, "what it is to answer")),
              required(list("arms", experiment.arms, 1, 32, "what is compared")),
              file("team", experiment.team, "of arms that name none"),
              required(file("opponent", experiment.opponent, "the team that every arm plays against")),
              real("minutes", experiment.minutes, {0.01, 1e6}, "min",
                   "of the game's clock for each arm (Playing is less)"),
              integer("matches", experiment.matches, {2, 1000000}, "1",
                      "for each arm, an even number: half at home, half away"),
              integer("seed", experiment.seed, {0, largest_seed}, "1",
                      "of the pairs of matches; the same seed plays the same"),
              file("disturbance", experiment.disturbance, "of the arm's team; `none` is built in", "none"),
              file("opponent_disturbance", experiment.opponent_disturbance, "of the opponent", "none"),
              section("sweep", experiment.sweep, "a value that is varied"),
              lines("measures", experiment.measures, "numbers of a match that are shown; without it the usual ones"),
              section("primary", experiment.primary, "what is tested"),
              real("confidence", experiment.confidence, {0.5, 0.9999}, "1", "of every interval, and of the test"),
          },
          fields_of(experiment.settings, "values laid over documents in all arms, by path")),
      .exactly_one = {"minutes", "matches"}};
}

void check(const Experiment& experiment, const Node& document, Mistakes& mistakes) {
  for (std::size_t i = 0; i < experiment.arms.size(); ++i) {
    const Experiment::Arm& arm = experiment.arms[i];
    const std::string name = fmt::format("arms.{}.name", i), team = fmt::format("arms.{}.team", i);
    if (arm.name.empty() && !mistakes.doubtful(name)) mistakes.add(Error(arm.where, "arms: expected a name"), name);
    if (!arm.team.empty() || !experiment.team.empty() || mistakes.doubtful(team) || mistakes.doubtful("team")) continue;
    mistakes.add(Error(arm.where, fmt::format("arm {}: which team? Name it here, or for all arms by `team`",
                                              texts::in_quotes(arm.name))),
                 team);
  }
  if (experiment.matches && *experiment.matches % 2 != 0) {
    Refusals(document, mistakes)({"matches"}, "matches: {} is odd; half of them are played at home, half away",
                                 *experiment.matches);
  }
  if (experiment.primary) check_compared(experiment, mistakes);
}

}  // namespace regista::config
