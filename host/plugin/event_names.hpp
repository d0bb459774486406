// SPDX-License-Identifier: MIT
// What events and reasons of packets are called, by REGISTA_EVENT_*.
#pragma once

#include <array>

#include <regista/abi.h>

namespace regista::plugin {

inline constexpr std::array<const char*, REGISTA_EVENT_COUNT> event_names{
    "period",     "whistle", "ball_found", "goalkeeper_saw_ball", "ball_known_again", "role_changed", "ball_moved",
    "pose_moved", "fell",    "got_up",     "phase_changed",       "context_changed",  "returned",     "offer"};

}  // namespace regista::plugin
