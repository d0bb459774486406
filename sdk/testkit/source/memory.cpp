// SPDX-License-Identifier: MIT
// Pages, and who says what happened to them.
#include <regista/testkit/memory.hpp>

#include <signal.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <string_view>
#include <system_error>

namespace regista::testkit {

// While there are pages, it stands before whoever handles faults. A handler of signals has nothing but what is global.
class FaultReport {
 public:
  static void watch(const Memory::Pages& pages) {
    if (watched().empty()) {
      struct sigaction action {};
      action.sa_sigaction = [](int signal, siginfo_t* info, void*) { tell(signal, info->si_addr); };
      action.sa_flags = SA_SIGINFO;
      ::sigemptyset(&action.sa_mask);
      ::sigaction(SIGSEGV, &action, &previous());
    }
    watched().push_back(&pages);
  }
  static void forget(const Memory::Pages& pages) {
    std::erase(watched(), &pages);
    if (watched().empty()) ::sigaction(SIGSEGV, &previous(), nullptr);
  }

 private:
  static std::vector<const Memory::Pages*>& watched() {
    static std::vector<const Memory::Pages*> list;
    return list;
  }
  static struct sigaction& previous() {
    static struct sigaction action {};
    return action;
  }
  // Returns to the same instruction, where whoever was before is called.
  static void tell(int signal, const void* address) {
    for (const Memory::Pages* const each : watched()) {
      const auto* const at = static_cast<const unsigned char*>(address);
      if (at < each->begin || at >= each->begin + each->length + static_cast<std::size_t>(::sysconf(_SC_PAGESIZE))) {
        continue;
      }
      std::string_view what = "memory: it went behind the end of what it was given\n";
      if (at < each->begin + each->length) {
        what = each->access == Memory::Access::none ? "memory: it used what had ended with an earlier call\n"
                                                    : "memory: it wrote to what it may only read\n";
      }
      [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, what.data(), what.size());
      break;
    }
    ::sigaction(signal, &previous(), nullptr);
  }
};

Memory::Pages::Pages(std::size_t words_in_it) {
  const auto page = static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
  length = std::max<std::size_t>(1, (8 * words_in_it + page - 1) / page) * page;
  void* const mapped = ::mmap(nullptr, length + page, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (mapped == MAP_FAILED) throw std::system_error(errno, std::generic_category(), "mmap");
  begin = static_cast<unsigned char*>(mapped);
  std::memset(begin, 0xff, length);
  ::mprotect(begin + length, page, PROT_NONE);
  words = reinterpret_cast<std::uint64_t*>(begin + length) - words_in_it;
  FaultReport::watch(*this);
}

Memory::Pages::~Pages() {
  FaultReport::forget(*this);
  ::munmap(begin, length + static_cast<std::size_t>(::sysconf(_SC_PAGESIZE)));
}

void Memory::Pages::allow(Access allowed) {
  access = allowed;
  const int protection = allowed == Access::write  ? PROT_READ | PROT_WRITE
                         : allowed == Access::read ? PROT_READ
                                                   : PROT_NONE;
  ::mprotect(begin, length, protection);
}

Memory::Memory(std::size_t bytes, const Layout& layout) : count_((bytes + 7) / 8) {
  if (layout.guarded) {
    pages_ = std::make_unique<Pages>(count_);
  } else {
    heap_.assign(count_, ~std::uint64_t{0});
  }
}

void Memory::fill_with_ones() {
  if (pages_) pages_->allow(Access::write);
  std::fill_n(data(), count_, ~std::uint64_t{0});
}

void Memory::make_read_only() {
  if (pages_) pages_->allow(Access::read);
}

void Memory::take_away() {
  if (pages_) pages_->allow(Access::none);
}

}  // namespace regista::testkit
