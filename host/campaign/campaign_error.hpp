// SPDX-License-Identifier: MIT
// Matches cannot be played on.
#pragma once

#include <stdexcept>
#include <string>

namespace regista::campaign {

// what() is one line that says why.
class CampaignError : public std::runtime_error {
 public:
  enum class Kind {
    input,    // a file changed while the campaign ran, or cannot be used any more
    machine,  // workers are killed again and again, or die though they run no plugin
  };
  CampaignError(Kind kind, const std::string& message) : std::runtime_error(message), kind_(kind) {}
  Kind kind() const { return kind_; }

 private:
  Kind kind_;
};

}  // namespace regista::campaign
