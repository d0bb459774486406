// SPDX-License-Identifier: MIT
// Passes that are meant: see <regista/extensions/pass.h>.
//
//   void setup(const regista::Environment&, const regista::Host& host) { pass_ = regista::Pass(host); }
//   void act(...) { ... out.kick = ...; pass_.meant_for(receiver); }
#pragma once

#include <cstdint>

#include <regista/extensions/pass.h>
#include <regista/host.hpp>

namespace regista {

// Without a host that counts passes nothing happens.
class Pass {
 public:
  Pass() = default;
  explicit Pass(const Host& host) : table_(host.extension<regista_pass>(REGISTA_PASS_EXTENSION)) {}

  // receiver: a shirt number, not the own one.
  void meant_for(std::int32_t receiver) const {
    if (table_ != nullptr) table_->meant_for(table_->context, receiver);
  }

 private:
  const regista_pass* table_ = nullptr;
};

}  // namespace regista
