// SPDX-License-Identifier: MIT
// For plugins that are wrong on purpose: what they have in common, and tables of calls whose functions stand bare, with
// nothing that catches.
#pragma once

#include <regista/assigner.hpp>
#include <regista/behaviour.hpp>
#include <regista/context.hpp>
#include <regista/positioner.hpp>
#include <regista/predictor.hpp>
#include <regista/sender.hpp>
#include <regista/utility.hpp>

namespace bad {

struct Described {
  static constexpr auto version = "1.0.0", summary = "Wrong on purpose";
};

// Kinds whose class has one static function with the signature of the ABI.
template <std::int32_t Kind, class Table>
struct Bare {
  static constexpr std::int32_t kind = Kind;
  template <class Class>
  static const void* table() {
    static constexpr Table calls{sizeof(Table), 0, &Class::call};
    return &calls;
  }
};
using bare_context = Bare<REGISTA_KIND_CONTEXT, regista_context>;
using bare_positioner = Bare<REGISTA_KIND_POSITIONER, regista_positioner>;
using bare_utility = Bare<REGISTA_KIND_UTILITY, regista_utility>;
using bare_assigner = Bare<REGISTA_KIND_ASSIGNER, regista_assigner>;
using bare_behaviour = Bare<REGISTA_KIND_BEHAVIOUR, regista_behaviour>;

struct bare_sender {
  static constexpr std::int32_t kind = REGISTA_KIND_SENDER;
  template <class Class>
  static const void* table() {
    static constexpr regista_sender calls{sizeof(regista_sender), 0, &Class::call, nullptr};
    return &calls;
  }
};

}  // namespace bad
