// SPDX-License-Identifier: MIT
#include "command/terminal.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <new>
#include <system_error>

#include "output/replaced_file.hpp"
#include "plugin/fatal_signal.hpp"
#include "texts/message.hpp"

namespace regista::command {

namespace {

// These variables are global, because a signal handler can use only global variables.
volatile std::sig_atomic_t request = 0;  // number of the received signal; 0: no signal
bool listening = false;
std::array<char, 4096> words;
std::size_t words_size = 0;
constexpr std::array asking{SIGINT, SIGTERM, SIGHUP};

void ask_to_stop(int signal_number) {
  request = signal_number;
  alarm(1);
}

void stop(int signal_number) {
  if (request == 0) {  // another program sent SIGALRM to end this process
    std::signal(signal_number, SIG_DFL);
    raise(signal_number);
    return;
  }
  [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, words.data(), words_size);
  _exit(exit_by_signal(request));
}

// Sets the handler of a signal. A signal that the program was started to ignore (nohup) stays ignored.
void handle(int signal_number, void (*handler)(int), int flags = 0) {
  struct sigaction now {
  }, action{};
  if (sigaction(signal_number, nullptr, &now) == 0 && now.sa_handler == SIG_IGN) return;
  action.sa_handler = handler;
  action.sa_flags = flags;
  sigemptyset(&action.sa_mask);
  sigaction(signal_number, &action, nullptr);
}

// Whether standard error shows colours. NO_COLOR: the convention of https://no-color.org.
bool shows_colours() {
  const char* const no_colour = std::getenv("NO_COLOR");
  return can_rewrite() && (no_colour == nullptr || *no_colour == '\0');
}

// style: parameters of Select Graphic Rendition (ECMA-48), "1;31" is bold and red.
void complain_in(const char* style, std::string_view message) {
  const std::string line = texts::one_line(message);
  say(shows_colours() ? fmt::format("\x1b[{}mregista:\x1b[0m {}\n", style, line) : fmt::format("regista: {}\n", line));
}

// Explains an error. Returns the exit code.
int failed(std::string_view message, int exit_code) {
  complain_in("1;31", message);
  return exit_code;
}

}  // namespace

std::size_t columns_of_output() {
  winsize size{};
  std::size_t columns = 80;
  if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0) {
    columns = size.ws_col;
  } else if (const char* const said = std::getenv("COLUMNS")) {
    const std::string_view text(said);
    std::size_t read = 0;
    if (std::from_chars(text.begin(), text.end(), read).ec == std::errc() && read > 0) columns = read;
  }
  return std::clamp<std::size_t>(columns, 40, 120);
}

bool can_rewrite() {
  const char* const type = std::getenv("TERM");
  return isatty(STDERR_FILENO) != 0 && type != nullptr && std::string_view(type) != "dumb";
}

void say(const std::string& text) {
  std::fwrite(text.data(), 1, text.size(), stderr);
  std::fflush(stderr);
}

bool RewrittenLine::due() const {
  return live_ && std::chrono::steady_clock::now() - drawn_ >= std::chrono::milliseconds(100);
}

void RewrittenLine::show(const std::string& text) {
  drawn_ = std::chrono::steady_clock::now();
  shown_ = true;
  say("\r\x1b[K" + text);
}

void RewrittenLine::clear() {
  if (shown_) say("\r\x1b[K");
  shown_ = false;
}

Interruption::Interruption(std::string_view last_words) {
  assert(!listening);
  listening = true;
  request = 0;
  words_size = std::min(last_words.size(), words.size());
  std::copy_n(last_words.data(), words_size, words.data());
  handle(SIGALRM, stop);
  // With SA_RESETHAND, the second signal has its default effect: it ends the program.
  for (const int each : asking) handle(each, ask_to_stop, static_cast<int>(SA_RESETHAND));
}

Interruption::~Interruption() {
  alarm(0);
  for (const int each : asking) handle(each, SIG_DFL);
  handle(SIGALRM, SIG_DFL);
  listening = false;
}

int Interruption::signal_number() const { return request; }

void complain(std::string_view message) {
  complain_in(message.find(": warning: ") == std::string_view::npos ? "1" : "1;33", message);
}

int explain_current_exception() {
  try {
    throw;
  } catch (const BadInput& error) {
    return failed(error.what(), exit_bad_input);
  } catch (const config::Error& error) {
    return failed(error.what(), exit_bad_input);
  } catch (const plugin::Failure& error) {
    return failed(error.what(), exit_bad_input);
  } catch (const Interrupted& error) {
    return failed(error.what(), exit_by_signal(error.signal_number));
  } catch (const output::ReaderGone&) {
    return exit_by_signal(SIGPIPE);  // the reader closed the pipe on purpose, so no message
  } catch (const output::WriteError& error) {
    return failed(error.what(), exit_no);
  } catch (const std::filesystem::filesystem_error& error) {
    // Another program removed a folder while this program used the folder.
    return failed(fmt::format("{}{}: {}", error.path1().string(), error.path1().empty() ? "the working folder" : "",
                              error.code().message()),
                  exit_bad_input);
  } catch (const std::bad_alloc&) {
    return failed("there is not enough memory", exit_no);
  } catch (const std::system_error& error) {  // for example: the system's limit of open files is reached
    return failed(error.what(), exit_no);
  } catch (const std::exception& error) {
    return failed(fmt::format("internal error: {}", error.what()), exit_internal);
  } catch (...) {
    return failed("internal error: something that is no exception was thrown", exit_internal);
  }
}

}  // namespace regista::command
