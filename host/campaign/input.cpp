// SPDX-License-Identifier: MIT
#include "campaign/input.hpp"

#include <algorithm>

namespace regista::campaign {

std::vector<std::string> differences(std::span<const Input> before, std::span<const Input> now) {
  std::vector<std::string> out;
  const auto add = [&](const std::string& text) {
    if (std::ranges::find(out, text) == out.end()) out.push_back(text);
  };
  // The same content under another name, such as a path that is spelled otherwise, is the same.
  const auto elsewhere = [](std::span<const Input> inputs, const Input& wanted) {
    return std::ranges::find(inputs, wanted.hash, &Input::hash) != inputs.end();
  };
  for (const Input& old : before) {
    if (elsewhere(now, old)) continue;
    const auto found = std::ranges::find(now, old.name, &Input::name);
    if (found == now.end())
      add(old.name + " is no longer used");
    else if (found->hash != old.hash)
      add(old.name + " has changed");
  }
  for (const Input& input : now) {
    if (elsewhere(before, input)) continue;
    if (std::ranges::find(before, input.name, &Input::name) == before.end()) add(input.name + " is new");
  }
  return out;
}

}  // namespace regista::campaign
