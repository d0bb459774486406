// SPDX-License-Identifier: MIT
// Each try in a child of its own: what is confined stays so.
#include "process/confinement.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <mqueue.h>
#include <sys/mman.h>
#include <sys/sem.h>
#include <sys/shm.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <functional>
#include <string>

#include "process/child.hpp"
#include "process/file_descriptor.hpp"

namespace regista::process {
namespace {

struct Seen {
  int tries, error;
  std::array<char, 64> what;
  bool done;
};
Seen* seen = nullptr;  // the handler takes no arguments of ours

void note(const char* what) {
  if (seen->tries++ == 0) std::strncpy(seen->what.data(), what, seen->what.size() - 1);
}

// What a confined child saw when it did this; `work` gives whether that succeeded.
Seen confined(const std::function<bool()>& work) {
  SharedMemory<Seen> shared;
  Child child = Child::copy({}, [&] {
    seen = &*shared;
    if (!confine(note)) return 3;
    errno = 0;
    shared->done = work();
    shared->error = errno;
    return 0;
  });
  const ProcessEnd end = child.wait();
  EXPECT_TRUE(end.exited_with(0)) << end.in_words();
  return *shared;
}

class Confinement : public testing::Test {
 protected:
  void SetUp() override { ASSERT_EQ(::mkdtemp(folder.data()), folder.data()); }
  void TearDown() override {
    ::unlink(file().c_str());
    ::rmdir(folder.c_str());
  }
  std::string file() const { return folder + "/file"; }
  std::string folder = "/tmp/regista-confinement-XXXXXX";
};

TEST_F(Confinement, ReadingAndComputingGoOn) {
  std::ofstream(file()) << "42 weights";
  const Seen saw = confined([this] {
    int weights = 0;
    std::ifstream(file()) >> weights;
    void* const own = ::mmap(nullptr, 4096, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    std::array<int, 2> ends{};
    Child copy = Child::copy({.keeps_streams = true}, [] { return 7; });
    return copy.wait().exited_with(7) && weights == 42 && own != MAP_FAILED && ::pipe(ends.data()) == 0;
  });
  EXPECT_TRUE(saw.done);
  EXPECT_EQ(saw.tries, 0) << saw.what.data();
}

TEST_F(Confinement, WaysToOthersFailAndAreReported) {
  const std::string name = file();
  const char* const path = name.c_str();
  struct Way {
    const char* name;
    std::function<bool()> goes;
    std::string what;
  };
  const Way ways[] = {
      {"open", [&] { return ::open(path, O_WRONLY | O_CREAT, 0600) != -1; }, "open a file for writing"},
      {"open for both", [&] { return ::open("/dev/null", O_RDWR) != -1; }, "open a file for writing"},
      {"truncating", [&] { return ::open("/dev/null", O_RDONLY | O_TRUNC) != -1; }, "open a file for writing"},
      {"creat", [&] { return ::creat(path, 0600) != -1; }, "open a file for writing"},
      {"fopen", [&] { return std::fopen(path, "a") != nullptr; }, "open a file for writing"},
      {"ofstream", [&] { return std::ofstream(path).is_open(); }, "open a file for writing"},
      {"shm_open", [] { return ::shm_open("/regista-confinement", O_RDWR | O_CREAT, 0600) != -1; },
       "open a file for writing"},
      {"mkdir", [&] { return ::mkdir(path, 0700) == 0; }, "change a name in the file system"},
      {"mkfifo", [&] { return ::mkfifo(path, 0700) == 0; }, "change a name in the file system"},
      {"rename", [&] { return ::rename(path, path) == 0; }, "change a name in the file system"},
      {"unlink", [&] { return ::unlink(path) == 0; }, "change a name in the file system"},
      {"symlink", [&] { return ::symlink("nowhere", path) == 0; }, "change a name in the file system"},
      {"socket", [] { return ::socket(AF_INET, SOCK_DGRAM, 0) != -1; }, "open a socket"},
      {"socketpair",
       [] {
         std::array<int, 2> ends{};
         return ::socketpair(AF_UNIX, SOCK_DGRAM, 0, ends.data()) == 0;
       },
       "open a socket"},
      {"shmget", [] { return ::shmget(IPC_PRIVATE, 4096, 0600) != -1; }, "ask for an object that processes share"},
      {"semget", [] { return ::semget(IPC_PRIVATE, 1, 0600) != -1; }, "ask for an object that processes share"},
  };
  for (const Way& way : ways) {
    const Seen saw = confined(way.goes);
    EXPECT_FALSE(saw.done) << way.name;
    EXPECT_EQ(saw.error, EACCES) << way.name;
    EXPECT_EQ(saw.tries, 1) << way.name;
    EXPECT_EQ(saw.what.data(), way.what) << way.name;
    EXPECT_NE(::access(path, F_OK), 0) << way.name;
  }
}

TEST_F(Confinement, CopiesAreConfined) {
  const Seen saw = confined([this] {
    Child copy = Child::copy({.keeps_streams = true, .keeps_signals = true},
                             [this] { return ::creat(file().c_str(), 0600) == -1 ? 7 : 0; });
    return copy.wait().exited_with(7);
  });
  EXPECT_TRUE(saw.done);
  EXPECT_EQ(saw.tries, 1);
}

}  // namespace
}  // namespace regista::process
