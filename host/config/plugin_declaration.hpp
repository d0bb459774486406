// SPDX-License-Identifier: MIT
// What a plugin declares about itself, as far as documents are concerned: filled by whoever opens plugins, so that the
// schema and `show` know their parameters while this room knows no plugin. Mirrors regista_parameter of the ABI.
#pragma once

#include <string>
#include <vector>

namespace regista::config {

struct PluginParameter {
  enum class Type { real, integer, boolean, choice, text, file };

  std::string name = {};
  Type type = Type::real;
  double minimum = 0.0, maximum = 0.0;  // closed range; real and integer
  std::string unit = {};                // SI symbol, "1" for a plain number, "" where there is none
  std::string doc = {};
  double initial = 0.0;                   // default: real, integer, boolean (0 or 1), choice (index)
  std::string initial_text = {};          // default: text; for a file empty = none
  std::vector<std::string> choices = {};  // choice only
  bool tunable = false, log_scale = false;
};

// One for each kind that a plugin implements.
struct PluginDeclaration {
  std::string id;
  std::string kind;  // "predictor", "context", "positioner", "utility", "assigner", "sender"
  std::string summary = {};
  std::vector<PluginParameter> parameters = {};
};

}  // namespace regista::config
