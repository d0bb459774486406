// SPDX-License-Identifier: MIT
// What a contract suite has to know about a plugin that its descriptor does not say.
#pragma once

#include <cstdint>
#include <functional>

#include <regista/testkit/findings.hpp>
#include <regista/testkit/loaded.hpp>

namespace regista::testkit {

struct Options {
  // Values that the plugin needs in every case, such as the content of a file it cannot work without.
  std::function<void(Values&)> base = [](Values&) {};
  // A utility: whether its terms must not depend on the order in which opponents are listed.
  bool order_of_opponents_is_irrelevant = false;
  // An assigner: may leave a robot idle although a task is open to it (a greatest distance, an auction by groups).
  bool may_idle = false;
  // Of one that must not: it is a doubt and no finding.
  bool doubts_idleness = false;
  // Of whatever the checks draw by chance. A finding is found again with the same seed.
  std::uint64_t seed = 0;
  // Is told what is about to be played.
  Findings::Underway underway{};
};

}  // namespace regista::testkit
