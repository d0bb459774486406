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

constinit const DocumentKind DocumentKind::rules = document_kind<Rules>(
    "rules", "The game: field, ball, durations, penalties, messages. Key `rules`; the default is `spl2023`.");
constinit const DocumentKind DocumentKind::robot = document_kind<Robot>(
    "robot", "What a robot can do and sense, and how wrongly it senses. Key `robot`; the default is `nao`.");
constinit const DocumentKind DocumentKind::disturbance = document_kind<Disturbance>(
    "disturbance", "What goes wrong on purpose, and when. Key `disturbance`; the default is that nothing does.");
constinit const DocumentKind DocumentKind::opening =
    document_kind<Opening>("opening", "A scene that a game starts from. Key `opening`.");
constinit const DocumentKind DocumentKind::team{
    "team",
    "A strategy: which plugins, which roles, which weights. Key `team`. [writing-a-team.md](writing-a-team.md) goes "
    "from "
    "an empty file to a team.",
    [](const Use& use) {
      TeamPage page;
      use(declare(page));
    },
    [](const Node& document, Mistakes& mistakes, const Use& use) {
      read_document<Team>(document, mistakes);  // checks the contexts too, which the page alone does not
      TeamPage page = read_team_page(document, mistakes);
      use(declare(page));
    }};
constinit const DocumentKind DocumentKind::predictor_study = document_kind<PredictorStudy>(
    "predictor_study", "A predictor measured on a recording, for `regista evaluate-predictor`. Key `predictor_study`.");
constinit const DocumentKind DocumentKind::tournament =
    document_kind<Tournament>("tournament", "Teams that play each other, for `regista tournament`. Key `tournament`.");
constinit const DocumentKind DocumentKind::experiment = document_kind<Experiment>(
    "experiment", "Arms compared in numbers of their matches, for `regista experiment`. Key `experiment`.");
constinit const DocumentKind DocumentKind::tuning =
    document_kind<Tuning>("tuning", "Numbers of a team searched for better ones, for `regista tune`. Key `tuning`.");

std::span<const DocumentKind> document_kinds() {
  using Kind = DocumentKind;
  static const std::array kinds{Kind::rules,           Kind::robot,      Kind::disturbance, Kind::opening, Kind::team,
                                Kind::predictor_study, Kind::tournament, Kind::experiment,  Kind::tuning};
  return kinds;
}

std::string document_kind_names(std::string_view before_last) {
  const std::span<const DocumentKind> kinds = document_kinds();
  std::string out;
  for (const DocumentKind& each : kinds) {
    if (&each != &kinds.front()) out += &each == &kinds.back() ? fmt::format(" {} ", before_last) : ", ";
    out += each.name;
  }
  return out;
}

const DocumentKind& kind_of(const Node& document) {
  // Studies name a team, rules and more; a team has a key `roles` and may one day have one of the others.
  for (const DocumentKind* const kind :
       {&DocumentKind::tournament, &DocumentKind::experiment, &DocumentKind::tuning, &DocumentKind::team}) {
    if (document[kind->name]) return *kind;
  }
  for (const DocumentKind& each : document_kinds()) {
    if (document[each.name]) return each;
  }
  throw Error(document.where(), fmt::format("no key says what this is: {}, with its name", document_kind_names("or")));
}

static std::string with_article(const DocumentKind& kind) {
  const bool vowel = std::string_view("aeiou").find(kind.name.front()) != std::string_view::npos;
  return fmt::format("{} {}", vowel ? "an" : "a", kind.name);
}

void require_kind(const Node& document, const DocumentKind& kind) {
  const bool known = std::ranges::find(document_kinds(), kind) != document_kinds().end();
  if (known ? kind_of(document) == kind : static_cast<bool>(document[kind.name])) return;
  throw Error(document.where(), fmt::format("this is {} document; expected {} document",
                                            with_article(kind_of(document)), with_article(kind)));
}

const DocumentKind& check(const std::filesystem::path& file, const Overrides& overrides) {
  const Node document = load(file, overrides);
  const DocumentKind& kind = kind_of(document);
  Mistakes first(Mistakes::After::stop);
  kind.with_values(document, first, [](const Map&) {});
  return kind;
}

std::string show(const Node& document, const DocumentKind& kind, std::span<const PluginDeclaration> plugins,
                 Remarks remarks) {
  std::string out;
  Mistakes first(Mistakes::After::stop);
  kind.with_values(document, first, [&](const Map& map) { out = show(map, document, plugins, remarks); });
  return out;
}

std::string show(const Node& document, std::span<const PluginDeclaration> plugins, Remarks remarks) {
  return show(document, kind_of(document), plugins, remarks);
}

std::string show(const std::filesystem::path& file, const Overrides& overrides,
                 std::span<const PluginDeclaration> plugins) {
  return show(load(file, overrides), plugins);
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

Node requested(const StudyRequest& request, const DocumentKind& kind) {
  Node document;
  if (request.file.empty()) {
    const std::string name(kind.name);
    const Location where{name, 0, 0};
    document = Node::map({{name, where, Node::scalar(name, false, where)}}, where);
  } else {
    document = load(request.file);
    require_kind(document, kind);
  }
  for (const Override& each : request.options) document = replaced(document, each);
  kind.with_defaults([&](const Map& declared) {
    for (const Override& each : typed_overrides(request.set)) {
      document = is_of_a_match(each.path, declared) ? set_in(document, each)
                                                    : with(document, each.path, each.value, each.where);
    }
  });
  return document;
}

std::string schema(const DocumentKind& kind, std::span<const PluginDeclaration> plugins) {
  std::string out;
  kind.with_defaults(
      [&](const Map& declared) { out = schema(declared, fmt::format("Regista {}", kind.name), plugins); });
  return out;
}

}  // namespace regista::config
