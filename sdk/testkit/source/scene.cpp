// SPDX-License-Identifier: MIT
// Lays a scene out in the memory that a plugin reads.
#include <regista/testkit/scene.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>
#include <utility>

namespace regista::testkit {

namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

bool hides(const Showing& showing, std::uint32_t part) { return (showing.reads & part) == 0; }

WorldData world_for(WorldData data, const Showing& showing) {
  if (!hides(showing, REGISTA_READS_COVARIANCES)) return data;
  for (regista_robot& each : data.robots) std::ranges::fill(each.covariance, not_a_number);
  for (regista_opponent& each : data.opponents) std::ranges::fill(each.covariance, not_a_number);
  std::ranges::fill(data.ball.covariance, not_a_number);
  return data;
}

std::vector<regista_task> tasks_for(std::vector<regista_task> tasks, const Showing& showing) {
  if (!hides(showing, REGISTA_READS_FACINGS)) return tasks;
  for (regista_task& each : tasks) each.before[2] = each.after[2] = not_a_number;
  return tasks;
}

}  // namespace

struct Scene::Stored {
  struct World {
    // hides_opponents: this world's are not among what the plugin reads.
    World(const WorldData& data, const Layout& layout, bool hides_opponents)
        : robots(data.robots, layout),
          opponents(data.opponents, layout),
          game(data.game, layout),
          ball(data.ball, layout) {
      if (hides_opponents) opponents.hide();
      std::vector<std::int32_t> numbers;
      for (const regista_robot& robot : data.robots) {
        if (robot.flags & REGISTA_ROBOT_ACTIVE) numbers.push_back(robot.number);
      }
      active = Strided<std::int32_t>(numbers, layout);
      regista_world raw{};
      raw.game = &game.get();
      raw.ball = &ball.get();
      raw.robots = robots.span();
      raw.opponents = opponents.span();
      raw.active = active.span();
      world = Grown<regista_world>(raw, layout);
      game.make_read_only();
      ball.make_read_only();
      world.make_read_only();
    }
    bool unchanged() const {
      return robots.unchanged() && opponents.unchanged() && active.unchanged() && game.unchanged() &&
             ball.unchanged() && world.unchanged();
    }
    Strided<regista_robot> robots;
    Strided<regista_opponent> opponents;
    Strided<std::int32_t> active;
    Grown<regista_game> game;
    Grown<regista_ball> ball;
    Grown<regista_world> world;
  };

  Stored(SceneData from, const Showing& showing)
      : data(std::move(from)),
        mine(world_for(data.mine, showing), showing.layout, hides(showing, REGISTA_READS_OPPONENTS_MINE)),
        common(world_for(data.common, showing), showing.layout, hides(showing, REGISTA_READS_OPPONENTS_COMMON)),
        tasks(tasks_for(data.tasks, showing), showing.layout),
        waypoints(data.waypoints, showing.layout),
        edges(data.edges, showing.layout),
        previous(data.previous, showing.layout) {
    if (hides(showing, REGISTA_READS_WAYPOINTS)) waypoints.hide();
    if (hides(showing, REGISTA_READS_EDGES)) edges.hide();
    if (hides(showing, REGISTA_READS_PREVIOUS)) previous.hide();
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
    if (data.has_times) raw.time_to_task = fill_times(showing);
    frame = Grown<regista_frame>(raw, showing.layout);
    frame.make_read_only();
  }
  Stored(const Stored&) = delete;
  Stored& operator=(const Stored&) = delete;

  // Straight line at walking speed, after getting up.
  regista_matrix fill_times(const Showing& showing) {
    const regista::World world(data.knowledge == REGISTA_COMMON ? common.world.get() : mine.world.get());
    const std::size_t rows = world.active().size(), columns = data.tasks.size();
    const std::size_t stride = columns + showing.layout.growth / sizeof(double);
    std::vector<double> values(rows * stride, not_a_number);
    for (std::size_t i = 0; i < rows; ++i) {
      const regista_robot& robot = world.robot(world.active()[i]);
      for (std::size_t j = 0; j < columns; ++j) {
        const double* to = data.tasks[j].after;
        values[i * stride + j] =
            std::hypot(to[0] - robot.pose[0], to[1] - robot.pose[1]) / data.walk_speed + robot.time_until_up;
      }
    }
    const bool hidden = hides(showing, REGISTA_READS_TIMES);
    if (hidden) values.assign(values.size(), not_a_number);
    times = Strided<double>(values, {0, showing.layout.guarded});
    const auto* const first = static_cast<const double*>(times.span().data);
    if (hidden) return {first, 0, 0, static_cast<std::uint32_t>(stride), 0};
    return {first, static_cast<std::uint32_t>(rows), static_cast<std::uint32_t>(columns),
            static_cast<std::uint32_t>(stride), 0};
  }

  SceneData data;
  World mine, common;
  Strided<regista_task> tasks;
  Strided<regista_waypoint> waypoints;
  Strided<regista_edge> edges;
  Strided<std::int32_t> previous;
  Strided<double> times;
  Grown<regista_frame> frame;
};

Scene::Scene(SceneData data, const Showing& showing) : stored_(std::make_shared<Stored>(std::move(data), showing)) {}

const regista_frame& Scene::raw() const { return stored_->frame.get(); }

regista::Frame Scene::frame() const { return regista::Frame(raw()); }

const std::string& Scene::name() const { return stored_->data.name; }

const SceneData& Scene::data() const { return stored_->data; }

std::uint32_t Scene::team_size() const { return static_cast<std::uint32_t>(stored_->data.mine.robots.size()); }

std::uint32_t Scene::rows() const { return static_cast<std::uint32_t>(frame().world().active().size()); }

std::uint32_t Scene::columns() const { return static_cast<std::uint32_t>(stored_->data.tasks.size()); }

Scene Scene::shown(const Showing& showing) const { return Scene(stored_->data, showing); }

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
         s.edges.unchanged() && s.previous.unchanged() && s.times.unchanged() && s.frame.unchanged();
}

}  // namespace regista::testkit
