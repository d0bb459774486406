// SPDX-License-Identifier: MIT
// Contexts that write to standard error: a little, and much.
#include <cstdio>

#include <regista/context.hpp>

struct Whispers {
  static constexpr auto id = "whispers", version = "1.0.0", summary = "Says one line in each match";
  bool holds(const regista::Frame&) {
    static bool said = false;
    // The escape sequence would clear a terminal.
    if (!said) std::fputs("a word from whispers\x1b[2J\n", stderr);
    return said = true;
  }
};

struct Babbles {
  static constexpr auto id = "babbles", version = "1.0.0", summary = "Says a line at each call";
  int asked = 0;
  bool holds(const regista::Frame&) {
    std::fprintf(stderr, "babbles: call %d\n", ++asked);
    return true;
  }
};

REGISTA_PLUGINS(regista::Plugin<Whispers, regista::context>, regista::Plugin<Babbles, regista::context>)
