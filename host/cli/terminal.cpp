// SPDX-License-Identifier: MIT
#include "cli/terminal.hpp"

#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace regista::cli {

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

}  // namespace regista::cli
