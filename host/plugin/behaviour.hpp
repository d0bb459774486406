// SPDX-License-Identifier: MIT
// The call of a behaviour, and the check of the action it hands back.
#pragma once

#include <cstdint>
#include <memory>

#include "plugin/instance.hpp"

namespace regista::plugin {

class Behaviour {
 public:
  // Throws Failure when the plugin is no behaviour.
  explicit Behaviour(std::shared_ptr<Instance> instance);

  // What to do until the next decision; valid until the next call. Checked: numbers that are used are finite and within
  // their ranges, enumerators exist, a kick is one that the robot can do.
  const regista_action& act(const regista_frame& frame, const regista_body& body);

 private:
  void note_answer(const regista_action& action) const;
  void check(const regista_action& action) const;
  void check_kick(const regista_action& action) const;

  std::shared_ptr<Instance> instance_;
  const regista_behaviour* calls_;
};

}  // namespace regista::plugin
