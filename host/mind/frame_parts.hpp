// SPDX-License-Identifier: MIT
// Which parts of the frame a mind makes: what no plugin of the team declares to read (REGISTA_READS_*) would be work
// for nobody. A plugin that reads more than it declares is found out where inputs are compared
// (plugin/declared_reads.hpp).
#pragma once

#include <cstdint>

#include "mind/team_plan.hpp"

namespace regista::mind {

class FrameParts {
 public:
  // REGISTA_READS_*, of all plugins and of positioners alone.
  FrameParts(std::uint32_t read, std::uint32_t read_by_positioners)
      : read_(read), read_by_positioners_(read_by_positioners) {}
  explicit FrameParts(const TeamPlan& plan) : FrameParts(plan.reads(), plan.positioners_read()) {}
  // For whoever looks at decisions from outside.
  static FrameParts all() { return {REGISTA_READS_ALL, REGISTA_READS_ALL}; }

  bool common_opponents() const { return (read_ & REGISTA_READS_OPPONENTS_COMMON) != 0; }
  bool times() const { return (read_ & REGISTA_READS_TIMES) != 0; }
  // Of the kept tasks; of all that the context has, which only a positioner sees.
  bool facings() const { return (read_ & REGISTA_READS_FACINGS) != 0; }
  bool facings_of_all_tasks() const { return (read_by_positioners_ & REGISTA_READS_FACINGS) != 0; }

 private:
  std::uint32_t read_, read_by_positioners_;
};

}  // namespace regista::mind
