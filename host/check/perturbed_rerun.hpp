// SPDX-License-Identifier: MIT
// Plays the scenario of a plugin (the calls by which the testkit checks its kind) again in other surroundings, which
// must not change the answers. The program is started again, so code and data have other addresses. Its environment is
// almost empty, and its working folder is another one. Another plugin plays first, so that an answer that depends on
// other plugins in the process changes.
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

// Returns options of the testkit that give the plugin its values, and write to `note` what is checked. All arguments
// must outlive the options.
testkit::Options options_with(std::uint64_t seed, const GivenValues& given, const std::string& plugin, Underway& note);

// Plays the scenario. The outcome's only line is a hash of all answers. Changes the working folder and draws from
// rand().
Outcome play_perturbed(const Elsewhere& what, Underway& note);

}  // namespace regista::check
