// SPDX-License-Identifier: MIT
// One decision as a plugin sees it, with all the memory it points to. FrameBuilder makes scenes; this is what they are.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <regista/frame.hpp>
#include <regista/testkit/storage.hpp>

namespace regista::testkit {

// A world in plain vectors. robots: robot n is element n - 1.
struct WorldData {
  regista_game game{};
  regista_ball ball{};
  std::vector<regista_robot> robots;
  std::vector<regista_opponent> opponents;
};

struct SceneData {
  std::string name;
  std::uint64_t tick = 0;
  double time = 0.0;
  std::int32_t own_number = 1, knowledge = REGISTA_MINE, context = 0;
  WorldData mine, common;
  std::vector<regista_task> tasks;
  std::vector<regista_waypoint> waypoints;
  std::vector<regista_edge> edges;
  std::vector<std::int32_t> previous;  // task id per robot
  double walk_speed = 0.25;            // for time_to_task
  bool has_times = true;               // false: time_to_task is 0 x 0, as before the filter

  const WorldData& chosen() const { return knowledge == REGISTA_COMMON ? common : mine; }
};

// How a host shows a scene: how much longer its structs and elements are, and to a plugin that declares which reads.
// Parts that are not among them are empty, with NaN where they were, and single numbers of them are NaN.
struct Showing {
  Layout layout;
  std::uint32_t reads = REGISTA_READS_ALL;
};

// Immutable; copies share the storage. The pointers inside live as long as one copy does.
class Scene {
 public:
  explicit Scene(SceneData data, const Showing& showing = {});

  const regista_frame& raw() const;
  regista::Frame frame() const;
  const std::string& name() const;
  const SceneData& data() const;
  std::uint32_t team_size() const;
  // Shape of a matrix of utilities: active robots of the chosen world x tasks.
  std::uint32_t rows() const;
  std::uint32_t columns() const;

  // The same scene from another host, or to another plugin.
  Scene shown(const Showing& showing) const;
  // The same scene from a host of a later minor version.
  Scene grown(Layout layout) const { return shown({layout, REGISTA_READS_ALL}); }
  // What a positioner is shown of it: no waypoints, no times yet.
  Scene before_placing() const;
  // What a context is shown of it: no tasks either.
  Scene before_tasks() const;
  // Whether a plugin left its input alone.
  bool unchanged() const;

 private:
  struct Stored;
  std::shared_ptr<Stored> stored_;
};

}  // namespace regista::testkit
