// SPDX-License-Identifier: MIT
// Values that a user gives for the parameters of a plugin that is checked: "--set NAME=VALUE".
#pragma once

#include <map>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <regista/testkit/loaded.hpp>

#include "plugin/survey.hpp"

namespace regista::check {

using GivenTexts = std::vector<std::pair<std::string, std::string>>;

// By plugin. Of a file the value is its content, and the text names its path.
class GivenValues {
 public:
  GivenValues() = default;
  // For the plugins with these ids; none named: for all. Throws config::BadInput for a value that a parameter cannot
  // have. A name that none of them has gives no value.
  GivenValues(const GivenTexts& texts, const plugin::Surveyed& surveyed, const std::vector<std::string>& plugins);

  // Names of the parameters that these plugins have, each once.
  const std::vector<std::string>& known() const { return known_; }

  // Over what is there. `id`: whose values these are.
  void give(const std::string& id, testkit::Values& values) const;

 private:
  using Value = std::variant<double, std::string>;
  std::vector<std::string> known_;
  std::map<std::string, std::vector<std::pair<std::string, Value>>> of_;  // name and value, by plugin
};

}  // namespace regista::check
