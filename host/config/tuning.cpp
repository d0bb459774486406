// SPDX-License-Identifier: MIT
#include "config/tuning.hpp"

#include <fmt/format.h>

#include "config/read.hpp"
#include "config/scalar.hpp"

namespace regista::config {
namespace {

constexpr Range any_number{-1e9, 1e9};
constexpr Range shares{1e-6, 1e6};

std::string text_of(const Node& node, const std::string& what) {
  const std::string text = to_line(node, what);
  if (text.empty()) throw Error(node.where(), what + ": expected a path");
  return text;
}

TunedPath path_of(const Node& node, const std::string& what, Mistakes& mistakes) {
  TunedPath out;
  out.where = node.where();
  if (node.kind() != Node::Kind::map) {
    out.pattern = text_of(node, what);
    return out;
  }
  std::string line;
  Map map{.fields = {
              required(config::line("path", line, "of a value of the team; * and ? stand for any letters")),
              numbers("range", out.range, any_number, "", "[least, largest]: inside of what is declared"),
          }};
  read(map, node, what, mistakes);
  if (mistakes.doubtful(what)) return out;
  out.pattern = text_of(node["path"], what + ".path");
  out.where = node["path"].where();
  if (!out.range) return out;
  out.range_where = node["range"].where();
  if ((*out.range)[0] > (*out.range)[1]) {
    throw Error(out.range_where,
                fmt::format("{}.range: empty: {} is more than {}", what, (*out.range)[0], (*out.range)[1]));
  }
  return out;
}

Node written(const TunedPath& path) {
  const Node pattern = Node::scalar(path.pattern, true);
  if (!path.range) return pattern;
  const Node range = sequence_of(*path.range, [](double each) { return Node::scalar(real_text(each)); });
  return Node::map({{"path", {}, pattern}, {"range", {}, range}});
}

Field tuned_paths(std::string key, std::vector<TunedPath>& paths, std::string doc) {
  const auto read_paths = [&paths](const Node& node, const std::string& what, Mistakes& mistakes) {
    elements_of(node, what, "a list of paths");
    paths.clear();
    attempt_each(node, what, mistakes, [&](const Node& element, const std::string& path, std::size_t) {
      paths.push_back(path_of(element, path, mistakes));
    });
  };
  return {std::move(key), std::move(doc),
          Own{"tuned", read_paths,
              [&paths] { return sequence_of(paths, [](const TunedPath& each) { return written(each); }); }}};
}

Field points(std::string key, std::vector<Node>& points, std::string doc) {
  const auto read_points = [&points](const Node& node, const std::string& what, Mistakes& mistakes) {
    elements_of(node, what, "a list of maps from paths to numbers");
    points.clear();
    attempt_each(node, what, mistakes, [&](const Node& point, const std::string& path, std::size_t) {
      if (point.kind() != Node::Kind::map) refuse_kind(point, path, "a map from paths to numbers");
      for (const Node::Entry& each : point.entries()) to_real(each.value, path + '.' + each.key);
      points.push_back(point);
    });
  };
  return {std::move(key), std::move(doc),
          Own{"points", read_points, [&points] { return points.empty() ? Node() : Node::sequence(points); }}};
}

// Declares a key with a measure or with a map from measures to weights. otherwise() returns the default.
template <class Otherwise>
Field measured(std::string key, std::vector<TuningObjective::Term>& terms, std::string doc, Otherwise otherwise) {
  const auto read_terms = [&terms](const Node& node, const std::string& what, Mistakes& mistakes) {
    const auto require_name = [&what](const std::string& measure, const Location& where) {
      if (measure.empty()) throw Error(where, what + ": expected a measure");
    };
    terms.clear();
    if (node.kind() != Node::Kind::map) {
      terms.push_back({to_line(node, what), 1.0, node.where()});
      require_name(terms.front().measure, node.where());
      return;
    }
    for (const Node::Entry& entry : node.entries()) {
      const std::string path = what + '.' + entry.key;
      mistakes.attempt(path, [&] {
        require_name(entry.key, entry.key_where);
        const double weight = to_real(entry.value, path);
        if (weight == 0.0) throw Error(entry.value.where(), path + ": a weight of 0");
        terms.push_back({entry.key, weight, entry.key_where});
      });
    }
    if (terms.empty() && !mistakes.doubtful(what)) throw Error(node.where(), what + ": expected a measure");
  };
  const auto write_terms = [&terms, otherwise] {
    std::vector<Node::Entry> out;
    for (const TuningObjective::Term& each : terms.empty() ? otherwise() : terms) {
      out.push_back({each.measure, {}, Node::scalar(real_text(each.weight))});
    }
    return out.empty() ? Node() : Node::map(std::move(out));
  };
  return {std::move(key), std::move(doc), Own{"measured", read_terms, write_terms}};
}

}  // namespace

static Map declare(Tuning::Opponent& opponent) {
  return {{
              required(file("team", opponent.team, "the team")),
              real("weight", opponent.weight, shares, "1", "of its matches in the objective; the sum is made 1"),
          },
          &opponent.where};
}

static Map declare(TuningObjective& objective) {
  using Terms = std::vector<TuningObjective::Term>;
  const auto usual = [&objective] {
    return objective.minimise.empty() ? Terms{{"goal_difference", 1.0, {}}} : Terms{};
  };
  return {.fields =
              {
                  measured("maximise", objective.maximise, "a measure, or measures with weights", usual),
                  measured("minimise", objective.minimise, "the same, the other way round", [] { return Terms{}; }),
              },
          .exactly_one = {"maximise", "minimise"}};
}

static Map declare(Tuning::Search& search) {
  return {{
      name("algorithm", search.algorithm, "see docs/tuning.md"),
      integer("matches", search.matches, {2, 10000000}, "1", "of the whole search, at most"),
      real("minutes", search.minutes, {0.01, 1e6}, "min", "of wall time, after which no point is begun"),
      integer("pairs", search.pairs, {1, 10000}, "1",
              "of matches with each opponent, for each point; without it what the algorithm wants"),
      integer("population", search.population, {4, 10000}, "1",
              "points of a generation; without it the algorithm's own"),
      points("start_from", search.start_from,
             "points that are evaluated first; the search begins at the best of them and the base team"),
  }};
}

static Map declare(Tuning::Selection& selection) {
  return {{
      integer("finalists", selection.finalists, {1, 64}, "1",
              "best points of the search that are played again, on other seeds"),
      integer("matches", selection.matches, {2, 1000000}, "1", "of all finalists together, at most"),
  }};
}

static Map declare(Tuning::Verification& verification) {
  return {{
      integer("candidates", verification.candidates, {1, 16}, "1",
              "best finalists that are compared with the base team, on held-out seeds"),
      integer("matches", verification.matches, {4, 10000000}, "1",
              "of the candidates and the base team together, at most"),
      choice("against", verification.against, {"opponents", "base"},
             "whom candidate and base team play: the opponents, or each other"),
      choice("test", verification.test, {"betting", "symmetric"},
             "of the differences: betting holds for any law of an objective that has bounds"),
      real("confidence", verification.confidence, {0.5, 0.9999}, "1", "of the verdict"),
  }};
}

static Map declare(Tuning::Slices& slices) {
  return {{
      integer("points", slices.points, {0, 101}, "1",
              "of each parameter, over its range, the others as tuned; 0 is none"),
      integer("pairs", slices.pairs, {2, 10000}, "1", "of matches with each opponent, for each point"),
  }};
}

Map declare(Tuning& tuning) {
  return {joined(
      {
          required(name("tuning", tuning.name, "name of this tuning")),
          without_effect(line("question", tuning.question, "what it is to answer")),
          required(file("team", tuning.team, "the team that is tuned: the base")),
          required(list("opponents", tuning.opponents, 1, 32, "that it plays against")),
          required(tuned_paths("parameters", tuning.parameters, "values of the team that may change")),
          section("objective", tuning.objective, "what counts as better; without it goal_difference is maximised"),
          integer("seed", tuning.seed, {0, 2147483647}, "1", "of the search, and of the first matches"),
          file("disturbance", tuning.disturbance, "of the tuned team; `none` is built in", "none"),
          file("opponent_disturbance", tuning.opponent_disturbance, "of the opponents", "none"),
          section("search", tuning.search, "how the space is searched"),
          section("selection", tuning.selection, "which of the points found are candidates"),
          section("verification", tuning.verification, "whether they are better than the base team"),
          section("slices", tuning.slices, "what each parameter does around the tuned point"),
      },
      fields_of(tuning.settings, "values laid over documents, by path"))};
}

void check(const Tuning& tuning, const Node& document, Mistakes& mistakes) {
  if (tuning.verification.candidates > tuning.selection.finalists) {
    Refusals(document, mistakes)({"verification.candidates", "selection.finalists"},
                                 "verification.candidates: {} of {} finalists", tuning.verification.candidates,
                                 tuning.selection.finalists);
  }
}

}  // namespace regista::config
