// SPDX-License-Identifier: MIT
// What a user asked for cannot be done, and no place in a document is to blame (for these: config::Error). what() is
// the one line that says why.
#pragma once

#include <stdexcept>

namespace regista::config {

class BadInput : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace regista::config
