// SPDX-License-Identifier: MIT
#include "command/interruption.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <csignal>
#include <cstddef>

#include "command/end_of_program.hpp"

namespace regista::command {
namespace {

// A handler of signals can reach nothing but variables of the program.
volatile std::sig_atomic_t request = 0;  // the signal that has asked; 0: none
bool listening = false;
std::array<char, 4096> words;
std::size_t words_size = 0;

void ask_to_stop(int signal_number) {
  request = signal_number;
  alarm(1);
}

void stop(int signal_number) {
  if (request == 0) {  // the alarm of somebody else, who wants the process to end
    std::signal(signal_number, SIG_DFL);
    raise(signal_number);
    return;
  }
  [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, words.data(), words_size);
  _exit(exit_by_signal(request));
}

// A signal that the program was told to ignore, as nohup does, stays ignored.
bool ignored(int signal_number) {
  struct sigaction now {};
  return sigaction(signal_number, nullptr, &now) == 0 && now.sa_handler == SIG_IGN;
}

void handle(int signal_number, void (*handler)(int), int flags) {
  if (ignored(signal_number)) return;
  struct sigaction action {};
  action.sa_handler = handler;
  action.sa_flags = flags;
  sigemptyset(&action.sa_mask);
  sigaction(signal_number, &action, nullptr);
}

}  // namespace

Interruption::Interruption(std::string_view last_words) {
  assert(!listening);
  listening = true;
  request = 0;
  words_size = std::min(last_words.size(), words.size());
  std::copy_n(last_words.data(), words_size, words.data());
  handle(SIGALRM, stop, 0);
  // SA_RESETHAND: the second signal acts as usual.
  handle(SIGINT, ask_to_stop, static_cast<int>(SA_RESETHAND));
  handle(SIGTERM, ask_to_stop, static_cast<int>(SA_RESETHAND));
  handle(SIGHUP, ask_to_stop, static_cast<int>(SA_RESETHAND));
}

Interruption::~Interruption() {
  alarm(0);
  handle(SIGINT, SIG_DFL, 0);
  handle(SIGTERM, SIG_DFL, 0);
  handle(SIGHUP, SIG_DFL, 0);
  handle(SIGALRM, SIG_DFL, 0);
  listening = false;
}

int Interruption::signal_number() const { return request; }

}  // namespace regista::command
