// SPDX-License-Identifier: MIT
// A behaviour acts: from what the robot believes, its task and its body to motion, kick and gaze. The class has
//
//   void act(const regista::Frame&, const regista::Body&, regista::Action& out);
//
// and, for those who count,
//
//   static constexpr unsigned purposes = REGISTA_BEHAVIOUR_PLAYS_BALL;     or-ed; none when absent
//
// On entry `out` stands and looks ahead.
#pragma once

#include <stdexcept>

#include <regista/plugin.hpp>

namespace regista {

using Kick = regista_kick;
using Point = regista_point;
using Action = regista_action;

// The own body.
class Body {
 public:
  explicit Body(const regista_body& raw) : raw_(&raw) {}
  const regista_body* operator->() const { return raw_; }
  bool is(std::uint32_t flag) const { return (raw_->flags & flag) != 0; }
  // The own task, null when there is none.
  const Task* task(const Frame& frame) const {
    return raw_->task < 0 ? nullptr : &frame.tasks()[static_cast<std::size_t>(raw_->task)];
  }
  Span<Point> robots_near() const { return Span<Point>(raw_->robots_near); }

 private:
  const regista_body* raw_;
};

// A disc to walk around.
inline void avoid(Action& action, double x, double y, double radius) {
  if (action.avoid_count == REGISTA_MOST_AVOIDED) throw std::length_error("more discs to avoid than there is room for");
  action.avoid[action.avoid_count++] = {x, y, radius};
}

#pragma GCC visibility push(hidden)  // see plugin.hpp
struct behaviour {
  static constexpr std::int32_t kind = REGISTA_KIND_BEHAVIOUR;

  template <class Class>
  static constexpr std::uint32_t purposes() {
    if constexpr (requires { Class::purposes; }) {
      return Class::purposes;
    } else {
      return 0;
    }
  }

  template <class Class>
  static const void* table() {
    static constexpr regista_behaviour calls{
        sizeof(regista_behaviour), purposes<Class>(),
        [](void* instance, const regista_frame* frame, const regista_body* body, Action* out, regista_error* error) {
          return detail::guarded(error, [&] { static_cast<Class*>(instance)->act(Frame(*frame), Body(*body), *out); });
        }};
    return &calls;
  }
};
#pragma GCC visibility pop

}  // namespace regista
