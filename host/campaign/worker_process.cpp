// SPDX-License-Identifier: MIT
#include "campaign/worker_process.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>
#include <cstring>

#include "config/sanitized.hpp"

namespace regista::campaign {
namespace {

constexpr rlim_t stack = rlim_t{8} << 20;  // bytes: an endless recursion ends here, whatever the user's own limit is

bool limit(__rlimit_resource resource, rlim_t soft, rlim_t hard) {
  rlimit now{};
  if (getrlimit(resource, &now) == -1) return false;
  const rlimit wanted{std::min(soft, now.rlim_max), std::min(hard, now.rlim_max)};
  return setrlimit(resource, &wanted) == 0;
}

}  // namespace

bool limit_memory(const Limits& limits) {
  if (!limit(RLIMIT_CORE, 0, 0) || !limit(RLIMIT_STACK, stack, stack)) return false;
  // A sanitizer reserves more addresses than there is memory.
  return limits.memory == 0 || addresses_are_reserved() || limit(RLIMIT_AS, limits.memory, limits.memory);
}

char** environment_with(std::initializer_list<const char*> more, Pages pages) {
  static char large_pages[] = "GLIBC_TUNABLES=glibc.malloc.hugetlb=1";
  constexpr std::size_t name = std::string_view("GLIBC_TUNABLES=").size();
  static std::array<char*, 1024> variables;
  std::size_t count = 0;
  bool tuned = false;  // by the user
  for (char** each = environ; *each != nullptr && count < variables.size() - 8; ++each) {
    variables[count++] = *each;
    tuned = tuned || std::strncmp(*each, large_pages, name) == 0;
  }
  if (!tuned && pages == Pages::large) variables[count++] = large_pages;
  for (const char* each : more) variables[count++] = const_cast<char*>(each);
  variables[count] = nullptr;
  return variables.data();
}

bool become_worker(const WorkerFiles& given, const Limits& limits, pid_t coordinator) {
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != coordinator) return false;  // it died before it could be watched
  // Out of the way of the numbers they are to have, which are not closed at exec.
  const int opened = open("/dev/null", O_RDWR);
  const int nothing = fcntl(opened, F_DUPFD, 10), answer = fcntl(given.answer, F_DUPFD, 10),
            note = fcntl(given.note, F_DUPFD, 10), output = fcntl(given.output, F_DUPFD, 10),
            trail = fcntl(given.trail == -1 ? opened : given.trail, F_DUPFD, 10);
  if (answer == -1 || note == -1 || output == -1 || trail == -1 || nothing == -1) return false;
  close(opened);
  const bool placed = dup2(nothing, STDIN_FILENO) != -1 && dup2(nothing, STDOUT_FILENO) != -1 &&
                      dup2(output, STDERR_FILENO) != -1 && dup2(answer, answer_descriptor) != -1 &&
                      dup2(note, note_descriptor) != -1 && dup2(trail, trail_descriptor) != -1;
  if (!placed) return false;
  for (const int each : {answer, note, output, trail, nothing}) close(each);
  const auto seconds = static_cast<rlim_t>(limits.match_seconds());
  if (!limit(RLIMIT_CPU, seconds, seconds + 2) || !limit_memory(limits)) return false;
  for (const int each : {SIGINT, SIGTERM, SIGHUP, SIGALRM, SIGPIPE, SIGXFSZ, SIGXCPU}) std::signal(each, SIG_DFL);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr);
  return true;
}

}  // namespace regista::campaign
