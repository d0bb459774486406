// SPDX-License-Identifier: MIT
// The disturbance profile: what goes wrong on top of ordinary noise, off by default. It grows with the game.
#pragma once

#include <string>

namespace regista::config {

struct Disturbance {
  std::string name = "none";
  double extra_packet_loss = 0.0;  // probability per packet and receiver
  double extra_delay = 0.0;        // s
  double ball_blindness = 0.0;     // probability that a sighting of the ball is lost
};

}  // namespace regista::config
