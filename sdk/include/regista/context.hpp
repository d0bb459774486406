// SPDX-License-Identifier: MIT
// A context says whether its situation holds now. The first that holds, by the priorities of the team's YAML, is in
// force (CTX of the paper); what it changes stands in YAML too. The class has
//
//   bool holds(const regista::Frame&);       called once per decision, whether or not another one is in force
#pragma once

#include <regista/plugin.hpp>

namespace regista {

#pragma GCC visibility push(hidden)  // see plugin.hpp
struct context {
  static constexpr std::int32_t kind = REGISTA_KIND_CONTEXT;

  template <class Class>
  static const void* table() {
    static constexpr regista_context calls{
        sizeof(regista_context), 0,
        [](void* instance, const regista_frame* frame, std::int32_t* out, regista_error* error) {
          return detail::guarded(error, [&] { *out = static_cast<Class*>(instance)->holds(Frame(*frame)) ? 1 : 0; });
        }};
    return &calls;
  }
};
#pragma GCC visibility pop

}  // namespace regista
