// SPDX-License-Identifier: MIT
// What plugins answered as bytes: see config/bytes.hpp.
#pragma once

#include "config/bytes.hpp"
#include "plugin/call_trail.hpp"

namespace regista::plugin {

template <class Archive>
void visit(Archive& archive, CallAnswer& answer) {
  for (char& each : answer.plugin) archive(each);
  for (char& each : answer.call) archive(each);
  archive(answer.digest);
}

}  // namespace regista::plugin
