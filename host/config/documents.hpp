// SPDX-License-Identifier: MIT
// Reads, shows and describes the nine kinds of documents. The kind of a document follows from the key that holds its
// name (`rules: spl2023`, `robot: nao`, `disturbance: none`, `opening: overload`, `team: paper`, `predictor_study:
// ssl_ball`, `tournament: rivals`, `experiment: role_overlap`, `tuning: weights`).
#pragma once

#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "config/declaration.hpp"
#include "config/disturbance.hpp"
#include "config/errors.hpp"
#include "config/experiment.hpp"
#include "config/node.hpp"
#include "config/opening.hpp"
#include "config/overlay.hpp"
#include "config/predictor_study.hpp"
#include "config/read.hpp"
#include "config/robot.hpp"
#include "config/rules.hpp"
#include "config/team.hpp"
#include "config/tournament.hpp"
#include "config/tuning.hpp"
#include "config/values.hpp"

namespace regista::config {

// A kind of document. The declaration of its struct defines reading, checking, `show`, schema and command-line help.
struct DocumentKind {
  using Use = std::function<void(const Map& declaration)>;

  std::string_view name;   // key that holds the document's name; commands use this key as the name of the kind
  std::string_view about;  // one sentence for the reference
  void (*with_defaults)(const Use& use);  // calls `use` with the declaration of the default values
  // Reads and checks the document, and calls `use` with the declaration of its values.
  void (*with_values)(const Node& document, Mistakes& mistakes, const Use& use);

  friend bool operator==(const DocumentKind& a, const DocumentKind& b) { return a.name == b.name; }

  static const DocumentKind rules, robot, disturbance, opening, team, predictor_study, tournament, experiment, tuning;
};

// Throws Error at the document if it is not of this kind.
void require_kind(const Node& document, const DocumentKind& kind);

// Each function returns the kind of document for one struct. The pointer only selects the function.
inline const DocumentKind& declared_kind(const Rules*) { return DocumentKind::rules; }
inline const DocumentKind& declared_kind(const Robot*) { return DocumentKind::robot; }
inline const DocumentKind& declared_kind(const Disturbance*) { return DocumentKind::disturbance; }
inline const DocumentKind& declared_kind(const Opening*) { return DocumentKind::opening; }
inline const DocumentKind& declared_kind(const PredictorStudy*) { return DocumentKind::predictor_study; }
inline const DocumentKind& declared_kind(const Tournament*) { return DocumentKind::tournament; }
inline const DocumentKind& declared_kind(const Experiment*) { return DocumentKind::experiment; }
inline const DocumentKind& declared_kind(const Tuning*) { return DocumentKind::tuning; }

// Reads a loaded document. Checks each value, then the values against each other. Reports every mistake. After a
// mistake the returned values may be used only to search for more mistakes.
template <class Document>
Document read_document(const Node& document, Mistakes& mistakes) {
  require_kind(document, declared_kind(static_cast<const Document*>(nullptr)));
  Document out;
  read(declare(out), document, "", mistakes);
  check(out, document, mistakes);  // checks the values against each other
  return out;
}
template <>
Team read_document<Team>(const Node& document, Mistakes& mistakes);

// Reads and checks a loaded document. Throws Error at the first mistake.
template <class Document>
Document read_document(const Node& document) {
  Mistakes first(Mistakes::After::stop);
  return read_document<Document>(document, first);
}
// Loads a file and the files that it extends, lays the overrides ("path=value") over the document, and reads and checks
// the result. Throws Error at the first mistake.
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

// Returns the kind of a document. Throws Error at the document if it has none of the keys that name a kind.
const DocumentKind& kind_of(const Node& document);

// Returns the document as YAML: every value in force, also defaults, with unit, meaning and origin. Reading this text
// gives the same values. Parameters of a plugin that is not in `plugins` appear as written. Throws Error at a mistake.
std::string show(const Node& document, const DocumentKind& kind, std::span<const PluginDeclaration> plugins,
                 Remarks remarks);
std::string show(const Node& document, std::span<const PluginDeclaration> plugins = {},
                 Remarks remarks = Remarks::with);

// A study that a command line requests: a document, and the values that options and `--set` change in it.
struct StudyRequest {
  std::string file;  // empty: the options hold the whole study
  // Values of command-line options, in their order. A value replaces the study's value at the path; null removes it.
  Overrides options;
  // Texts "path=value" of `--set`. If the study has no key with the first part of the path, the value changes the
  // documents of the matches. It is then added to the map `set` of the study.
  std::vector<std::string> set;
};
Node requested(const StudyRequest& request, const DocumentKind& kind);

// Returns the JSON Schema (draft 2020-12) of a kind of document, for editors. The schema accepts only the given plugins
// and their parameters; with an empty list it accepts all plugins. A document with `extends` may lack any key.
std::string schema(const DocumentKind& kind, std::span<const PluginDeclaration> plugins = {});

// Returns a Markdown page with values, default and meaning of each key of these kinds of documents, in this order. The
// page also explains the syntax of values.
std::string reference_text(std::span<const DocumentKind> kinds);

}  // namespace regista::config
