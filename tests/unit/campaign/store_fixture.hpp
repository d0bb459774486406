// SPDX-License-Identifier: MIT
// A folder for files of results, and results to put there.
#pragma once

#include <SQLiteCpp/SQLiteCpp.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <string>
#include <vector>

#include "campaign/match_encoding.hpp"
#include "campaign/store.hpp"

namespace regista::campaign {

class StoreTest : public testing::Test {
 protected:
  using Mode = Store::Mode;

  StoreTest() { std::filesystem::create_directory(folder); }
  ~StoreTest() override {
    std::filesystem::permissions(folder, std::filesystem::perms::owner_all);
    std::filesystem::remove_all(folder);
  }

  static Job job_of(const std::string& home, const std::string& away) {
    Job job;
    job.teams = {home, away};
    job.overrides = {"home.x=1"};
    job.home_inputs = {{"team " + home, "1"}};
    return job;
  }

  // The number of one fixture, added when it is new.
  static std::int64_t number(Store& store, const std::string& key) {
    return store.add(std::vector<Store::Fixture>{{key, job_of("a.yaml", "b.yaml")}}).front();
  }

  void execute(const std::string& statement) const {
    SQLite::Database(file.string(), SQLite::OPEN_READWRITE).exec(statement);
  }

  std::vector<std::string> names_in_folder() const {
    std::vector<std::string> out;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) out.push_back(entry.path().filename());
    return out;
  }

  std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / ("store-" + std::to_string(getpid()));
  std::filesystem::path file = folder / "results.db";
  MatchResult played{{3, 1}, "full_time", "9f2c", metrics_from_json(R"({"packets":[1,2]})"), std::nullopt, 1.5};
  MatchResult forfeited = forfeit({1, "greedy", "assign", 3, 417, "Segmentation fault"}, 0.5);
};

}  // namespace regista::campaign
