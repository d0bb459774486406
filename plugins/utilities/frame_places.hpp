// SPDX-License-Identifier: MIT
// Reads from the host's frame where robots and targets are. Glue of several plugins.
#pragma once

#include <cstddef>
#include <type_traits>
#include <vector>

#include <regista/frame.hpp>

#include "places.hpp"

namespace places {

// The world's active robots, Points or Poses, in the order of the matrix's rows. Writes over `robots`.
template <class Place>
void read_robots(const regista::World& world, std::vector<Place>& robots) {
  robots.clear();
  for (const int number : world.active()) {
    const regista::Robot& robot = world.robot(number);
    if constexpr (std::is_same_v<Place, Pose>) {
      robots.push_back({robot.pose[0], robot.pose[1], robot.pose[2]});
    } else {
      robots.push_back({robot.pose[0], robot.pose[1]});
    }
  }
}

// Keeps the coordinates of the targets, one for each column of the matrix.
class TargetList {
 public:
  void reserve(std::size_t most) {
    x_.reserve(most);
    y_.reserve(most);
  }
  // Where the tasks are after their offset.
  void read_tasks(const regista::Frame& frame) {
    x_.clear();
    y_.clear();
    for (const regista::Task& task : frame.tasks()) {
      x_.push_back(task.after[0]);
      y_.push_back(task.after[1]);
    }
  }
  // One place for all tasks.
  void repeat(const Point& place, std::size_t count) {
    x_.assign(count, place.x);
    y_.assign(count, place.y);
  }
  std::size_t size() const { return x_.size(); }
  operator Targets() const { return {x_, y_}; }

 private:
  std::vector<double> x_, y_;
};

}  // namespace places
