// SPDX-License-Identifier: MIT
// The numbers that a tuning may change. A team's document and the declarations of its plugins define these numbers. The
// user selects some of them by path or pattern. For the search, the selected numbers are a point of the unit cube.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "config/declaration.hpp"
#include "config/node.hpp"
#include "config/tuning.hpp"

namespace regista::study {

// A number of a team and its declaration: a parameter of a plugin, or a utility term's weight (range: the key `tune`).
struct Parameter {
  std::string path;                // "sender.params.period", "contexts.search.use.assigner.params.depth"
  double start = 0.0;              // value of the base team
  double least = 0.0, most = 0.0;  // closed range; least == most: the parameter is fixed
  bool integer = false, log_scale = false;
  std::string unit, doc;

  bool fixed() const { return least == most; }
  friend bool operator==(const Parameter&, const Parameter&) = default;
};

struct Tunable : Parameter {
  std::string refusal;  // why the number cannot be tuned; empty: it can be tuned
  bool said = true;     // the document names the number or its plugin at this path; false: patterns skip the number
};

// All numbers of a team, in the order of the document. The list of a context includes numbers that the context does not
// set, but could set. team: a resolved document without errors. plugins: the plugins that the document may name.
std::vector<Tunable> tunables(const config::Node& team, std::span<const config::PluginDeclaration> plugins);

// The parameters that the paths and patterns name, each once, in the order of the team's document. If several paths
// name a parameter, the last path with a range sets its range. Throws config::Error if a path names nothing (the
// message lists the nearest names) or names a number that cannot be tuned. Throws config::Error also if a range is
// wider than declared or does not contain the team's own value.
std::vector<Parameter> chosen_parameters(std::span<const config::TunedPath> paths, std::span<const Tunable> all);

// The value, limited to the range and rounded. An integer parameter becomes a whole number. Any other parameter keeps
// six digits, or more if the range is narrow compared with its limits.
double rounded(const Parameter& parameter, double value);

// The value as a document writes it. Reading this text gives exactly this value.
std::string text_of(const Parameter& parameter, double value);

// share_of(): the part of the range below a value, on the parameter's scale; 0 if fixed. value_at_share(): the inverse.
double share_of(const Parameter& parameter, double value);
double value_at_share(const Parameter& parameter, double share);  // rounded, except at the ends of the range

}  // namespace regista::study
