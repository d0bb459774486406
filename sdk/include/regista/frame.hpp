// SPDX-License-Identifier: MIT
// What a plugin sees, comfortably: thin views over the structs of <regista/abi.h>. They own nothing and are valid only
// during the call that received them. Units, frames and meanings stand in abi.h.
#pragma once

#include <cassert>
#include <cstddef>
#include <iterator>
#include <stdexcept>
#include <string>
#include <string_view>

#include <regista/abi.h>

namespace regista {

using Landmark = regista_landmark;
using Role = regista_role;
using Game = regista_game;
using Robot = regista_robot;
using Opponent = regista_opponent;
using Ball = regista_ball;
using Task = regista_task;
using Waypoint = regista_waypoint;
using Edge = regista_edge;
using Vertex = regista_vertex;

// Elements that may be larger than this header knows: steps by the stride that came with them.
template <class T>
class Span {
 public:
  class iterator {
   public:
    using iterator_category = std::forward_iterator_tag;
    using value_type = T;
    using difference_type = std::ptrdiff_t;
    using pointer = const T*;
    using reference = const T&;
    iterator() = default;
    iterator(const char* at, std::size_t stride) : at_(at), stride_(stride) {}
    const T& operator*() const { return *reinterpret_cast<const T*>(at_); }
    const T* operator->() const { return reinterpret_cast<const T*>(at_); }
    iterator& operator++() { return at_ += stride_, *this; }
    iterator operator++(int) {
      iterator before = *this;
      ++*this;
      return before;
    }
    friend bool operator==(const iterator& a, const iterator& b) { return a.at_ == b.at_; }

   private:
    const char* at_ = nullptr;
    std::size_t stride_ = 0;
  };

  Span() = default;
  explicit Span(const regista_span& raw)
      : data_(static_cast<const char*>(raw.data)), count_(raw.count), stride_(raw.stride) {
    assert(count_ == 0 || stride_ >= sizeof(T));
  }
  std::size_t size() const { return count_; }
  bool empty() const { return count_ == 0; }
  const T& operator[](std::size_t i) const {
    assert(i < count_);
    return *reinterpret_cast<const T*>(data_ + i * stride_);
  }
  iterator begin() const { return {data_, stride_}; }
  iterator end() const { return {data_ + count_ * stride_, stride_}; }

 private:
  const char* data_ = nullptr;
  std::size_t count_ = 0, stride_ = 0;
};

// Room for elements that may be larger than this header knows.
template <class T>
class Room {
 public:
  explicit Room(regista_room& raw) : raw_(&raw) { assert(raw.capacity == 0 || raw.stride >= sizeof(T)); }
  std::size_t capacity() const { return raw_->capacity; }
  std::size_t size() const { return raw_->count; }
  // The next element, as it stands in memory. `what`: of the elements, for the exception when the room is full.
  T& add(const char* what) const {
    if (raw_->count >= raw_->capacity)
      throw std::length_error(std::string("more ") + what + " than the host has room for");
    return *reinterpret_cast<T*>(static_cast<char*>(raw_->data) + std::size_t{raw_->count++} * raw_->stride);
  }

 private:
  regista_room* raw_;
};

// One consistent picture of the game.
class World {
 public:
  explicit World(const regista_world& raw) : raw_(&raw) {}
  const Game& game() const { return *raw_->game; }
  const Ball& ball() const { return *raw_->ball; }
  bool ball_known() const { return (raw_->ball->flags & REGISTA_BALL_KNOWN) != 0; }
  Span<Robot> robots() const { return Span<Robot>(raw_->robots); }
  const Robot& robot(int number) const { return robots()[static_cast<std::size_t>(number - 1)]; }
  Span<Opponent> opponents() const { return Span<Opponent>(raw_->opponents); }
  // Numbers of the active robots, ascending: the rows of every matrix.
  Span<std::int32_t> active() const { return Span<std::int32_t>(raw_->active); }

 private:
  const regista_world* raw_;
};

// One decision of one robot.
class Frame {
 public:
  explicit Frame(const regista_frame& raw) : raw_(&raw) {}
  double time() const { return raw_->time; }
  std::uint64_t tick() const { return raw_->tick; }
  int own_number() const { return raw_->own_number; }
  int context() const { return raw_->context; }
  World mine() const { return World(*raw_->mine); }
  World common() const { return World(*raw_->common); }
  // The one of the two that the team's YAML wants this call to be computed on.
  World world() const { return World(raw_->knowledge == REGISTA_COMMON ? *raw_->common : *raw_->mine); }
  Span<Task> tasks() const { return Span<Task>(raw_->tasks); }
  Span<Waypoint> waypoints() const { return Span<Waypoint>(raw_->waypoints); }
  Span<Edge> edges() const { return Span<Edge>(raw_->edges); }
  // Task id that robot `number` had in this robot's last assignment, -1 = none.
  int previous_task(int number) const {
    const Span<std::int32_t> all(raw_->previous);
    const auto index = static_cast<std::size_t>(number - 1);
    // Checked in every build: who does not declare that it reads them gets none.
    if (index >= all.size()) throw std::out_of_range("previous tasks are not declared, or there is no such robot");
    return all[index];
  }
  // Seconds that the robot of this row needs to the task of this column.
  double time_to_task(std::size_t row, std::size_t column) const {
    const regista_matrix& m = raw_->time_to_task;
    if (row >= m.rows || column >= m.columns) throw std::out_of_range("times are not declared, or there are none such");
    return m.values[row * m.stride + column];
  }
  const regista_frame& raw() const { return *raw_; }

 private:
  const regista_frame* raw_;
};

// The fixed facts, given at create.
class Environment {
 public:
  explicit Environment(const regista_environment& raw) : raw_(&raw) {}
  const regista_environment* operator->() const { return raw_; }
  const regista_environment& raw() const { return *raw_; }
  Span<Landmark> landmarks() const { return Span<Landmark>(raw_->landmarks); }
  Span<Role> roles() const { return Span<Role>(raw_->roles); }
  Span<regista_kick> kicks() const { return Span<regista_kick>(raw_->kicks); }
  Span<regista_event_name> events() const { return Span<regista_event_name>(raw_->events); }

 private:
  const regista_environment* raw_;
};

}  // namespace regista
