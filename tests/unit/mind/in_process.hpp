// SPDX-License-Identifier: MIT
// Plugins that live in the test itself: instances of ordinary classes without a shared object, so that a test can watch
// what they are given and say what they answer.
#pragma once

#include <memory>

#include "plugin/instance.hpp"
#include "plugin/parameters.hpp"
#include "regista/plugin.hpp"

namespace regista::mind {

// An instance with default parameters, reset.
template <class Class, class... Kinds>
std::shared_ptr<plugin::Instance> in_process(const regista_environment& environment,
                                             const regista_host* host = nullptr) {
  static const plugin::Found found{"in_process", Plugin<Class, Kinds...>::descriptor()};
  auto instance =
      std::make_shared<plugin::Instance>(found, plugin::resolve(*found.descriptor, {}), environment, host, nullptr);
  instance->reset(1);
  return instance;
}

}  // namespace regista::mind
