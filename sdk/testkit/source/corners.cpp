// SPDX-License-Identifier: MIT
// Few numbers: a mask over them is a corner. Many: one at a time.
#include <regista/testkit/corners.hpp>

#include <cstdint>

namespace regista::testkit {

std::vector<Corner> corners(const Loaded& plugin, const Values& base) {
  std::vector<std::size_t> numeric, words;
  for (std::size_t i = 0; i < plugin.parameter_count(); ++i) {
    const std::int32_t type = plugin.parameter(i).type;
    if (type == REGISTA_TYPE_REAL || type == REGISTA_TYPE_INTEGER) numeric.push_back(i);
    if (type == REGISTA_TYPE_BOOLEAN || type == REGISTA_TYPE_CHOICE) words.push_back(i);
  }
  std::vector<Corner> out{{"defaults", base, true}};
  const auto end = [&](Values& values, std::size_t i, bool high) {
    const regista_parameter& p = plugin.parameter(i);
    values.set(p.name, high ? p.maximum : p.minimum);
  };
  const auto all = [&](bool high) {
    Values values = base;
    for (const std::size_t i : numeric) end(values, i, high);
    return values;
  };
  if (!numeric.empty()) {
    out.push_back({"all low", all(false)});
    out.push_back({"all high", all(true)});
  }
  if (numeric.size() > 6) {
    for (const std::size_t i : numeric) {
      for (const bool high : {false, true}) {
        Values values = base;
        end(values, i, high);
        out.push_back({std::string(plugin.parameter(i).name) + (high ? " high" : " low"), values});
      }
    }
  } else {
    for (unsigned mask = 1; mask + 1 < 1u << numeric.size(); ++mask) {
      Values values = base;
      std::string name = "high:";
      for (std::size_t k = 0; k < numeric.size(); ++k) {
        end(values, numeric[k], (mask >> k & 1u) != 0);
        if (mask >> k & 1u) name += std::string(" ") + plugin.parameter(numeric[k]).name;
      }
      out.push_back({name, values});
    }
  }
  for (const std::size_t i : words) {
    const regista_parameter& p = plugin.parameter(i);
    const unsigned count = p.type == REGISTA_TYPE_BOOLEAN ? 2 : p.choice_count;
    for (unsigned value = 0; value < count; ++value) {
      const std::string word = p.type == REGISTA_TYPE_CHOICE ? p.choices[value] : value == 1 ? "true" : "false";
      const std::string name = std::string(p.name) + " = " + word;
      if (value != base.number(i)) out.push_back({name, Values(base).set(p.name, value)});
      if (numeric.empty()) continue;
      out.push_back({name + ", others low", all(false).set(p.name, value)});
      out.push_back({name + ", others high", all(true).set(p.name, value)});
    }
  }
  return out;
}

}  // namespace regista::testkit
