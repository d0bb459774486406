// SPDX-License-Identifier: MIT
#include "check/process_watch.hpp"

#include <string>
#include <utility>

#include "plugin/floating_point_state.hpp"
#include "plugin/process_state.hpp"

namespace regista::check {

Outcome leaving_the_process_alone(const std::function<Outcome()>& check) {
  const auto numbers = plugin::FloatingPointState::now();
  plugin::keep_orphans();
  const auto before = plugin::ProcessState::now();
  Outcome out = check();
  const auto add = [&out](std::string line) {
    out.status = Status::fail;
    out.lines.push_back(std::move(line));
  };
  if (const std::string changed = plugin::FloatingPointState::now().changed_from(numbers); !changed.empty())
    add(changed);
  if (const std::string changed = plugin::changes_since(before); !changed.empty()) add(changed);
  return out;
}

}  // namespace regista::check
