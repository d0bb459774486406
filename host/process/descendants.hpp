// SPDX-License-Identifier: MIT
// Processes that plugins have started. Whose parent is gone becomes a child of this process, and is found by that. This
// process may have been given children that are none of its business, by a shell that became it (`exec`): those that
// were there before, and all in a process group that was there before, are left alone.
#pragma once

#include <sys/types.h>

#include <span>
#include <vector>

namespace regista::process {

class Descendants {
 public:
  // To be made before this process starts any. Each that it starts must have a process group of its own.
  Descendants();

  // Kills all children of this process but those and strangers.
  void end_all_but(std::span<const pid_t> those) const;
  void end_all() const { end_all_but({}); }

 private:
  std::vector<pid_t> strangers_, groups_;
};

}  // namespace regista::process
