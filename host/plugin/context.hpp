// SPDX-License-Identifier: MIT
// The call of a context.
#pragma once

#include <memory>

#include "plugin/instance.hpp"

namespace regista::plugin {

class Context {
 public:
  // Throws Failure when the plugin is no context.
  explicit Context(std::shared_ptr<Instance> instance);

  // Whether the condition holds now. To be called once per decision for every context.
  bool holds(const regista_frame& frame);

 private:
  std::shared_ptr<Instance> instance_;
  const regista_context* calls_;
};

}  // namespace regista::plugin
