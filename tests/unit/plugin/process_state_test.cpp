// SPDX-License-Identifier: MIT
// This process changes itself, and is told what was changed.
#include "plugin/process_state.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <clocale>
#include <condition_variable>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <mutex>
#include <string>
#include <thread>

namespace regista::plugin {
namespace {

std::string left_by(const std::function<void()>& work) {
  const ProcessState before = ProcessState::now();
  work();
  return changes(before, ProcessState::now());
}

TEST(ProcessState, NothingWhereNothingIsLeft) {
  EXPECT_EQ(left_by([] {}), "");
  EXPECT_EQ(left_by([] {
              std::thread([] {}).join();
              ::close(::open("/dev/null", O_RDONLY));
              std::signal(SIGUSR1, std::signal(SIGUSR1, SIG_IGN));
            }),
            "");
}

TEST(ProcessState, Threads) {
  std::mutex mutex;
  std::condition_variable changed;
  bool end = false;
  const auto wait = [&] {
    std::unique_lock lock(mutex);
    changed.wait(lock, [&] { return end; });
  };
  std::thread one, other;
  EXPECT_EQ(left_by([&] { one = std::thread(wait); }), "left 1 thread running");
  EXPECT_EQ(left_by([&] { other = std::thread(wait); }), "left 1 thread running");
  const ProcessState with_two = ProcessState::now();
  {
    const std::scoped_lock lock(mutex);
    end = true;
  }
  changed.notify_all();
  one.join();
  other.join();
  const ProcessState without = ProcessState::now();
  EXPECT_EQ(with_two.threads - without.threads, 2);
  EXPECT_EQ(changes(without, with_two), "left 2 threads running");
  EXPECT_EQ(changes(with_two, without), "");  // a thread of the host's own may end
}

TEST(ProcessState, Descriptors) {
  int first = -1, second = -1;
  const ProcessState before = ProcessState::now();
  first = ::open("/dev/null", O_RDONLY);
  EXPECT_EQ(changes(before, ProcessState::now()), fmt::format("left file descriptor {} open", first));
  second = ::open("/dev/null", O_RDONLY);
  EXPECT_EQ(changes(before, ProcessState::now()), "left 2 file descriptors open");
  EXPECT_EQ(left_by([&] { ::close(first); }), fmt::format("closed file descriptor {}", first));
  first = ::open("/dev/null", O_RDONLY);
  EXPECT_EQ(left_by([&] {
              ::close(first);
              ::close(second);
            }),
            fmt::format("closed file descriptors {}, {}", std::min(first, second), std::max(first, second)));
}

TEST(ProcessState, WorkingFolder) {
  const std::filesystem::path here = std::filesystem::current_path();
  EXPECT_EQ(left_by([] { std::filesystem::current_path("/"); }), here == "/" ? "" : "changed the working folder");
  std::filesystem::current_path(here);
}

TEST(ProcessState, HandlersOfSignals) {
  EXPECT_EQ(left_by([] { std::signal(SIGUSR2, [](int) {}); }), "changed the handler of SIGUSR2");
  EXPECT_EQ(left_by([] { std::signal(SIGUSR2, SIG_DFL); }), "changed the handler of SIGUSR2");
}

TEST(ProcessState, AllOfThemInOneLine) {
  int opened = -1;
  const std::string left = left_by([&] {
    std::signal(SIGUSR1, SIG_IGN);
    opened = ::open("/dev/null", O_RDONLY);
  });
  EXPECT_EQ(left, fmt::format("left file descriptor {} open, changed the handler of SIGUSR1", opened));
  std::signal(SIGUSR1, SIG_DFL);
  ::close(opened);
}

TEST(ProcessState, WhatElseIsEverybodys) {
  EXPECT_EQ(left_by([] { ::setenv("REGISTA_TEST_LEFT", "1", 1); }),
            "changed the environment variable \"REGISTA_TEST_LEFT\"");
  EXPECT_EQ(left_by([] { ::setenv("REGISTA_TEST_LEFT", "2", 1); }),
            "changed the environment variable \"REGISTA_TEST_LEFT\"");
  EXPECT_EQ(left_by([] {
              ::unsetenv("REGISTA_TEST_LEFT");
              ::setenv("REGISTA_TEST_OTHER", "", 1);
            }),
            "changed 2 variables of the environment");
  ::unsetenv("REGISTA_TEST_OTHER");
  const mode_t before = ::umask(0027);
  EXPECT_EQ(left_by([] { ::umask(0); }), "changed the mode of new files (umask)");
  ::umask(before);
  sigset_t one, old;
  sigemptyset(&one);
  sigaddset(&one, SIGUSR2);
  EXPECT_EQ(left_by([&] { ::pthread_sigmask(SIG_BLOCK, &one, &old); }), "changed which signals are blocked");
  ::pthread_sigmask(SIG_SETMASK, &old, nullptr);
  EXPECT_EQ(left_by([] { std::setlocale(LC_NUMERIC, "C.UTF-8"); }), "changed the locale");
  std::setlocale(LC_ALL, "C");
}

TEST(ProcessState, ProcessesAlsoWhereTheirParentHasEnded) {
  keep_orphans();
  const auto one = [] {
    const pid_t child = ::fork();
    if (child == 0) ::_exit(0);
    return child;
  };
  EXPECT_EQ(left_by([&] { ::waitpid(one(), nullptr, 0); }), "");
  EXPECT_EQ(left_by([&] { one(); }), "left a process running");
  while (::wait(nullptr) > 0) {
  }
  EXPECT_EQ(left_by([&] {
              const pid_t between = ::fork();
              if (between == 0) {
                ::setsid();
                one();
                ::_exit(0);
              }
              ::waitpid(between, nullptr, 0);
            }),
            "left a process running");
  while (::wait(nullptr) > 0) {
  }
}

}  // namespace
}  // namespace regista::plugin
