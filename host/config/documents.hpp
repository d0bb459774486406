// SPDX-License-Identifier: MIT
// The nine kinds of document: read, shown, described. A document says its kind by the key that holds its name
// (`rules: spl2023`, `robot: nao`, `disturbance: none`, `opening: overload`, `team: paper`, `predictor_study:
// ssl_ball`, `tournament: rivals`, `experiment: role_overlap`, `tuning: weights`).
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "config/check.hpp"
#include "config/disturbance.hpp"
#include "config/experiment.hpp"
#include "config/load.hpp"
#include "config/mistakes.hpp"
#include "config/node.hpp"
#include "config/opening.hpp"
#include "config/plugin_declaration.hpp"
#include "config/predictor_study.hpp"
#include "config/profiles.hpp"
#include "config/read.hpp"
#include "config/robot.hpp"
#include "config/rules.hpp"
#include "config/show.hpp"
#include "config/team.hpp"
#include "config/tournament.hpp"
#include "config/tuning.hpp"

namespace regista::config {

// A kind of document. The struct that declares it makes all that is done with it: how it is read and checked, what is
// shown of it, its schema, the help of options that lay values over it.
struct DocumentKind {
  using Use = std::function<void(const Map& declaration)>;

  std::string_view name;                  // the key that holds a document's name; what commands and schemas call it
  std::string_view about;                 // a sentence of the reference
  void (*with_defaults)(const Use& use);  // of a document that says nothing
  void (*with_values)(const Node& document, Mistakes& mistakes, const Use& use);  // of one that is read and checked

  friend bool operator==(const DocumentKind& a, const DocumentKind& b) { return a.name == b.name; }

  static const DocumentKind rules, robot, disturbance, opening, team, predictor_study, tournament, experiment, tuning;
};

// Throws Error at the document when it is of another kind.
void require_kind(const Node& document, const DocumentKind& kind);

// The kind that a struct declares: an overload for each, found by its type.
inline const DocumentKind& declared_kind(const Rules*) { return DocumentKind::rules; }
inline const DocumentKind& declared_kind(const Robot*) { return DocumentKind::robot; }
inline const DocumentKind& declared_kind(const Disturbance*) { return DocumentKind::disturbance; }
inline const DocumentKind& declared_kind(const Opening*) { return DocumentKind::opening; }
inline const DocumentKind& declared_kind(const PredictorStudy*) { return DocumentKind::predictor_study; }
inline const DocumentKind& declared_kind(const Tournament*) { return DocumentKind::tournament; }
inline const DocumentKind& declared_kind(const Experiment*) { return DocumentKind::experiment; }
inline const DocumentKind& declared_kind(const Tuning*) { return DocumentKind::tuning; }

// Reads a loaded document, every value checked alone and against the others, telling of every mistake. After one, what
// is read is good for nothing but to look for more of them.
template <class Document>
Document read_document(const Node& document, Mistakes& mistakes) {
  require_kind(document, declared_kind(static_cast<const Document*>(nullptr)));
  Document out;
  read(declare(out), document, "", mistakes);
  check(out, document, mistakes);  // values that are sound one by one, against each other
  return out;
}
template <>
Team read_document<Team>(const Node& document, Mistakes& mistakes);

// The same; throws Error at the first thing that is wrong.
template <class Document>
Document read_document(const Node& document) {
  Mistakes first(Mistakes::After::stop);
  return read_document<Document>(document, first);
}
// Of a file with what it extends, overrides laid over it ("path=value").
template <class Document>
Document read_document(const std::filesystem::path& file, const Overrides& overrides = {}) {
  return read_document<Document>(load(file, overrides));
}

template <class Document>
constexpr DocumentKind document_kind(std::string_view name, std::string_view about) {
  return {name, about,
          [](const DocumentKind::Use& use) {
            Document document;
            use(declare(document));
          },
          [](const Node& document, Mistakes& mistakes, const DocumentKind::Use& use) {
            Document read = read_document<Document>(document, mistakes);
            use(declare(read));
          }};
}

std::span<const DocumentKind> document_kinds();
// All names, with "or" or "and" before the last.
std::string document_kind_names(std::string_view before_last);

// Throws Error at the document when it says no kind.
const DocumentKind& kind_of(const Node& document);

// Reads a document of whatever kind and returns the kind. Throws as the readers do.
const DocumentKind& check(const std::filesystem::path& file, const Overrides& overrides = {});

// The resolved document as YAML: every value that is in force, defaults too, each with its unit, its meaning and where
// it came from. Reading it gives the same values. Parameters of plugins that are declared are shown like any other
// value; those of other plugins as they stand. Throws as the readers do.
std::string show(const Node& document, const DocumentKind& kind, std::span<const PluginDeclaration> plugins,
                 Remarks remarks);
std::string show(const Node& document, std::span<const PluginDeclaration> plugins = {},
                 Remarks remarks = Remarks::with);
std::string show(const std::filesystem::path& file, const Overrides& overrides = {},
                 std::span<const PluginDeclaration> plugins = {});

// What is asked of a study: its document, with values of options and of `--set` laid over it.
struct StudyRequest {
  std::string file;  // empty: the options say all
  // Of options, in their order: each takes the place of what stands at its path, and null takes that away.
  Overrides options;
  // Those whose first key the document has not are laid over the documents of its matches, so they go to its `set`.
  std::vector<std::string> set;
};
Node requested(const StudyRequest& request, const DocumentKind& kind);

// JSON Schema (draft 2020-12) of a kind of document, for editors. With plugins, only those are known, each with its own
// parameters; without, every plugin and every parameter passes. Files with `extends` need not be complete.
std::string schema(const DocumentKind& kind, std::span<const PluginDeclaration> plugins = {});

}  // namespace regista::config
