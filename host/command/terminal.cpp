// SPDX-License-Identifier: MIT
#include "command/terminal.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <string_view>
#include <system_error>

namespace regista::command {

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

}  // namespace regista::command
