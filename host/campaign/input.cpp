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
  // "plugin greedy (lib/greedy.so)" and "plugin greedy (/home/me/lib/greedy.so)" are about the same thing.
  const auto named_as = [](std::span<const Input> inputs, const std::string& name) {
    const auto subject = [](const std::string& of) { return of.substr(0, of.find(" (")); };
    const auto found = std::ranges::find(inputs, name, &Input::name);
    if (found != inputs.end()) return found;
    return std::ranges::find_if(inputs, [&](const Input& each) { return subject(each.name) == subject(name); });
  };
  for (const Input& old : before) {
    if (elsewhere(now, old)) continue;
    const auto found = named_as(now, old.name);
    if (found == now.end())
      add(old.name + " is no longer used");
    else if (found->hash != old.hash)
      add(old.name + " has changed");
  }
  for (const Input& input : now) {
    if (elsewhere(before, input)) continue;
    if (named_as(before, input.name) == before.end()) add(input.name + " is new");
  }
  return out;
}

}  // namespace regista::campaign
