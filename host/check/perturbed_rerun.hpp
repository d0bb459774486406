// SPDX-License-Identifier: MIT
// Plays the scenario of a plugin (the calls by which the testkit checks its kind) again in other surroundings, which
// must not change the answers: the program is started again, so code and data have other addresses; the environment is
// almost empty; the working folder is another one; and another plugin plays first.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include <regista/testkit/checks.hpp>

#include "check/given_values.hpp"
#include "check/isolation.hpp"

namespace regista::check {

// The scenario to play. Words of a command line pass the scenario to the program that plays the scenario.
struct Elsewhere {
  std::filesystem::path file;  // absolute path
  std::string plugin;          // id of the plugin
  std::int32_t kind = 0;
  std::uint64_t seed = 0;
  std::filesystem::path visitors;  // folder with other plugins, one of which plays first; may be empty
  GivenTexts parameters;

  std::vector<std::string> words() const;
  // Reads the result of words(). Throws config::BadInput for other words.
  static Elsewhere of(const std::vector<std::string>& words);
};

// Returns the environment for the program that plays the scenario, each variable as "NAME=VALUE".
std::vector<std::string> environment_elsewhere();

// Returns options that give the plugin its values and write to `note` what is checked. The arguments must outlive them.
testkit::Options options_with(std::uint64_t seed, const GivenValues& given, const std::string& plugin, Underway& note);

// Plays the scenario. The only line is a hash of all answers. Changes the working folder and draws from rand().
Outcome play_perturbed(const Elsewhere& what, Underway& note);

}  // namespace regista::check
