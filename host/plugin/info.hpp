// SPDX-License-Identifier: MIT
// What there is to say about plugins: the texts that `regista plugin list` and `regista plugin info` print.
#pragma once

#include <string>
#include <vector>

#include "plugin/catalogue.hpp"

namespace regista::plugin {

// What a plugin declares, in words. Numbers are written as short as they can be read back exactly.
struct ParameterInfo {
  std::string name, type, unit, doc;
  std::string initial;  // default, a text in quotes; empty for a file: none
  std::string range;    // "0.5 to 20 m", or the choices "first, best"; empty where there is none
  bool tunable = false, log_scale = false;
};

struct Info {
  std::string id, version, summary, licence, build_tag;
  std::string abi;  // "1.0"
  std::string file;
  std::vector<std::string> kinds;  // "assigner", ...
  std::string subjects;            // of a predictor: "ball, opponents"
  bool negotiates = false;         // of an assigner
  std::vector<ParameterInfo> parameters;
  std::vector<DeclaredMetric> metrics;
};

Info info(const Found& plugin);

// "sum, s"
std::string how_told(const DeclaredMetric& metric);

// A page about one plugin; lines end with a newline.
std::string info_text(const Found& plugin);

// A line for each plugin, by kind and then in the catalogue's order; then what was refused, and where was looked.
std::string list_text(const Catalogue& catalogue);

}  // namespace regista::plugin
