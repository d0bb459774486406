// SPDX-License-Identifier: MIT
// The ends of the ranges that a plugin declares: values at which it must work as well as at its defaults. Up to six
// numeric parameters: every corner of the box. More: each alone at its ends, all low, all high. Every choice and both
// booleans: alone, with all low and with all high.
#pragma once

#include <string>
#include <vector>

#include <regista/testkit/loaded.hpp>

namespace regista::testkit {

struct Corner {
  std::string name;  // what differs from the defaults: "defaults" where nothing does
  Values values;
  bool is_default = false;
};

// `base`: values that the plugin needs in every case, e.g. the content of a file.
std::vector<Corner> corners(const Loaded& plugin, const Values& base);

}  // namespace regista::testkit
