// SPDX-License-Identifier: MIT
// What the tests of this room share: the message of an error, and a folder of files to read.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <ctime>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <string_view>

#include "config/node.hpp"
#include "process/sanitized.hpp"

namespace regista::config {

// What the Error thrown by `act` says, "" when there is none.
template <class Act>
std::string error_of(Act act) {
  try {
    act();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

inline const std::filesystem::path project = REGISTA_PROJECT_DIR;

inline std::string content_of(const std::filesystem::path& file) {
  std::ostringstream content;
  content << std::ifstream(file, std::ios::binary).rdbuf();
  return content.str();
}

// A folder of its own that is the current one while a test runs, so that messages name files as "base.yaml".
class InFolder : public testing::Test {
 protected:
  void SetUp() override {
    before_ = std::filesystem::current_path();
    folder_ = std::filesystem::temp_directory_path() / ("regista_config_" + std::to_string(getpid()) + "_" +
                                                        testing::UnitTest::GetInstance()->current_test_info()->name());
    std::filesystem::create_directories(folder_);
    std::filesystem::current_path(folder_);
  }
  void TearDown() override {
    std::filesystem::current_path(before_);
    std::filesystem::remove_all(folder_);
  }

  void write(const std::filesystem::path& file, std::string_view text) const {
    if (file.has_parent_path()) std::filesystem::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << text;
  }

  std::filesystem::path folder_;

 private:
  std::filesystem::path before_;
};

// Of processor time, so that a busy machine does not make it longer. With sanitizers a tenth of it: rooms that no match
// runs through are not optimised then, and each access is checked.
template <class Act>
double seconds_of(Act act) {
  const std::clock_t begin = std::clock();
  act();
  const double seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  return sanitized ? 0.1 * seconds : seconds;
}

}  // namespace regista::config
