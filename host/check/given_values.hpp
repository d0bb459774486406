// SPDX-License-Identifier: MIT
// Values that a user gives to parameters of the checked plugin: "--set NAME=VALUE".
#pragma once

#include <map>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <regista/testkit/loaded.hpp>

#include "plugin/shared_object.hpp"

namespace regista::check {

using GivenTexts = std::vector<std::pair<std::string, std::string>>;

// The given values of parameters, by plugin. For a file, the text is its path and the value its content.
class GivenValues {
 public:
  GivenValues() = default;
  // Reads the values for the plugins with these ids; no ids: for all plugins. Throws config::BadInput for a value that
  // a parameter cannot have. Ignores a name that no plugin declares.
  GivenValues(const GivenTexts& texts, const plugin::ScannedFile& surveyed, const std::vector<std::string>& plugins);

  // Returns the names of all parameters that these plugins declare, each name once.
  const std::vector<std::string>& known() const { return known_; }

  // Writes the given values for the plugin `id` into `values`; they replace earlier values of the same parameters.
  void give(const std::string& id, testkit::Values& values) const;

 private:
  using Value = std::variant<double, std::string>;
  std::vector<std::string> known_;
  std::map<std::string, std::vector<std::pair<std::string, Value>>> of_;  // names and values, by plugin
};

}  // namespace regista::check
