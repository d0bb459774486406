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

#include "config/disturbance.hpp"
#include "config/experiment.hpp"
#include "config/load.hpp"
#include "config/mistakes.hpp"
#include "config/node.hpp"
#include "config/opening.hpp"
#include "config/plugin_declaration.hpp"
#include "config/predictor_study.hpp"
#include "config/robot.hpp"
#include "config/rules.hpp"
#include "config/show.hpp"
#include "config/team.hpp"
#include "config/tournament.hpp"
#include "config/tuning.hpp"

namespace regista::config {

// Each reads a file with what it extends, overrides laid over it ("path=value"), every value checked alone and against
// the others. Throws Error at the first thing that is wrong.
Rules read_rules(const std::filesystem::path& file, const Overrides& overrides = {});
Robot read_robot(const std::filesystem::path& file, const Overrides& overrides = {});
Disturbance read_disturbance(const std::filesystem::path& file, const Overrides& overrides = {});
Opening read_opening(const std::filesystem::path& file, const Overrides& overrides = {});
Team read_team(const std::filesystem::path& file, const Overrides& overrides = {});
PredictorStudy read_predictor_study(const std::filesystem::path& file, const Overrides& overrides = {});
Tournament read_tournament(const std::filesystem::path& file, const Overrides& overrides = {});
Experiment read_experiment(const std::filesystem::path& file, const Overrides& overrides = {});
Tuning read_tuning(const std::filesystem::path& file, const Overrides& overrides = {});

// The same from a loaded document.
Rules read_rules(const Node& document);
Robot read_robot(const Node& document);
Disturbance read_disturbance(const Node& document);
Opening read_opening(const Node& document);
Team read_team(const Node& document);
PredictorStudy read_predictor_study(const Node& document);
Tournament read_tournament(const Node& document);
Experiment read_experiment(const Node& document);
Tuning read_tuning(const Node& document);

// The same, telling of every mistake. After one, what is read is good for nothing but to look for more of them.
Rules read_rules(const Node& document, Mistakes& mistakes);
Robot read_robot(const Node& document, Mistakes& mistakes);
Disturbance read_disturbance(const Node& document, Mistakes& mistakes);
Opening read_opening(const Node& document, Mistakes& mistakes);
Team read_team(const Node& document, Mistakes& mistakes);
PredictorStudy read_predictor_study(const Node& document, Mistakes& mistakes);
Tournament read_tournament(const Node& document, Mistakes& mistakes);
Experiment read_experiment(const Node& document, Mistakes& mistakes);
Tuning read_tuning(const Node& document, Mistakes& mistakes);

enum class DocumentKind { rules, robot, disturbance, opening, team, predictor_study, tournament, experiment, tuning };

// As documents, commands and schemas name it.
std::string_view name_of(DocumentKind kind);
std::span<const DocumentKind> document_kinds();
// All names, with "or" or "and" before the last.
std::string document_kind_names(std::string_view before_last);

// Throws Error at the document when it says no kind.
DocumentKind kind_of(const Node& document);

// Throws Error at the document when it is of another kind.
void require_kind(const Node& document, DocumentKind kind);

// Reads a document of whatever kind and returns the kind. Throws as the readers do.
DocumentKind check(const std::filesystem::path& file, const Overrides& overrides = {});

// The resolved document as YAML: every value that is in force, defaults too, each with its unit, its meaning and where
// it came from. Reading it gives the same values. Parameters of plugins that are declared are shown like any other
// value; those of other plugins as they stand. Throws as the readers do.
std::string show(const Node& document, std::span<const PluginDeclaration> plugins = {},
                 Remarks remarks = Remarks::with);
std::string show(const std::filesystem::path& file, const Overrides& overrides = {},
                 std::span<const PluginDeclaration> plugins = {});

// Calls use() with the declaration of a kind of document that says nothing, so with all defaults.
void with_declaration(DocumentKind kind, const std::function<void(const Map&)>& use);

// What is asked of a study: its document, with values of options and of `--set` laid over it.
struct StudyRequest {
  std::string file;  // empty: the options say all
  // Of options, in their order: each takes the place of what stands at its path, and null takes that away.
  Overrides options;
  // Those whose first key the document has not are laid over the documents of its matches, so they go to its `set`.
  std::vector<std::string> set;
};
Node requested(const StudyRequest& request, DocumentKind kind);

// JSON Schema (draft 2020-12) of a kind of document, for editors. With plugins, only those are known, each with its own
// parameters; without, every plugin and every parameter passes. Files with `extends` need not be complete.
std::string schema(DocumentKind kind, std::span<const PluginDeclaration> plugins = {});

}  // namespace regista::config
