// SPDX-License-Identifier: MIT
// The numbers that a tuning may change: found in a team's document by what it and its plugins declare, chosen by path
// or pattern, and mapped to the unit cube in which is searched.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "config/node.hpp"
#include "config/plugin_declaration.hpp"
#include "config/tuning.hpp"

namespace regista::study {

// A number of a team, with what is declared about it: a parameter of a plugin, or the weight of a term of the utility,
// whose range is its `tune`.
struct Tunable {
  std::string path;                // "sender.params.period", "contexts.search.use.assigner.params.depth"
  double value = 0.0;              // in force
  double least = 0.0, most = 0.0;  // closed
  bool integer = false, log_scale = false;
  std::string unit, doc;
  std::string refusal;  // why it cannot be tuned; empty: it can
  bool said = true;     // the document has it at this path, or has its plugin there: a pattern may mean it
};

// All of them, in the order of the document; for contexts also those that a context does not set, but could.
// team: a resolved document that has been read without an error. plugins: those that it may name.
std::vector<Tunable> tunables(const config::Node& team, std::span<const config::PluginDeclaration> plugins);

struct Parameter {
  std::string path;
  double start = 0.0;              // value of the base team
  double least = 0.0, most = 0.0;  // least == most: it stays there
  bool integer = false, log_scale = false;
  std::string unit, doc;

  bool fixed() const { return least == most; }
  friend bool operator==(const Parameter&, const Parameter&) = default;
};

// Those that the paths and patterns name, in the order of the team's document, each once, ranges narrowed as asked (the
// last path that names it and has a range). Throws config::Error at the path: it names nothing (with the nearest),
// something that cannot be tuned, a range that is wider than declared or does not contain the team's own value.
std::vector<Parameter> chosen_parameters(std::span<const config::TunedPath> paths, std::span<const Tunable> all);

// A value that can be written in few digits (six, more in a range that is narrow for its size; or a whole number),
// inside of the range.
double rounded(const Parameter& parameter, double value);

// As a document writes it; reads as exactly this value.
std::string text_of(const Parameter& parameter, double value);

// Between a value and its share of the range, on the parameter's scale; 0 of a fixed one.
double share_of(const Parameter& parameter, double value);
double value_at_share(const Parameter& parameter, double share);  // rounded, but for the ends

}  // namespace regista::study
