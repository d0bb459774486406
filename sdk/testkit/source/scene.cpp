// SPDX-License-Identifier: MIT
// Lays a scene out in the memory that a plugin reads.
#include <regista/testkit/scene.hpp>

#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>
#include <utility>

namespace regista::testkit {

struct Scene::Stored {
  struct World {
    World(const WorldData& data, Growth growth) : robots(data.robots, growth), opponents(data.opponents, growth) {
      std::vector<std::int32_t> numbers;
      for (const regista_robot& robot : data.robots) {
        if (robot.flags & REGISTA_ROBOT_ACTIVE) numbers.push_back(robot.number);
      }
      active = Strided<std::int32_t>(numbers, growth);
      regista_world raw{};
      raw.game = data.game;
      raw.ball = data.ball;
      raw.robots = robots.span();
      raw.opponents = opponents.span();
      raw.active = active.span();
      world = Grown<regista_world>(raw, growth);
    }
    bool unchanged() const {
      return robots.unchanged() && opponents.unchanged() && active.unchanged() && world.unchanged();
    }
    Strided<regista_robot> robots;
    Strided<regista_opponent> opponents;
    Strided<std::int32_t> active;
    Grown<regista_world> world;
  };

  Stored(SceneData from, Growth growth)
      : data(std::move(from)),
        mine(data.mine, growth),
        common(data.common, growth),
        tasks(data.tasks, growth),
        waypoints(data.waypoints, growth),
        edges(data.edges, growth),
        previous(data.previous, growth) {
    regista_frame raw{};
    raw.own_number = data.own_number;
    raw.tick = data.tick;
    raw.time = data.time;
    raw.knowledge = data.knowledge;
    raw.context = data.context;
    raw.mine = &mine.world.get();
    raw.common = &common.world.get();
    raw.tasks = tasks.span();
    raw.waypoints = waypoints.span();
    raw.edges = edges.span();
    raw.previous = previous.span();
    if (data.has_times) raw.time_to_task = fill_times(growth);
    frame = Grown<regista_frame>(raw, growth);
  }
  Stored(const Stored&) = delete;
  Stored& operator=(const Stored&) = delete;

  // Straight line at walking speed, after getting up.
  regista_matrix fill_times(Growth growth) {
    const regista::World world(data.knowledge == REGISTA_COMMON ? common.world.get() : mine.world.get());
    const std::size_t rows = world.active().size(), columns = data.tasks.size();
    const std::size_t stride = columns + growth.bytes / sizeof(double);
    times.assign(rows * stride, std::numeric_limits<double>::quiet_NaN());
    for (std::size_t i = 0; i < rows; ++i) {
      const regista_robot& robot = world.robot(world.active()[i]);
      for (std::size_t j = 0; j < columns; ++j) {
        const double* to = data.tasks[j].after;
        times[i * stride + j] =
            std::hypot(to[0] - robot.pose[0], to[1] - robot.pose[1]) / data.walk_speed + robot.time_until_up;
      }
    }
    times_built = times;
    return {times.data(), static_cast<std::uint32_t>(rows), static_cast<std::uint32_t>(columns),
            static_cast<std::uint32_t>(stride), 0};
  }
  bool times_as_built() const {
    return times.size() == times_built.size() &&
           (times.empty() || std::memcmp(times.data(), times_built.data(), times.size() * sizeof(double)) == 0);
  }

  SceneData data;
  World mine, common;
  Strided<regista_task> tasks;
  Strided<regista_waypoint> waypoints;
  Strided<regista_edge> edges;
  Strided<std::int32_t> previous;
  std::vector<double> times, times_built;
  Grown<regista_frame> frame;
};

Scene::Scene(SceneData data, Growth growth) : stored_(std::make_shared<Stored>(std::move(data), growth)) {}

const regista_frame& Scene::raw() const { return stored_->frame.get(); }

regista::Frame Scene::frame() const { return regista::Frame(raw()); }

const std::string& Scene::name() const { return stored_->data.name; }

const SceneData& Scene::data() const { return stored_->data; }

std::uint32_t Scene::team_size() const { return static_cast<std::uint32_t>(stored_->data.mine.robots.size()); }

std::uint32_t Scene::rows() const { return static_cast<std::uint32_t>(frame().world().active().size()); }

std::uint32_t Scene::columns() const { return static_cast<std::uint32_t>(stored_->data.tasks.size()); }

Scene Scene::grown(Growth growth) const { return Scene(stored_->data, growth); }

Scene Scene::before_placing() const {
  SceneData copy = stored_->data;
  copy.waypoints.clear();
  copy.edges.clear();
  copy.has_times = false;
  return Scene(std::move(copy));
}

Scene Scene::before_tasks() const {
  SceneData copy = before_placing().data();
  copy.tasks.clear();
  return Scene(std::move(copy));
}

bool Scene::unchanged() const {
  const Stored& s = *stored_;
  return s.mine.unchanged() && s.common.unchanged() && s.tasks.unchanged() && s.waypoints.unchanged() &&
         s.edges.unchanged() && s.previous.unchanged() && s.times_as_built() && s.frame.unchanged();
}

}  // namespace regista::testkit
