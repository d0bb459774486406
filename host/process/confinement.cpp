// SPDX-License-Identifier: MIT
#include "process/confinement.hpp"

#include <dlfcn.h>
#include <fcntl.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/time.h>
#include <ucontext.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <ctime>
#include <vector>

#include "process/sanitized.hpp"

namespace regista::process {
namespace {

#if defined(__x86_64__)
constexpr std::uint32_t architecture = AUDIT_ARCH_X86_64;
#elif defined(__aarch64__)
constexpr std::uint32_t architecture = AUDIT_ARCH_AARCH64;
#else
constexpr std::uint32_t architecture = 0;  // unknown architecture: nothing is confined
#endif

constexpr std::array refusals{"open a file for writing", "change a name in the file system", "open a socket",
                              "ask for an object that processes share"};
enum Refusal : std::uint32_t { writing, names, sockets, objects };

struct Refused {
  std::uint32_t call;
  Refusal refusal;
};

constexpr Refused always_refused[] = {
#ifdef SYS_creat  // newer architectures have only the variants with "at", such as mkdirat
    {SYS_creat, writing},      {SYS_mkdir, names},     {SYS_mknod, names},    {SYS_link, names},
    {SYS_symlink, names},      {SYS_rename, names},    {SYS_unlink, names},   {SYS_rmdir, names},
#endif
#ifdef SYS_renameat
    {SYS_renameat, names},
#endif
    {SYS_openat2, writing},  // its flags are in memory, which the filter cannot read
    {SYS_truncate, writing},   {SYS_mkdirat, names},   {SYS_mknodat, names},  {SYS_linkat, names},
    {SYS_symlinkat, names},    {SYS_renameat2, names}, {SYS_unlinkat, names}, {SYS_socket, sockets},
    {SYS_socketpair, sockets}, {SYS_shmget, objects},  {SYS_semget, objects}, {SYS_msgget, objects},
    {SYS_mq_open, objects},
};

// This variable is global, because a signal handler gets no arguments from the host.
std::atomic<void (*)(const char*)> report{nullptr};

void refuse(int, siginfo_t* about, void* context) {
  const auto refusal = static_cast<std::size_t>(about->si_errno);  // SECCOMP_RET_DATA of the filter
  if (auto* const tried = report.load(); tried != nullptr && refusal < refusals.size()) tried(refusals[refusal]);
#if defined(__x86_64__)
  static_cast<ucontext_t*>(context)->uc_mcontext.gregs[REG_RAX] = -EACCES;
#elif defined(__aarch64__)
  static_cast<ucontext_t*>(context)->uc_mcontext.regs[0] = static_cast<unsigned long long>(-EACCES);
#else
  (void)context;
#endif
}

constexpr std::uint32_t low_word_of_argument(std::size_t index) {
  static_assert(__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__);
  return static_cast<std::uint32_t>(offsetof(seccomp_data, args) + index * sizeof(std::uint64_t));
}

class Filter {
 public:
  Filter() {
    load(offsetof(seccomp_data, arch));
    jump_over(BPF_JEQ, architecture, 1, 0);
    answer(SECCOMP_RET_ALLOW);  // calls of another architecture are allowed; no plugin makes them by accident
    load(offsetof(seccomp_data, nr));
    for (const Refused& each : always_refused) {
      jump_over(BPF_JEQ, each.call, 0, 1);
      answer(SECCOMP_RET_TRAP | each.refusal);
    }
#ifdef SYS_open
    refuse_writing(SYS_open, 1);
#endif
    refuse_writing(SYS_openat, 2);
    answer(SECCOMP_RET_ALLOW);
  }
  sock_fprog program() { return {static_cast<unsigned short>(code_.size()), code_.data()}; }

 private:
  void load(std::size_t at) { code_.push_back(BPF_STMT(BPF_LD | BPF_W | BPF_ABS, static_cast<std::uint32_t>(at))); }
  void answer(std::uint32_t with) { code_.push_back(BPF_STMT(BPF_RET | BPF_K, with)); }
  // Compares the loaded value with `with`. Skips `if_so` instructions if the comparison is true, otherwise `if_not`.
  void jump_over(int comparison, std::uint32_t with, std::uint8_t if_so, std::uint8_t if_not) {
    code_.push_back(BPF_JUMP(static_cast<std::uint16_t>(BPF_JMP | BPF_K | comparison), with, if_so, if_not));
  }
  void refuse_writing(std::uint32_t call, std::size_t flags) {
    jump_over(BPF_JEQ, call, 0, 4);
    load(low_word_of_argument(flags));
    jump_over(BPF_JSET, O_ACCMODE | O_CREAT | O_TRUNC, 0, 1);
    answer(SECCOMP_RET_TRAP | writing);
    answer(SECCOMP_RET_ALLOW);
  }
  std::vector<sock_filter> code_;
};

// This variable is global, because functions of the C library get no arguments from the host.
std::atomic<std::int64_t> earlier{0};  // s

}  // namespace

bool confine(void (*tried)(const char* what)) {
  if (architecture == 0) return false;
  struct sigaction action {};
  action.sa_sigaction = refuse;
  action.sa_flags = SA_SIGINFO | SA_ONSTACK | SA_RESTART;
  sigemptyset(&action.sa_mask);
  Filter filter;
  sock_fprog program = filter.program();
  if (::prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0) return false;
  report.store(tried);
  if (::sigaction(SIGSYS, &action, nullptr) != 0) return false;
  // Tries SPEC_ALLOW first: without it, some kernels slow the process down as a protection against attackers.
  for (const unsigned long flags : {SECCOMP_FILTER_FLAG_SPEC_ALLOW, 0ul}) {
    if (::syscall(SYS_seccomp, SECCOMP_SET_MODE_FILTER, flags, &program) == 0) return true;
  }
  return false;
}

void set_date_back(std::int64_t seconds) { earlier = seconds; }

}  // namespace regista::process

#ifndef REGISTA_SANITIZED
extern "C" {

int clock_gettime(clockid_t clock, timespec* now) noexcept {
  static auto* const of_the_library = reinterpret_cast<decltype(&clock_gettime)>(::dlsym(RTLD_NEXT, "clock_gettime"));
  const int status = of_the_library(clock, now);
  if (status == 0 && (clock == CLOCK_REALTIME || clock == CLOCK_REALTIME_COARSE || clock == CLOCK_TAI))
    now->tv_sec -= regista::process::earlier;
  return status;
}

int gettimeofday(timeval* now, void*) noexcept {
  timespec exact{};
  const int status = clock_gettime(CLOCK_REALTIME, &exact);
  *now = {exact.tv_sec, exact.tv_nsec / 1000};
  return status;
}

time_t time(time_t* out) noexcept {
  timespec now{};
  clock_gettime(CLOCK_REALTIME_COARSE, &now);
  if (out != nullptr) *out = now.tv_sec;
  return now.tv_sec;
}

int timespec_get(timespec* now, int base) noexcept {
  return base == TIME_UTC && clock_gettime(CLOCK_REALTIME, now) == 0 ? base : 0;
}
}
#endif
