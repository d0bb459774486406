// SPDX-License-Identifier: MIT
#include "config/documents.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "config/check.hpp"
#include "config/overlay.hpp"
#include "config/profiles.hpp"
#include "config/read.hpp"
#include "config/schema.hpp"
#include "config/show.hpp"
#include "config/team_page.hpp"
#include "texts/nearest.hpp"

namespace regista::config {
namespace {

struct NamedKind {
  DocumentKind kind;
  std::string_view name;
};

// In the order of DocumentKind.
constexpr std::array named_kinds{
    NamedKind{DocumentKind::rules, "rules"},
    NamedKind{DocumentKind::robot, "robot"},
    NamedKind{DocumentKind::disturbance, "disturbance"},
    NamedKind{DocumentKind::opening, "opening"},
    NamedKind{DocumentKind::team, "team"},
    NamedKind{DocumentKind::predictor_study, "predictor_study"},
    NamedKind{DocumentKind::tournament, "tournament"},
    NamedKind{DocumentKind::experiment, "experiment"},
    NamedKind{DocumentKind::tuning, "tuning"},
};

// Calls use(value, declaration) for a read document of the kind it says, checked.
template <class Use>
auto visit(const Node& document, Use use) {
  switch (kind_of(document)) {
    case DocumentKind::rules: {
      Rules rules = read_rules(document);
      return use(declare(rules));
    }
    case DocumentKind::robot: {
      Robot robot = read_robot(document);
      return use(declare(robot));
    }
    case DocumentKind::disturbance: {
      Disturbance disturbance = read_disturbance(document);
      return use(declare(disturbance));
    }
    case DocumentKind::opening: {
      Opening opening = read_opening(document);
      return use(declare(opening));
    }
    case DocumentKind::predictor_study: {
      PredictorStudy study = read_predictor_study(document);
      return use(declare(study));
    }
    case DocumentKind::tournament: {
      Tournament tournament = read_tournament(document);
      return use(declare(tournament));
    }
    case DocumentKind::experiment: {
      Experiment experiment = read_experiment(document);
      return use(declare(experiment));
    }
    case DocumentKind::tuning: {
      Tuning tuning = read_tuning(document);
      return use(declare(tuning));
    }
    case DocumentKind::team:
      break;
  }
  read_team(document);  // checks the contexts too, which the page alone does not
  TeamPage page = read_team_page(document);
  return use(declare(page));
}

}  // namespace

std::string_view name_of(DocumentKind kind) { return named_kinds[static_cast<std::size_t>(kind)].name; }

std::span<const DocumentKind> document_kinds() {
  static constexpr auto kinds = [] {
    std::array<DocumentKind, named_kinds.size()> out{};
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = named_kinds[i].kind;
    return out;
  }();
  return kinds;
}

std::string document_kind_names(std::string_view before_last) {
  std::string out;
  for (const NamedKind& each : named_kinds) {
    const bool last = &each == &named_kinds.back();
    if (&each != &named_kinds.front()) out += last ? fmt::format(" {} ", before_last) : ", ";
    out += each.name;
  }
  return out;
}

DocumentKind kind_of(const Node& document) {
  // Studies name a team, rules and more; a team has a key `roles` and may one day have one of the others.
  for (const DocumentKind kind :
       {DocumentKind::tournament, DocumentKind::experiment, DocumentKind::tuning, DocumentKind::team}) {
    if (document[name_of(kind)]) return kind;
  }
  for (const NamedKind& each : named_kinds) {
    if (document[each.name]) return each.kind;
  }
  throw Error(document.where(), fmt::format("no key says what this is: {}, with its name", document_kind_names("or")));
}

static std::string with_article(DocumentKind kind) {
  return fmt::format("{} {}", kind == DocumentKind::opening || kind == DocumentKind::experiment ? "an" : "a",
                     name_of(kind));
}

void require_kind(const Node& document, DocumentKind kind) {
  const DocumentKind found = kind_of(document);
  if (found == kind) return;
  throw Error(document.where(),
              fmt::format("this is {} document; expected {} document", with_article(found), with_article(kind)));
}

// Read, and found sound in itself.
template <class Document>
static Document read_sound(const Node& document, DocumentKind kind, Mistakes& mistakes) {
  require_kind(document, kind);
  Document out;
  read(declare(out), document, "", mistakes);
  if constexpr (requires { check(out, document, mistakes); }) check(out, document, mistakes);
  return out;
}

Rules read_rules(const Node& document, Mistakes& mistakes) {
  return read_sound<Rules>(document, DocumentKind::rules, mistakes);
}
Robot read_robot(const Node& document, Mistakes& mistakes) {
  return read_sound<Robot>(document, DocumentKind::robot, mistakes);
}
Disturbance read_disturbance(const Node& document, Mistakes& mistakes) {
  return read_sound<Disturbance>(document, DocumentKind::disturbance, mistakes);
}
Opening read_opening(const Node& document, Mistakes& mistakes) {
  return read_sound<Opening>(document, DocumentKind::opening, mistakes);
}
PredictorStudy read_predictor_study(const Node& document, Mistakes& mistakes) {
  return read_sound<PredictorStudy>(document, DocumentKind::predictor_study, mistakes);
}
Tournament read_tournament(const Node& document, Mistakes& mistakes) {
  return read_sound<Tournament>(document, DocumentKind::tournament, mistakes);
}
Experiment read_experiment(const Node& document, Mistakes& mistakes) {
  return read_sound<Experiment>(document, DocumentKind::experiment, mistakes);
}
Tuning read_tuning(const Node& document, Mistakes& mistakes) {
  return read_sound<Tuning>(document, DocumentKind::tuning, mistakes);
}

template <class Document>
static Document read_first(const Node& document, Document (*reader)(const Node&, Mistakes&)) {
  Mistakes first(Mistakes::After::stop);
  return reader(document, first);
}

Rules read_rules(const Node& document) { return read_first<Rules>(document, &read_rules); }
Robot read_robot(const Node& document) { return read_first<Robot>(document, &read_robot); }
Disturbance read_disturbance(const Node& document) { return read_first<Disturbance>(document, &read_disturbance); }
Opening read_opening(const Node& document) { return read_first<Opening>(document, &read_opening); }
Team read_team(const Node& document) { return read_first<Team>(document, &read_team); }
PredictorStudy read_predictor_study(const Node& document) {
  return read_first<PredictorStudy>(document, &read_predictor_study);
}
Tournament read_tournament(const Node& document) { return read_first<Tournament>(document, &read_tournament); }
Experiment read_experiment(const Node& document) { return read_first<Experiment>(document, &read_experiment); }
Tuning read_tuning(const Node& document) { return read_first<Tuning>(document, &read_tuning); }

Rules read_rules(const std::filesystem::path& file, const Overrides& overrides) {
  return read_rules(load(file, overrides));
}
Robot read_robot(const std::filesystem::path& file, const Overrides& overrides) {
  return read_robot(load(file, overrides));
}
Disturbance read_disturbance(const std::filesystem::path& file, const Overrides& overrides) {
  return read_disturbance(load(file, overrides));
}
Opening read_opening(const std::filesystem::path& file, const Overrides& overrides) {
  return read_opening(load(file, overrides));
}
Team read_team(const std::filesystem::path& file, const Overrides& overrides) {
  return read_team(load(file, overrides));
}
PredictorStudy read_predictor_study(const std::filesystem::path& file, const Overrides& overrides) {
  return read_predictor_study(load(file, overrides));
}
Tournament read_tournament(const std::filesystem::path& file, const Overrides& overrides) {
  return read_tournament(load(file, overrides));
}
Experiment read_experiment(const std::filesystem::path& file, const Overrides& overrides) {
  return read_experiment(load(file, overrides));
}
Tuning read_tuning(const std::filesystem::path& file, const Overrides& overrides) {
  return read_tuning(load(file, overrides));
}

DocumentKind check(const std::filesystem::path& file, const Overrides& overrides) {
  const Node document = load(file, overrides);
  visit(document, [](const Map&) {});
  return kind_of(document);
}

std::string show(const Node& document, std::span<const PluginDeclaration> plugins, Remarks remarks) {
  return visit(document, [&](const Map& map) { return show(map, document, plugins, remarks); });
}

std::string show(const std::filesystem::path& file, const Overrides& overrides,
                 std::span<const PluginDeclaration> plugins) {
  return show(load(file, overrides), plugins);
}

void with_declaration(DocumentKind kind, const std::function<void(const Map&)>& use) {
  const auto declared = [&use](auto document) { use(declare(document)); };
  switch (kind) {
    case DocumentKind::rules:
      return declared(Rules{});
    case DocumentKind::robot:
      return declared(Robot{});
    case DocumentKind::disturbance:
      return declared(Disturbance{});
    case DocumentKind::opening:
      return declared(Opening{});
    case DocumentKind::predictor_study:
      return declared(PredictorStudy{});
    case DocumentKind::tournament:
      return declared(Tournament{});
    case DocumentKind::experiment:
      return declared(Experiment{});
    case DocumentKind::tuning:
      return declared(Tuning{});
    case DocumentKind::team:
      return declared(TeamPage{});
  }
}

namespace {

// What stands before the first dot of a path that is of a match's documents, whatever the study is.
constexpr std::array<std::string_view, 8> of_matches{"rules",    "robot",   "disturbance", "opponent_disturbance",
                                                     "opponent", "opening", "home",        "away"};

bool is_of_a_match(std::string_view path, const Map& study) {
  const std::string_view first = path.substr(0, path.find('.'));
  const bool is_inside = first.size() < path.size();
  const auto has = [first](const Map& declared) {
    return std::ranges::find(declared.fields, first, &Field::key) != declared.fields.end();
  };
  if (std::ranges::find(of_matches, first) != of_matches.end() && is_inside) return true;
  if (has(study)) return false;
  // A key that neither has is taken for the nearer one.
  TeamPage page;
  const auto distance = [first](const Map& declared) {
    std::size_t least = first.size();
    for (const Field& each : declared.fields) least = std::min(least, texts::edit_distance(first, each.key));
    return least;
  };
  const bool letter = first.size() == 1 && (first[0] | 0x20) >= 'a' && (first[0] | 0x20) <= 'z';
  return letter || std::ranges::find(of_matches, first) != of_matches.end() ||
         distance(declare(page)) < distance(study);
}

// The same as one of the values of the study's `set`, whose keys are paths.
Node set_in(const Node& document, const Override& override) {
  std::vector<Node::Entry> entries, settings;
  for (const Node::Entry& each : document.entries()) {
    if (each.key != "set") entries.push_back(each);
  }
  const Node set = document["set"];
  if (set && set.kind() != Node::Kind::map) return document;  // a mistake, which the reader reports
  for (const Node::Entry& each : set.entries()) {
    if (each.key != override.path) settings.push_back(each);
  }
  settings.push_back({override.path, override.where, override.value});
  entries.push_back({"set", override.where, Node::map(std::move(settings), set ? set.where() : override.where)});
  return Node::map(std::move(entries), document.where());
}

// Another value, or none.
Node replaced(const Node& document, const Override& option) {
  const Node before = value_at(document, option.path);
  const bool there = static_cast<bool>(before);
  // What another option has laid there stays: the two contradict each other, which the reader says.
  if (there && option.value.kind() == Node::Kind::null && before.where().is_laid()) return document;
  const Node without = there ? with(document, option.path, Node::null(option.where), option.where) : document;
  return option.value.kind() == Node::Kind::null ? without : with(without, option.path, option.value, option.where);
}

}  // namespace

Node requested(const StudyRequest& request, DocumentKind kind) {
  Node document;
  if (request.file.empty()) {
    const std::string name(name_of(kind));
    const Location where{name, 0, 0};
    document = Node::map({{name, where, Node::scalar(name, false, where)}}, where);
  } else {
    document = load(request.file);
    require_kind(document, kind);
  }
  for (const Override& each : request.options) document = replaced(document, each);
  with_declaration(kind, [&](const Map& declared) {
    for (const Override& each : typed_overrides(request.set)) {
      document = is_of_a_match(each.path, declared) ? set_in(document, each)
                                                    : with(document, each.path, each.value, each.where);
    }
  });
  return document;
}

std::string schema(DocumentKind kind, std::span<const PluginDeclaration> plugins) {
  std::string out;
  with_declaration(
      kind, [&](const Map& declared) { out = schema(declared, fmt::format("Regista {}", name_of(kind)), plugins); });
  return out;
}

}  // namespace regista::config
