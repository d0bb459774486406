// SPDX-License-Identifier: MIT
// The host as an instance sees it: given to `setup`, cheap to copy, valid as long as the instance, and only from within
// its calls.
//
//   void setup(const regista::Environment&, const regista::Host& host) { log_ = regista::Log(host); }
#pragma once

#include <regista/abi.h>
#include <regista/mailbox.hpp>

namespace regista {

class Host {
 public:
  explicit Host(const regista_host* raw) : raw_(raw) {}

  Mailbox mailbox() const { return Mailbox(raw_); }

  // The host's side of an extension, or null when it has none of that name. `Table` is what the extension's header
  // says.
  template <class Table>
  const Table* extension(const char* id) const {
    return raw_->extension == nullptr ? nullptr : static_cast<const Table*>(raw_->extension(raw_->context, id));
  }

 private:
  const regista_host* raw_;
};

}  // namespace regista
