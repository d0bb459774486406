// SPDX-License-Identifier: MIT
#include "plugin/context.hpp"

#include <fmt/format.h>

namespace regista::plugin {

Context::Context(std::shared_ptr<Instance> instance)
    : instance_(std::move(instance)), calls_(&instance_->table<regista_context>(REGISTA_KIND_CONTEXT)) {}

bool Context::holds(const regista_frame& frame) {
  GuardedValue<std::int32_t>& answer = instance_->rooms().holds;
  *instance_->open(answer) = 0;
  instance_->call_with([](Inputs& inputs, const regista_frame* seen, auto*) { inputs.add("frame", seen); }, "holds",
                       calls_->holds, instance_->shown(&frame), answer.data());
  instance_->check("holds", Instance::Written{answer, "whether it holds"});
  const std::int32_t out = *answer.data();
  if (out != 0 && out != 1) [[unlikely]]
    instance_->fail("holds", fmt::format("{} is neither 0 nor 1", out));
  instance_->answered(out);
  return out == 1;
}

}  // namespace regista::plugin
