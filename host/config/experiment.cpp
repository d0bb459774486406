// SPDX-License-Identifier: MIT
#include "config/experiment.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>

#include "config/file.hpp"
#include "config/line.hpp"
#include "config/path_list.hpp"
#include "config/read.hpp"
#include "config/scalar.hpp"
#include "config/text.hpp"

namespace regista::config {
namespace {

Node sequence_of(const std::vector<Node>& elements) { return elements.empty() ? Node() : Node::sequence(elements, {}); }

std::optional<double> number_of(const Node& node) {
  if (node.kind() != Node::Kind::scalar || node.quoted()) return std::nullopt;
  try {
    return to_real(node, "");
  } catch (const Error&) {
    return std::nullopt;
  }
}

// However it is written: 0.1 and 1e-1 are one value.
bool same_value(const Node& a, const Node& b) {
  const auto number = number_of(a), other = number_of(b);
  if (number && other) return *number == *other;
  if (a.kind() != Node::Kind::sequence || b.kind() != Node::Kind::sequence) return same(a, b);
  return std::ranges::equal(a.elements(), b.elements(), same_value);
}

Field values(std::string key, std::vector<Node>& values, std::string doc) {
  return {std::move(key), std::move(doc),
          Own{"values",
              [&values](const Node& node, const std::string& what) {
                const auto elements = elements_of(node, what, "a list of values");
                values.assign(elements.begin(), elements.end());
                for (std::size_t i = 0; i < values.size(); ++i) {
                  if (values[i].kind() == Node::Kind::null) refuse_kind(values[i], what, "a value");
                  for (std::size_t j = 0; j < i; ++j) {
                    if (!same_value(values[i], values[j])) continue;
                    throw Error(values[i].where(), what + ": the same value a second time");
                  }
                }
              },
              [&values] { return sequence_of(values); }}};
}

Field lines(std::string key, std::vector<Node>& texts, std::string doc) {
  return {std::move(key), std::move(doc),
          Own{"lines",
              [&texts](const Node& node, const std::string& what) {
                const auto elements = elements_of(node, what, "a list of texts");
                for (const Node& each : elements) to_line(each, what);
                texts.assign(elements.begin(), elements.end());
              },
              [&texts] { return sequence_of(texts); }}};
}

Field pairs(std::string key, std::vector<Node>& pairs, std::string doc) {
  return {std::move(key), std::move(doc),
          Own{"pairs",
              [&pairs](const Node& node, const std::string& what) {
                const auto elements = elements_of(node, what, "a list of pairs");
                for (const Node& each : elements) {
                  if (each.kind() != Node::Kind::sequence || each.elements().size() != 2) {
                    refuse_kind(each, what, "a list of two names");
                  }
                  for (const Node& name : each.elements()) to_line(name, what);
                }
                pairs.assign(elements.begin(), elements.end());
              },
              [&pairs] { return sequence_of(pairs); }}};
}

void require_arm(const Experiment& experiment, const Node& name) {
  std::vector<std::string> known;
  for (const Experiment::Arm& arm : experiment.arms) known.push_back(arm.name);
  if (std::ranges::find(known, name.text()) != known.end()) return;
  throw Error(name.where(), "primary.compare: " + unknown("arm", name.text(), "", known));
}

}  // namespace

static Map declare(Experiment::Arm& arm) {
  return {.fields =
              {
                  required(line("name", arm.name, "what it is called in every table")),
                  file("team", arm.team, "the team that plays; without it that of the experiment"),
                  free("set", arm.set, "settings", "values laid over documents, by path"),
              },
          .where = &arm.where};
}

static Map declare(Experiment::Sweep& sweep) {
  return {.fields =
              {
                  required(line("path", sweep.path, "of the value that is varied")),
                  required(values("values", sweep.values, "that it takes, each with every arm")),
              },
          .where = &sweep.where};
}

static Map declare(Experiment::Primary& primary) {
  return {.fields =
              {
                  required(line("measure", primary.measure, "number of a match that the test is about")),
                  pairs("compare", primary.compare, "arms, two by two; without it every two of them"),
                  choice("test", primary.test, {"paired_t", "sign_flip"}, "of the differences, seed by seed"),
              },
          .where = &primary.where};
}

Map declare(Experiment& experiment) {
  return {
      .fields =
          {
              required(name("experiment", experiment.name, "name of this experiment")),
              line("question", experiment.question, "what it is to answer"),
              required(list("arms", experiment.arms, 1, 32, "what is compared")),
              file("team", experiment.team, "of arms that name none"),
              required(file("opponent", experiment.opponent, "the team that every arm plays against")),
              real("minutes", experiment.minutes, {0.01, 1e6}, "min",
                   "of the game's clock for each arm (Playing is less)"),
              integer("matches", experiment.matches, {2, 1000000}, "1",
                      "for each arm, an even number: half at home, half away"),
              integer("seed", experiment.seed, {0, 2147483647}, "1", "of the first pair of matches"),
              file("rules", experiment.rules, "rules profile; without it spl2023, built in"),
              file("robot", experiment.robot, "robot profile of all; without it nao, built in"),
              file("disturbance", experiment.disturbance, "disturbance of the arm's team; without it none"),
              file("opponent_disturbance", experiment.opponent_disturbance, "of the opponent; without it none"),
              paths("openings", experiment.openings, "scenes that matches start from: files, or folders of them"),
              real("limit", experiment.limit, {0.1, 1e6}, "s", "after which each match ends"),
              free("set", experiment.set, "settings", "values laid over documents in all arms, by path"),
              section("sweep", experiment.sweep, "a value that is varied"),
              lines("measures", experiment.measures, "numbers of a match that are shown; without it the usual ones"),
              section("primary", experiment.primary, "what is tested"),
              real("confidence", experiment.confidence, {0.5, 0.9999}, "1", "of every interval, and of the test"),
          },
      .exactly_one = {"minutes", "matches"}};
}

void check(const Experiment& experiment, const Node& document) {
  for (const Experiment::Arm& arm : experiment.arms) {
    if (arm.name.empty()) throw Error(arm.where, "arms: a name is wanted");
    if (arm.team.empty() && experiment.team.empty()) {
      throw Error(arm.where,
                  fmt::format("arm {}: which team? Name it here, or for all arms by `team`", in_quotes(arm.name)));
    }
  }
  if (experiment.matches && *experiment.matches % 2 != 0) {
    refuse(document, {"matches"},
           fmt::format("matches: {} is odd; half of them are played at home, half away", *experiment.matches));
  }
  if (!experiment.primary) return;
  const std::vector<Node>& compared = experiment.primary->compare;
  for (std::size_t i = 0; i < compared.size(); ++i) {
    const Node& pair = compared[i];
    for (const Node& arm : pair.elements()) require_arm(experiment, arm);
    if (pair.elements()[0].text() == pair.elements()[1].text()) {
      throw Error(pair.where(), "primary.compare: an arm is compared with itself");
    }
    for (std::size_t j = 0; j < i; ++j) {
      const auto arms = pair.elements(), others = compared[j].elements();
      if (std::ranges::is_permutation(arms, others, {}, &Node::text, &Node::text)) {
        throw Error(pair.where(), "primary.compare: the same two arms a second time");
      }
    }
  }
}

}  // namespace regista::config
