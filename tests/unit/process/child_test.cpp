// SPDX-License-Identifier: MIT
// Every way in which a child begins and ends, by what the system itself says of it (/proc, signals, exit codes).
#include "process/child.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <csignal>
#include <fstream>
#include <functional>
#include <string>
#include <system_error>
#include <thread>
#include <vector>

#include "process/file_descriptor.hpp"
#include "process/sanitized.hpp"

namespace regista::process {
namespace {

using testing::HasSubstr;

// What a copy answers, by descriptor 3, until it has ended.
struct Answer {
  std::string text;
  ProcessEnd end;
};

Answer answer_of(Setting setting, const std::function<int()>& work) {
  Pipe pipe = make_pipe();
  setting.files.push_back({pipe.write.number, 3});
  Answer out;
  Child child = Child::copy(setting, work);
  pipe.write.reset();
  while (pipe.read.is_open()) {
    pollfd watched{pipe.read.number, POLLIN, 0};
    ::poll(&watched, 1, -1);
    read_available(pipe.read, [&](std::string_view piece) { out.text += piece; });
  }
  out.end = child.wait();
  return out;
}

int work_for_ever() {
  for (std::atomic<unsigned> work = 0;;) ++work;
}

std::string link(int number) {
  std::string out(4096, '\0');
  const ssize_t size = ::readlink(("/proc/self/fd/" + std::to_string(number)).c_str(), out.data(), out.size());
  out.resize(size > 0 ? static_cast<std::size_t>(size) : 0);
  return out;
}

TEST(Child, StandardStreamsAreNothingUnlessHandedOver) {
  const Answer answer = answer_of({}, [] {
    for (const int stream : {0, 1, 2}) write_all(3, link(stream) + '\n');
    return 0;
  });
  EXPECT_EQ(answer.text, "/dev/null\n/dev/null\n/dev/null\n");
  const Answer kept = answer_of({.keeps_streams = true}, [] { return write_all(3, link(0) + link(1) + link(2)), 0; });
  EXPECT_EQ(kept.text, link(0) + link(1) + link(2));
}

// The numbers of some are those that others are to have.
TEST(Child, FilesComeUnderTheirNumbersWhateverTheyWereHere) {
  std::vector<FileDescriptor> files;
  for (int i = 0; i < 3; ++i) files.push_back(memory_file(std::string(1, static_cast<char>('a' + i))));
  std::vector<HandedFile> handed;
  const int first = files[0].number;
  for (int i = 0; i < 3; ++i) handed.push_back({files[static_cast<std::size_t>(i)].number, first + (i + 1) % 3});
  handed.push_back({HandedFile::nothing, first + 3});
  Pipe pipe = make_pipe();
  pipe.write = moved_up(std::move(pipe.write), 300);
  Child child = Child::copy({.files = handed}, [&] {
    for (int i = 0; i < 3; ++i) write_all(pipe.write.number, everything_in(first + i));
    write_all(pipe.write.number, link(first + 3));
    return 0;
  });
  child.wait();
  std::string text;
  pipe.write.reset();
  read_available(pipe.read, [&](std::string_view piece) { text += piece; });
  EXPECT_EQ(text, "cab/dev/null");
}

TEST(Child, HasAGroupOfItsOwnAndTheSystemsSignals) {
  std::signal(SIGTERM, SIG_IGN);
  const pid_t parent = ::getpid();
  const Answer answer = answer_of({}, [parent] {
    sigset_t mask;
    sigprocmask(SIG_BLOCK, nullptr, &mask);
    struct sigaction action {};
    sigaction(SIGTERM, nullptr, &action);
    return ::getpgrp() == ::getpid() && ::getppid() == parent && action.sa_handler == SIG_DFL &&
                   sigismember(&mask, SIGTERM) == 0
               ? 0
               : 1;
  });
  EXPECT_TRUE(answer.end.exited_with(0));
  const Answer kept = answer_of({.keeps_signals = true}, [] {
    struct sigaction action {};
    sigaction(SIGTERM, nullptr, &action);
    return action.sa_handler == SIG_IGN ? 0 : 1;
  });
  EXPECT_TRUE(kept.end.exited_with(0));
  std::signal(SIGTERM, SIG_DFL);
}

TEST(Child, EndsInWords) {
  const auto words = [](const std::function<int()>& work) { return answer_of({}, work).end; };
  EXPECT_EQ(words([] { return 3; }).in_words(), "ended the process (exit code 3)");
  EXPECT_EQ(words([] { return std::signal(SIGSEGV, SIG_DFL), raise(SIGSEGV), 0; }).in_words(), "Segmentation fault");
  EXPECT_FALSE(words([] { return std::signal(SIGSEGV, SIG_DFL), raise(SIGSEGV), 0; }).from_outside());
  for (const int sent : {SIGKILL, SIGTERM, SIGINT, SIGHUP, SIGQUIT}) {
    const ProcessEnd end = words([sent] { return raise(sent), 0; });
    EXPECT_TRUE(end.from_outside()) << sent;
    EXPECT_EQ(end.signal_number(), sent);
  }
  EXPECT_EQ(used_processor_time(10), "used more than 10 s of processor time");
  EXPECT_EQ(did_not_return(200.0), "did not return within 200 s");
}

std::optional<ProcessEnd> end_within(Child& child, double seconds) {
  const auto until = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  while (std::chrono::steady_clock::now() < until) {
    if (const auto end = child.look()) return end;
    ::poll(nullptr, 0, 2);
  }
  return std::nullopt;
}

TEST(Child, OneThatIsStoppedIsSeenAndCanBeEnded) {
  Child child = Child::copy({}, [] { return raise(SIGSTOP), 0; });
  const auto stopped = end_within(child, 60.0);
  ASSERT_TRUE(stopped && stopped->was_stopped());
  EXPECT_EQ(stopped->in_words(), "was stopped (Stopped (signal))");
  EXPECT_TRUE(child.runs());
  child.kill();
  EXPECT_EQ(child.wait().signal_number(), SIGKILL);
  EXPECT_FALSE(child.runs());
}

TEST(Child, WhatItStartedEndsWithIt) {
  Pipe pipe = make_pipe();
  Child child = Child::copy({}, [] {
    if (::fork() == 0) ::pause();
    return 0;
  });
  pipe.write.reset();  // the grandchild has the other copy
  const auto end = end_within(child, 60.0);
  ASSERT_TRUE(end && end->exited_with(0));
  pollfd watched{pipe.read.number, POLLIN, 0};
  EXPECT_EQ(::poll(&watched, 1, 60'000), 1);
  read_available(pipe.read, [](std::string_view) {});
  EXPECT_FALSE(pipe.read.is_open());
}

TEST(Child, OneThatNobodyWaitedForIsEnded) {
  pid_t process = -1;
  {
    const Child child = Child::copy({}, [] { return ::pause(), 0; });
    process = child.process();
  }
  EXPECT_EQ(::kill(process, 0), -1);
  EXPECT_EQ(errno, ESRCH);
}

TEST(Child, DiesWithItsParent) {
  Pipe pipe = make_pipe();
  Child parent = Child::copy({}, [&] {
    pipe.read.reset();
    static const Child child = Child::copy({}, [] { return ::pause(), 0; });
    write_all(pipe.write.number, "begun");
    return ::pause(), 0;
  });
  pipe.write.reset();
  std::string text;
  bool killed = false;
  while (pipe.read.is_open()) {
    pollfd watched{pipe.read.number, POLLIN, 0};
    ASSERT_EQ(::poll(&watched, 1, 60'000), 1);
    read_available(pipe.read, [&](std::string_view piece) { text += piece; });
    // The child is in another group, so that only its parent's death ends it and its end of the pipe.
    if (text == "begun" && !std::exchange(killed, true)) parent.kill();
  }
  EXPECT_TRUE(killed);
}

TEST(Child, LimitsOfProcessorTimeAndMemory) {
  Child busy = Child::copy({.limits = {.processor_seconds = 1}}, work_for_ever);
  const ProcessEnd end = busy.wait();
  EXPECT_TRUE(end.out_of_processor_time());
  EXPECT_GE(end.processor_seconds, 0.5);  // the limit is counted in ticks of the clock, this exactly: 0.87 was seen
  const Answer answer = answer_of({.limits = {.memory = 1u << 30, .small_stack = true}}, [] {
    rlimit core{}, stack{}, addresses{};
    getrlimit(RLIMIT_CORE, &core);
    getrlimit(RLIMIT_STACK, &stack);
    getrlimit(RLIMIT_AS, &addresses);
    const bool limited = addresses.rlim_cur == 1u << 30 || addresses_are_reserved();
    return core.rlim_cur == 0 && stack.rlim_cur == 8u << 20 && limited ? 0 : 1;
  });
  EXPECT_TRUE(answer.end.exited_with(0));
}

TEST(Child, AProgramWithWordsAndVariables) {
  Pipe pipe = make_pipe();
  std::vector<std::string> variables{"A=b c"};
  const std::vector<char*> environment = pointers(variables);
  Child child =
      Child::program({.files = {{pipe.write.number, 1}}}, {"sh", {"sh", "-c", "echo $A; exit 4"}, environment});
  pipe.write.reset();
  EXPECT_TRUE(child.wait().exited_with(4));
  std::string text;
  read_available(pipe.read, [&](std::string_view piece) { text += piece; });
  EXPECT_EQ(text, "b c\n");
}

TEST(Child, AProgramThatCannotBeStartedSaysWhy) {
  try {
    Child::program({}, {"no-such-program-anywhere", {"no-such-program-anywhere"}});
    FAIL();
  } catch (const std::system_error& error) {
    EXPECT_EQ(error.code(), std::errc::no_such_file_or_directory);
    EXPECT_THAT(error.what(), HasSubstr("cannot start no-such-program-anywhere"));
  }
}

TEST(IdleProcess, OneThatSleepsIsIdleAndOneThatWorksIsNot) {
  const Child sleeps = Child::copy({}, [] { return ::pause(), 0; });
  const Child works = Child::copy({}, work_for_ever);
  IdleProcess sleeper(sleeps.process()), worker(works.process());
  double idle = 0.0;
  for (int i = 0; i < 600 && idle <= 0.5; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
    idle = sleeper.idle_seconds();
    EXPECT_EQ(worker.idle_seconds() > idle, false);
  }
  EXPECT_GT(idle, 0.5);
  EXPECT_GT(processor_seconds_of(works.process()), 0.0);
  EXPECT_GT(address_space_of(works.process()), 0u);
}

TEST(CallWatch, CountsFromTheMomentThatACallIsSeenFirst) {
  const Child works = Child::copy({}, work_for_ever);
  CallWatch<int> watch({.processor_seconds = 0, .wall_seconds = 1000.0});
  Exceeded exceeded = watch.look(1, true, works.process());
  for (int i = 0; i < 6000 && exceeded == Exceeded::nothing; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
    exceeded = watch.look(1, true, works.process());
  }
  EXPECT_EQ(exceeded, Exceeded::processor_time);
  EXPECT_EQ(watch.look(1, false, works.process()), Exceeded::nothing);  // between two calls
  EXPECT_EQ(watch.look(2, true, works.process()), Exceeded::nothing);   // another one
  CallWatch<int> late({.processor_seconds = 1000, .wall_seconds = 0.0});
  std::this_thread::sleep_for(std::chrono::milliseconds(1));
  EXPECT_EQ(late.look(0, false, works.process()), Exceeded::wall_time);
}

}  // namespace
}  // namespace regista::process
