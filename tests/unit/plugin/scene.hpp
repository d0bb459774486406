// SPDX-License-Identifier: MIT
// What every test of the plugin room needs: the shared objects that are wrong on purpose, YAML values without a YAML
// file, a robot on a field, and what an exception says.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "config/team.hpp"
#include "plugin/instance.hpp"
#include "plugin/shared_object.hpp"

namespace regista::plugin::test {

namespace fs = std::filesystem;

// tests/fixtures/plugins/<name>, as built.
inline fs::path shared_object(const std::string& name) { return fs::path(TEST_PLUGINS) / name / (name + ".so"); }

inline Found open(const std::string& name, std::size_t index = 0) {
  const SharedObject object = open_shared_object(shared_object(name));
  EXPECT_EQ(object.refusal, "");
  return {shared_object(name), object.descriptors.at(index)};
}

// A folder that is gone, with all in it, at the end of the test.
class Folder {
 public:
  Folder() {
    std::string name = fs::temp_directory_path() / "regista_plugin_XXXXXX";
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    path_ = name;
  }
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  const fs::path& path() const { return path_; }
  fs::path operator/(const std::string& name) const { return path_ / name; }

 private:
  fs::path path_;
};

inline config::Node scalar(const std::string& text, int line = 3, const std::string& file = "team.yaml") {
  return config::Node::scalar(text, false, {file, line, 20});
}

inline config::Node quoted(const std::string& text) { return config::Node::scalar(text, true, {"team.yaml", 3, 20}); }

// `params: {...}` of a team, one value a line from line 3 on.
inline config::Node map(const std::vector<std::pair<std::string, config::Node>>& values) {
  std::vector<config::Node::Entry> entries;
  for (int line = 3; const auto& [key, value] : values) entries.push_back({key, {"team.yaml", line++, 10}, value});
  return config::Node::map(entries, {"team.yaml", 2, 30});
}

inline config::PluginUse use(const std::string& id, const config::Node& params = {}, const fs::path& file = {}) {
  return {id, file.string(), params, {"team.yaml", 2, 13}};
}

// What the exception that `body` throws says; "" when it throws none.
template <class Body>
std::string message_of(Body&& body) {
  try {
    body();
  } catch (const std::exception& exception) {
    return exception.what();
  }
  return "";
}

// A field of 9 m x 6 m with 0.7 m around it and five robots; robot 3 is oneself.
inline regista_environment environment(std::uint32_t subject = 0) {
  regista_environment out{};
  out.size = sizeof out;
  out.team_size = 5;
  out.own_number = 3;
  out.subject = subject;
  out.field_length = 9.0;
  out.field_width = 6.0;
  out.border_strip = 0.7;
  return out;
}

inline const Caller paper{"paper", 3, 417};

// An instance for robot 3 of team paper, reset and ready.
inline std::shared_ptr<Instance> instance_of(const Found& plugin, std::uint32_t subject = 0,
                                             const config::Node& params = {}) {
  const Parameters parameters = resolve(*plugin.descriptor, use(plugin.descriptor->id, params));
  auto out = std::make_shared<Instance>(plugin, parameters, environment(subject), nullptr, &paper);
  out->reset(1);
  return out;
}

// "plugin <name> (<file>) of team paper, robot 3, tick 417: <rest>"
inline std::string failure(const std::string& name, const std::string& rest) {
  return "plugin " + name + " (" + shared_object(name).string() + ") of team paper, robot 3, tick 417: " + rest;
}

// Worlds without anybody, and `tasks` tasks.
struct Scene {
  regista_game game{};
  regista_ball ball{};
  regista_world world{};
  std::vector<regista_task> tasks;
  regista_frame frame{};

  explicit Scene(std::size_t task_count = 0) : tasks(task_count) {
    game.size = sizeof game;
    ball.size = sizeof ball;
    world.size = sizeof world;
    world.game = &game;
    world.ball = &ball;
    frame.size = sizeof frame;
    frame.own_number = 3;
    frame.mine = frame.common = &world;
    frame.tasks = {tasks.data(), static_cast<std::uint32_t>(tasks.size()), sizeof(regista_task)};
  }
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;
};

// rows x columns in memory of its own, with room to spare in each row.
struct Matrix {
  static constexpr double spare = -77.0;
  std::vector<double> values;
  regista_matrix raw;

  Matrix(std::uint32_t rows, std::uint32_t columns, double value = 0.0)
      : values(std::size_t{rows} * (columns + 3), spare), raw{values.data(), rows, columns, columns + 3, 0} {
    for (std::uint32_t i = 0; i < rows; ++i) {
      for (std::uint32_t j = 0; j < columns; ++j) (*this)(i, j) = value;
    }
  }
  Matrix(const Matrix&) = delete;
  Matrix& operator=(const Matrix&) = delete;
  double& operator()(std::uint32_t i, std::uint32_t j) { return values[std::size_t{i} * raw.stride + j]; }
};

}  // namespace regista::plugin::test
