// SPDX-License-Identifier: MIT
#include "campaign/worker_process.hpp"

#include <unistd.h>

#include <cstring>

namespace regista::campaign {

process::Limits memory_limits(const Limits& limits) { return {.memory = limits.memory, .small_stack = true}; }

process::Setting worker_setting(const WorkerFiles& files, const Limits& limits) {
  process::Setting out;
  out.files = {{files.job, STDIN_FILENO},
               {files.output, STDERR_FILENO},
               {files.answer, answer_descriptor},
               {files.note, note_descriptor},
               {files.trail, trail_descriptor}};
  out.limits = memory_limits(limits);
  out.limits.processor_seconds = limits.match_seconds();
  return out;
}

std::vector<char*> environment_with(std::initializer_list<const char*> more, Pages pages) {
  static char large_pages[] = "GLIBC_TUNABLES=glibc.malloc.hugetlb=1";
  constexpr std::size_t name = std::string_view("GLIBC_TUNABLES=").size();
  std::vector<char*> variables;
  bool tuned = false;  // by the user
  for (char** each = environ; *each != nullptr; ++each) {
    variables.push_back(*each);
    tuned = tuned || std::strncmp(*each, large_pages, name) == 0;
  }
  if (!tuned && pages == Pages::large) variables.push_back(large_pages);
  for (const char* each : more) variables.push_back(const_cast<char*>(each));
  variables.push_back(nullptr);
  return variables;
}

}  // namespace regista::campaign
