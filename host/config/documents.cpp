// SPDX-License-Identifier: MIT
#include "config/documents.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "config/team_document.hpp"
#include "texts/message.hpp"

namespace regista::config {
namespace {

// A path of a study that begins with one of these keys leads into a document of the matches.
constexpr std::array<std::string_view, 8> of_matches{"rules",    "robot",   "disturbance", "opponent_disturbance",
                                                     "opponent", "opening", "home",        "away"};

bool is_of_a_match(std::string_view path, const Map& study) {
  const std::string_view first = path.substr(0, path.find('.'));
  const bool of_match = std::ranges::find(of_matches, first) != of_matches.end();
  if (of_match && first.size() < path.size()) return true;
  if (std::ranges::find(study.fields, first, &Field::key) != study.fields.end()) return false;
  // If neither the team nor the study has the key, the message is about the document with the most similar key.
  const auto distance = [first](const Map& declared) {
    std::size_t least = first.size();
    for (const Field& each : declared.fields) least = std::min(least, texts::edit_distance(first, each.key));
    return least;
  };
  const bool letter = first.size() == 1 && (first[0] | 0x20) >= 'a' && (first[0] | 0x20) <= 'z';
  TeamDocument page;
  return letter || of_match || distance(declare(page)) < distance(study);
}

// Returns the study's document with the override added to its map `set`, whose keys are paths.
Node set_in(const Node& document, const Override& override) {
  const Node set = document["set"];
  if (set && set.kind() != Node::Kind::map) return document;  // the reader reports this mistake
  const auto others = [](const Node& map, std::string_view key) {
    std::vector<Node::Entry> entries(map.entries().begin(), map.entries().end());
    std::erase_if(entries, [&](const Node::Entry& each) { return each.key == key; });
    return entries;
  };
  std::vector<Node::Entry> entries = others(document, "set"), settings = others(set, override.path);
  settings.push_back({override.path, override.where, override.value});
  entries.push_back({"set", override.where, Node::map(std::move(settings), set ? set.where() : override.where)});
  return Node::map(std::move(entries), document.where());
}

// Returns a copy of the document in which the value of the option replaces the old value. A null removes the old value.
Node replaced(const Node& document, const Override& option) {
  const Node before = value_at(document, option.path);
  const bool removes = option.value.kind() == Node::Kind::null;
  // A null does not remove the value of another option. The reader then reports that the two options conflict.
  if (before && removes && before.where().is_laid()) return document;
  const Node without = before ? with(document, option.path, Node::null(option.where), option.where) : document;
  return removes ? without : with(without, option.path, option.value, option.where);
}

}  // namespace

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
    "from an empty file to a team.",
    [](const Use& use) {
      TeamDocument page;
      use(declare(page));
    },
    [](const Node& document, Mistakes& mistakes, const Use& use) {
      read_document<Team>(document, mistakes);  // also checks the contexts; read_team_document() does not
      TeamDocument page = read_team_document(document, mistakes);
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

const DocumentKind& kind_of(const Node& document) {
  // Studies come first, because a study also has keys such as `team` and `rules`, which name other kinds.
  for (const DocumentKind* const kind :
       {&DocumentKind::tournament, &DocumentKind::experiment, &DocumentKind::tuning, &DocumentKind::team}) {
    if (document[kind->name]) return *kind;
  }
  for (const DocumentKind& each : document_kinds()) {
    if (document[each.name]) return each;
  }
  std::vector<std::string> names = texts::names_of(document_kinds(), &DocumentKind::name);
  const std::string last = std::move(names.back());
  names.pop_back();
  throw Error(document.where(),
              fmt::format("no key says what this is: {} or {}, with its name", texts::join(names), last));
}

void require_kind(const Node& document, const DocumentKind& kind) {
  const bool known = std::ranges::find(document_kinds(), kind) != document_kinds().end();
  if (known ? kind_of(document) == kind : static_cast<bool>(document[kind.name])) return;
  throw Error(document.where(),
              fmt::format("this is {} document; expected {} document", texts::with_article(kind_of(document).name),
                          texts::with_article(kind.name)));
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

}  // namespace regista::config
