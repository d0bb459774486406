// SPDX-License-Identifier: MIT
// Plays a plugin's course where everything is different that must not matter: the program is started again, so that all
// code and data have other addresses, with an environment that is almost empty, in another folder, after another plugin
// has been opened and played.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "check/child.hpp"
#include "check/given_values.hpp"

namespace regista::check {

// What is played there. It goes to the program that plays it as words of its command line.
struct Elsewhere {
  std::filesystem::path file;  // absolute
  std::string plugin;          // its id
  std::int32_t kind = 0;
  std::uint64_t seed = 0;
  std::filesystem::path visitors;  // where another plugin is looked for; nobody has to be there
  GivenTexts parameters;

  std::vector<std::string> words() const;
  // Throws config::BadInput for words that words() does not give.
  static Elsewhere of(const std::vector<std::string>& words);
};

// "NAME=VALUE" each: what a program needs that is started there.
std::vector<std::string> environment_elsewhere();

// A number for all that the plugin answers, as the only line. Changes the working folder, and draws from rand().
Outcome play_elsewhere(const Elsewhere& what, Underway& note);

}  // namespace regista::check
